#include <isocast/apps/bench/stress_judge.h>

#include <algorithm>
#include <cmath>

namespace isocast::bench {
namespace {

using reference::RayTruth;

bool well_formed(double lo, double middle, double hi) {
  return std::isfinite(lo) && std::isfinite(hi) && lo <= middle && middle <= hi && middle >= 0;
}

// Doubts of the reference are in the proof's favour.
bool contradicts(const RayTruth& truth, double lo, double hi, int iso) {
  bool inside = std::ranges::any_of(truth.doubts, [&](const auto& doubt) { return doubt.lo <= hi; });
  for (const reference::RayRoot& root : truth.roots) {
    if (root.from_above) continue;
    if (root.hi < lo) return true;
    inside |= root.iso == iso && root.lo <= hi;
  }
  return !inside;
}

bool contradicts(const reference::CellReference& truth, const Answer& answer) {
  bool inside = false;
  for (const reference::CellRoot& root : std::span(truth.roots, truth.root_count)) {
    if (!answer.hit || root.s < answer.s_lo) return true;
    inside |= root.crossing && root.s <= answer.s_hi;
  }
  return truth.zero || answer.hit != inside;
}

}  // namespace

StressCounts count_proofs(const PictureTruth& truth, const std::vector<RayStream>& rays,
                          const std::vector<HitStream>& hits) {
  StressCounts counts;
  each_ray(rays, [&](std::size_t s, int i) {
    const HitStream& h = hits[s];
    const RayTruth& ray = truth.rays[rays[s].id[i]];
    if (is_hit(h, i)) counts.malformed += !well_formed(h.t_lo[i], h.t[i], h.t_hi[i]);
    else counts.malformed += std::isnan(h.t[i]);
    if (h.certificate[i] == Certificate::proved_hit) {
      ++counts.hits;
      counts.false_proofs += !is_hit(h, i) || contradicts(ray, h.t_lo[i], h.t_hi[i], h.iso[i]);
    } else if (h.certificate[i] == Certificate::proved_miss) {
      ++counts.misses;
      counts.false_proofs += is_hit(h, i) || !std::ranges::all_of(ray.roots, &reference::RayRoot::from_above);
    }
  });
  return counts;
}

StressCounts count_proofs(std::span<const reference::CellReference> truth, std::span<const Answer> answers,
                          bool proves) {
  StressCounts counts;
  for (std::size_t n = 0; n < answers.size(); ++n) {
    const Answer& answer = answers[n];
    if (answer.hit) counts.malformed += !well_formed(answer.s_lo, answer.s, answer.s_hi) || answer.s_hi > 1;
    if (!proves || !answer.proved) continue;
    ++(answer.hit ? counts.hits : counts.misses);
    counts.false_proofs += contradicts(truth[n], answer);
  }
  return counts;
}

}  // namespace isocast::bench
