// What solves the segments of a formula in place of this processor's kernels.
#pragma once

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

/// Something that solves formulas: a device.
class FormulaDevice {
 public:
  virtual ~FormulaDevice() = default;
  /// Throws InputError where a formula cannot be compiled for want of a part of the system.
  [[nodiscard]] virtual std::unique_ptr<const SegmentSolver> solver_of(const SegmentSolverKey& key,
                                                                       const Tape& tape) const = 0;
};

}  // namespace isocast
