// A polynomial's surface by its frustum form: whole pictures block by block, other rays one by one.
#pragma once

#include <isocast/implicit/expression/tape.h>
#include <isocast/implicit/frustum/kernels.h>
#include <isocast/implicit/segment_solver.h>
#include <isocast/isa/cpu.h>
#include <isocast/math/box.h>
#include <isocast/ray/primary_pass.h>

#include <memory>
#include <optional>
#include <vector>

namespace isocast {

class Surface;
class View;

/// degree     of f in x, y and z, at most kMostPolynomialDegree
/// finder     its eps is a share of the depth that a block, or a ray on its own, has in the domain
/// proves     whether hits and misses come with proofs; above degree kMostFormDegree they are undecided then
/// normals    hits of a pass carry the normals of its form (form_normal)
/// device     what solves all rays, each by its own polynomial, if not this processor
struct FrustumOptions {
  int degree = 0;
  std::vector<double> iso;
  double time = 0;
  FinderOptions finder;
  FrustumPrecision precision = FrustumPrecision::single;
  bool proves = true, normals = false;
  Isa isa = widest_isa();
  std::uint16_t object = 0;
  std::shared_ptr<const FormulaDevice> device = {};
};

/// The normal that a hit carries, which may point to either side; nothing where it has none.
[[nodiscard]] std::optional<Double3> form_normal(const HitStream& hits, int slot);

/// Rays of a picture of which a form proves nothing, or whose root lies in a bracket longer than `longest`, a
/// distance in world space: solved by the surface's first_hit instead. No surface: they stay undecided.
struct DoubtfulRays {
  const Surface* surface = nullptr;
  double longest = 0;
};

/// source  Reimers, Seland: Ray casting algebraic surfaces using the frustum form, Computer Graphics Forum
///         27(2), 2008. That the form is made block by block, of a degree that suffices there, is divided
///         down to tiles and cut to the depths where it may vanish, and that its signs prove what they do, is
///         ours.
class FrustumTracer {
 public:
  FrustumTracer(const Tape& tape, const Box& domain, const FrustumOptions& options);

  /// Null with a device, above degree kMostFormDegree, and where the domain is seen too small for forms; must
  /// outlive neither the tracer nor the view.
  [[nodiscard]] std::unique_ptr<PrimaryPass> primary(const View& view,
                                                     const DoubtfulRays& doubtful = {}) const;

  /// As Surface::first_hit, or Surface::next_hit, for many streams: hits[i] belongs to rays[i]. Each ray's
  /// polynomial comes from values along it; above degree kMostFormDegree it comes in parts.
  void trace(bool next, std::span<const RayStream> rays, std::span<HitStream* const> hits,
             TraceCounts& counts) const;

 private:
  struct Traced;
  [[nodiscard]] RayFormQuery ray_query() const;
  void begin(bool next, const RayStream& rays, HitStream& hits, Traced& traced) const;
  [[nodiscard]] bool set_part(int part, Traced& traced, TraceCounts& counts) const;
  void take_roots(Traced& traced, HitStream& hits) const;
  void solve(std::span<Traced* const> streams) const;

  Tape tape_;
  Box domain_;
  FrustumOptions options_;
  std::unique_ptr<const RayFormSolver> solver_;  // of the device
};

}  // namespace isocast
