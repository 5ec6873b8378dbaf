#include <isocast/apps/bench/judge.h>

#include <algorithm>
#include <cmath>

namespace isocast::bench {

Judgement judge(const reference::CellReference& reference, bool hit, double s) {
  const auto first = first_crossing(reference);
  if (!hit) return {first ? Verdict::false_miss : Verdict::miss, 0};
  if (!first) return {Verdict::false_hit, 0};
  const auto distance = [&](const reference::CellRoot& root) { return std::abs(s - root.s); };
  const auto nearest =
      std::min_element(reference.roots, reference.roots + reference.root_count,
                       [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  const bool is_first = distance(*nearest) == distance(*first);
  return {is_first ? Verdict::hit : Verdict::wrong_root, static_cast<double>(distance(*first))};
}

}  // namespace isocast::bench
