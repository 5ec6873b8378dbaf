// Error against condition: how ill-posed a root is, and what a method makes of it.
#pragma once

#include <isocast/apps/bench/picture_truth.h>

#include <span>
#include <string>
#include <vector>

namespace isocast::bench {

/// Rays whose first crossing has a condition in [10^decade, 10^(decade + 1)); the last bin holds those above,
/// too. Errors are of t, in units, over the right hits: their median and maximum.
struct ConditionBin {
  int decade;
  std::int64_t rays = 0, failures = 0;
  double p50 = 0, max = 0;
};
inline constexpr int kFirstDecade = -2, kLastDecade = 8;

/// Bins with rays only, in order.
struct ConditionCurve {
  std::string method, precision;
  std::vector<ConditionBin> bins;
};

[[nodiscard]] std::vector<ConditionBin> condition_bins(const PictureTruth& truth,
                                                       std::span<const PixelAnswer> answers);

}  // namespace isocast::bench
