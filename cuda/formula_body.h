// A thread solves one ray of a formula: the solvers of implicit/solve with one slot.
#pragma once

#include <isocast/cuda/place.h>
#include <isocast/cuda/segment_work.h>
#include <isocast/implicit/solve/bisection.h>
#include <isocast/implicit/solve/marching_points.h>
#include <isocast/implicit/solve/polish.h>

namespace isocast::inline ISO_ISA {

static_assert(kSlots == 1, "formula_body.h is for builds with ISO_ONE_RAY");

/// Bytes for each register of a method's tape.
template <class Method, class T>
inline constexpr std::size_t kRegisterBytes = Method::kRegisterBytes > sizeof(Gradient<T>)
                                                  ? Method::kRegisterBytes
                                                  : sizeof(Gradient<T>);

/// Method: Bisection or MarchingPoints over T. `registers` has room for the tape's; a formula that is
/// compiled in needs one, for its value.
template <class Method, class T>
ISO_HD inline void solve_segment(const SegmentWork<T>& work, const Place& place, void* registers) {
  const std::int64_t stream = place.number() / kStreamSize;
  const int i = int(place.number() % kStreamSize);
  if (stream >= work.streams || i >= work.segments[stream].size) return;
  const SegmentStream<T>& segments = work.segments[stream];
  SegmentRoots<T>& roots = work.roots[stream];
  Method(work.query, segments, roots, {i, i + 1}, registers).run();
  polish<T>(work.query, segments, roots, {i, i + 1}, registers);
}

// the order of FormulaMethod: mitchell and interval_newton are interval with other options
template <class T> using IntervalSolver = Bisection<Interval<T>, T>;
template <class T> using AffineSolver = Bisection<AffineForm<T, 1>, T>;
template <class T> using AmpSignSolver = MarchingPoints<false, T>;
template <class T> using AmpTaylorSolver = MarchingPoints<true, T>;

}  // namespace isocast::inline ISO_ISA
