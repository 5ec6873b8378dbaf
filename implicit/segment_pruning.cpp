#include <isocast/implicit/expression/prune.h>
#include <isocast/implicit/segment_pruning.h>
#include <isocast/implicit/tape_cost.h>

#include <algorithm>

namespace isocast {

PruningPlan plan_pruning(const Tape& tape, const Box& domain, double time, std::span<const double> levels) {
  const bool chooses = std::ranges::any_of(tape.code, [](const Instruction& i) {
    return i.op == Op::min || i.op == Op::max || i.op == Op::choose;
  });
  if (!chooses) return {};
  // a share of the small boxes, none in line with another
  constexpr int kBoxes = 8, kStride = 19, kParts = 8;
  double left = 0;
  int boxes = 0;
  Pruner<float> pruner;
  for (int n = 0; n < kBoxes * kBoxes * kBoxes; n += kStride) {
    const int place[3] = {n % kBoxes, n / kBoxes % kBoxes, n / (kBoxes * kBoxes)};
    Interval<double> box[3];
    for (std::size_t a = 0; a < 3; ++a) {
      const double edge = (domain.hi[a] - domain.lo[a]) / kBoxes, lo = domain.lo[a] + place[a] * edge;
      box[a] = Interval<double>(lo, lo + edge);
    }
    left += tape_cost(pruner.prune(tape, box, time, levels), false);
    ++boxes;
  }
  const double share = left / boxes / tape_cost(tape, false);
  return {share < 0.9, share < 0.75 ? kParts : 1};
}

template <class T>
const Tape& pruned_along(const SegmentStream<T>& segments, const Tape& tape, double time,
                         std::span<const double> levels) {
  Interval<double> box[3];
  for (int a = 0; a < 3; ++a) {
    double lo = kInfinity<double>, hi = -lo;
    for (int i = 0; i < segments.size; ++i) {
      if (!segments.active[i]) continue;
      const double e = segments.e[a][i], f = e + segments.d[a][i], slack = 2.0 * segments.slack[a][i];
      lo = std::min({lo, e - slack, f - slack}), hi = std::max({hi, e + slack, f + slack});
    }
    box[a] = Interval<double>(lo, hi);
  }
  thread_local Pruner<T> pruner;
  return pruner.prune(tape, box, time, levels);
}

const Tape& pruned_around(const GradientStream& points, const Tape& tape, double time) {
  Interval<double> box[3];
  for (int a = 0; a < 3; ++a) {
    const auto [lo, hi] = std::minmax_element(points.position[a], points.position[a] + points.size);
    box[a] = Interval<double>(*lo, *hi);
  }
  thread_local Pruner<float> pruner;
  return pruner.prune(tape, box, time);
}

template const Tape& pruned_along(const SegmentStream<float>&, const Tape&, double, std::span<const double>);
template const Tape& pruned_along(const SegmentStream<double>&, const Tape&, double, std::span<const double>);

}  // namespace isocast
