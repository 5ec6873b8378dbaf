#include <isocast/apps/bench/judge.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace isocast::bench {
namespace {

// Holds an answer against the roots of a chord or a ray; `place` is where a root lies.
template <class Root, class Place>
Judgement judge_roots(std::span<const Root> roots, const Root* first, bool hit, double at, Place place) {
  if (!hit) return {first ? Verdict::false_miss : Verdict::miss, 0};
  if (!first) return {Verdict::false_hit, 0};
  const auto distance = [&](const Root& root) { return std::abs(at - place(root)); };
  const auto nearest = std::ranges::min_element(roots, {}, distance);
  const bool is_first = distance(*nearest) == distance(*first);
  return {is_first ? Verdict::hit : Verdict::wrong_root, static_cast<double>(distance(*first))};
}

}  // namespace

Judgement judge(const reference::CellReference& reference, bool hit, double s) {
  const auto first = first_crossing(reference);
  return judge_roots<reference::CellRoot>({reference.roots, reference.roots + reference.root_count},
                                          first ? &*first : nullptr, hit, s,
                                          [](const auto& root) { return root.s; });
}

Judgement judge(const reference::RayTruth& truth, bool hit, double t) {
  return judge_roots<reference::RayRoot>(truth.roots, first_crossing(truth), hit, t, middle);
}

const reference::RayRoot* first_crossing(const reference::RayTruth& truth) {
  const auto found = std::ranges::find_if(truth.roots, &reference::RayRoot::crossing);
  return found == truth.roots.end() ? nullptr : &*found;
}

double angle_in_degrees(const Double3& a, const Double3& b) {
  return std::atan2(length(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi;
}

}  // namespace isocast::bench
