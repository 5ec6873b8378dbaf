// Tapes without what they do not need where the rays of a stream run, or hit.
#pragma once

#include <isocast/implicit/expression/tape.h>
#include <isocast/implicit/solve/kernels.h>
#include <isocast/implicit/solve/segment.h>
#include <isocast/math/box.h>

#include <span>

namespace isocast {

/// prunes  whether pruning pays
/// parts   into how many parts rays are cut for it
struct PruningPlan {
  bool prunes = false;
  int parts = 1;
};

/// From what is left of the tape in small boxes all over the domain, counted in operations.
[[nodiscard]] PruningPlan plan_pruning(const Tape& tape, const Box& domain, double time,
                                       std::span<const double> levels);

/// The tape as Pruner leaves it over the box of all active segments; good until the thread's next call.
template <class T>
[[nodiscard]] const Tape& pruned_along(const SegmentStream<T>& segments, const Tape& tape, double time,
                                       std::span<const double> levels);

/// The tape as Pruner leaves it over the box of all points, with the whole tape's values and gradients: only
/// choices without a tie are decided. Good until the thread's next call.
[[nodiscard]] const Tape& pruned_around(const GradientStream& points, const Tape& tape, double time);

}  // namespace isocast
