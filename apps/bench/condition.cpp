#include <isocast/apps/bench/condition.h>

#include <algorithm>
#include <cmath>

namespace isocast::bench {
namespace {

int decade_of(double condition) {
  const double decade = std::floor(std::log10(condition));
  return static_cast<int>(std::clamp<double>(decade, kFirstDecade, kLastDecade));
}

}  // namespace

std::vector<ConditionBin> condition_bins(const PictureTruth& truth, std::span<const PixelAnswer> answers) {
  constexpr int kBins = kLastDecade - kFirstDecade + 1;
  ConditionBin all[kBins] = {};
  std::vector<double> errors[kBins];
  for (std::size_t pixel = 0; pixel < answers.size(); ++pixel) {
    const reference::RayRoot* const first = first_crossing(truth.rays[pixel]);
    if (!first || !truth.rays[pixel].decided()) continue;
    const int b = decade_of(first->condition) - kFirstDecade;
    ++all[b].rays;
    if (answers[pixel].verdict == Verdict::hit) errors[b].push_back(answers[pixel].t_error);
    else ++all[b].failures;
  }

  std::vector<ConditionBin> bins;
  for (int b = 0; b < kBins; ++b) {
    if (all[b].rays == 0) continue;
    bins.push_back(
        {b + kFirstDecade, all[b].rays, all[b].failures, quantile(errors[b], 0.5), quantile(errors[b], 1)});
  }
  return bins;
}

}  // namespace isocast::bench
