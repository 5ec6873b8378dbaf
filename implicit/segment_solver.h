// What solves the rays of a formula in place of this processor's kernels.
#pragma once

#include <isocast/implicit/beams/beam_caster.h>
#include <isocast/implicit/frustum/ray_query.h>
#include <isocast/implicit/solve/kernels.h>

#include <memory>
#include <span>

namespace isocast {

struct Tape;

/// Calls are const and may come from any thread.
class SegmentSolver {
 public:
  virtual ~SegmentSolver() = default;
  /// FormulaSolver::solve for many streams: roots[i] belongs to segments[i]. The query has the tape and the
  /// number of iso-values that the solver was made for.
  virtual void solve(const FormulaQuery<float>& query, std::span<const SegmentStream<float>* const> segments,
                     std::span<SegmentRoots<float>* const> roots) const = 0;
  virtual void solve(const FormulaQuery<double>& query,
                     std::span<const SegmentStream<double>* const> segments,
                     std::span<SegmentRoots<double>* const> roots) const = 0;
};

/// What a solver is made for: `method` one of the first kSolverCount, `nearest` as in formula_kernels.
struct SegmentSolverKey {
  FormulaMethod method;
  bool double_precision, nearest;
  int iso_count;
  friend bool operator==(const SegmentSolverKey&, const SegmentSolverKey&) = default;
};

/// FrustumKernels::solve_rays for many streams: roots[i] belongs to rays[i]. The query has the tape and the
/// key's numbers that the solver was made for. Calls are const and may come from any thread.
class RayFormSolver {
 public:
  virtual ~RayFormSolver() = default;
  virtual void solve(const RayFormQuery& query, std::span<const RayFormStream* const> rays,
                     std::span<RayFormRoots* const> roots) const = 0;
};

/// single: roots in float; degree: of the rays' polynomials.
struct RayFormKey {
  RootFinder finder;
  bool single;
  int degree, iso_count;
};

/// Something that solves formulas: a device.
class FormulaDevice {
 public:
  virtual ~FormulaDevice() = default;
  /// Throws InputError where a formula cannot be compiled for want of a part of the system.
  [[nodiscard]] virtual std::unique_ptr<const SegmentSolver> solver_of(const SegmentSolverKey& key,
                                                                       const Tape& tape) const = 0;
  [[nodiscard]] virtual std::unique_ptr<const RayFormSolver> ray_form_solver_of(const RayFormKey& key,
                                                                                const Tape& tape) const = 0;
  [[nodiscard]] virtual std::unique_ptr<const BeamCaster> beam_caster_of(const BeamCastKey& key,
                                                                         const Tape& tape) const = 0;
};

}  // namespace isocast
