// The iso-surfaces of one formula, as the renderer sees them.
#pragma once

#include <isocast/implicit/components.h>
#include <isocast/implicit/expression/degree.h>
#include <isocast/implicit/expression/domain.h>
#include <isocast/implicit/expression/tape.h>
#include <isocast/implicit/frustum/frustum_tracer.h>
#include <isocast/implicit/methods.h>
#include <isocast/implicit/segment_pruning.h>
#include <isocast/implicit/segment_solver.h>
#include <isocast/implicit/solve/kernels.h>
#include <isocast/isa/cpu.h>
#include <isocast/ray/surface.h>

#include <optional>
#include <vector>

namespace isocast {

struct FormulaPassInputs;
struct TracedRay;
template <class T> struct TracedPart;

/// iso         1 to kMostIsos values
/// time        the variable w
/// normals     difference: over a stencil tied to the method's eps (FormulaMethodChoice)
/// components  hits say which operand of the formula's min and max was hit; as the surface is made, for good
/// mixed_precision  of frustum methods, without double_precision: polynomials in double, roots in float
/// object      number of the object in its scene
/// device      what solves rays and casts beams, if not this processor: rays one by one, without pruning
struct ImplicitSurfaceOptions {
  std::vector<double> iso = {0};
  double time = 0;
  NormalKind normals = NormalKind::gradient;
  bool components = false;
  FormulaMethodChoice method;
  bool double_precision = false, mixed_precision = false;
  Isa isa = widest_isa();
  std::uint16_t object = 0;
  std::shared_ptr<const FormulaDevice> device = {};
};

/// f(x, y, z, w = time) = iso inside a box. Grid-free: nothing is built but the tape; other options rebuild
/// nothing.
///
/// proofs  of the parsed formula along the ray through the stored bits of o and d, clipped to the box: a
///         proved hit has a root in [t_lo, t_hi] and none before, a proved miss none at all (design.md,
///         decisions 2 and 3)
class ImplicitSurface final : public Surface {
 public:
  /// Throws InputError for a box that is empty or not finite, and for options that cannot be used: frustum
  /// methods need a polynomial.
  ImplicitSurface(const Expression& expression, const Domain& domain, const ImplicitSurfaceOptions& options);

  void set_options(const ImplicitSurfaceOptions& options);

  /// 0 where components were not asked for.
  [[nodiscard]] int component_count() const { return components_ ? components_->count() : 0; }
  [[nodiscard]] Box bounds() const override { return bounds_; }
  [[nodiscard]] bool proves() const override { return options_.method.proves(); }
  [[nodiscard]] std::unique_ptr<PrimaryPass> primary(const View& view) const override;
  /// Whether certified takes the frustum form for its pictures, where that sees the domain large enough, and
  /// not the tree of beams; other rays have polynomials of their own then.
  [[nodiscard]] bool takes_forms() const { return forms_ != nullptr; }
  /// Whatever the method.
  [[nodiscard]] std::unique_ptr<CoveragePass> coverage(const View& view) const override;
  void first_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const override;
  void next_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const override;
  void find_sides(const RayStream& rays, const HitStream& hits,
                  RaySides (&sides)[kStreamSize]) const override;
  void find_edges(const PixelLines& lines, std::span<const EdgeStep> steps,
                  std::span<float> shares) const override;
  void dress(const RayStream& rays, const HitStream& hits, const DressWishes& wishes,
             DressedHits& dressed) const override;

 private:
  template <class T> [[nodiscard]] FormulaQuery<T> make_query() const;
  [[nodiscard]] FormulaPassInputs pass_inputs() const;
  bool put_cheap_normals(const RayStream& rays, const HitStream& hits, DressedHits& dressed,
                         bool (&made)[kStreamSize]) const;
  [[nodiscard]] Double3 difference_normal(const Double3& p, double distance) const;
  template <class T> [[nodiscard]] const FormulaSolver<T>& solver() const;
  void begin(bool next, const RayStream& rays, HitStream& hits, TracedRay* traced) const;
  template <class T>
  void narrow(const FormulaQuery<T>& query, const RayStream& rays, TracedRay* traced,
              TraceCounts& counts) const;
  template <class T>
  [[nodiscard]] bool set_part(double end, const RayStream& rays, const TracedRay* traced,
                              TracedPart<T>& part) const;
  template <class T>
  void trace_part(const FormulaQuery<T>& whole, double end, const RayStream& rays, TracedRay* traced,
                  HitStream& hits, TraceCounts& counts) const;
  template <class T>
  void take_roots(double end, const TracedPart<T>& part, TracedRay* traced, HitStream& hits,
                  TraceCounts& counts) const;
  template <class T>
  void trace(const FormulaQuery<T>& query, bool next, const RayStream& rays, HitStream& hits,
             TraceCounts& counts) const;
  void trace_by_inclusion(bool next, const RayStream& rays, HitStream& hits, TraceCounts& counts) const;
  void trace_certified(bool next, const RayStream& rays, HitStream& hits, TraceCounts& counts) const;
  void find_hit(bool next, const RayStream& rays, HitStream& hits, TraceCounts& counts) const;
  template <class T>
  void trace_on_device(const FormulaQuery<T>& query, bool next, std::span<const RayStream> rays,
                       std::span<HitStream* const> hits, TraceCounts& counts) const;
  void trace_on_device(bool next, std::span<const RayStream> rays, std::span<HitStream* const> hits,
                       TraceCounts& counts) const;
  void use_device();
  template <class T>
  [[nodiscard]] std::unique_ptr<PrimaryPass> device_pass(const View& view,
                                                         const FormulaQuery<T>& query) const;

  void set_components(const RayStream& rays, HitStream& hits) const;
  [[nodiscard]] bool forms_suit(const PolynomialDegree& degree) const;
  void prepare_frustum();
  [[nodiscard]] bool has_form_normals() const {
    return options_.method.form_normals && options_.normals != NormalKind::difference;
  }

  std::optional<Components> components_;
  Tape tape_;
  double gradient_;  // median of its length, probed
  Box bounds_;
  ImplicitSurfaceOptions options_;
  FormulaQuery<float> float_query_ = {};
  FormulaQuery<double> double_query_ = {};
  PruningPlan pruning_;
  double eps_ = 0, shadow_eps_ = 0;
  std::shared_ptr<const FrustumTracer> frustum_;  // of frustum methods
  std::shared_ptr<const FrustumTracer> forms_;    // of certified, where it takes them
  std::shared_ptr<const FormulaDevice> device_;   // what comes next is for, with their keys
  SegmentSolverKey solver_key_ = {};
  BeamCastKey beam_key_ = {};
  std::unique_ptr<const SegmentSolver> segment_solver_;
  std::unique_ptr<const BeamCaster> beam_caster_;
};

}  // namespace isocast
