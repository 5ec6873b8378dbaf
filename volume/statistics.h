// What the values of a volume are like: range, histogram, percentiles, and iso-values worth a first look.
#pragma once

#include <isocast/volume/volume.h>

#include <array>
#include <cstdint>
#include <vector>

namespace isocast {

/// Equal bins over [lo, hi]; the last one includes hi.
struct Histogram {
  static constexpr int kBins = 256;
  double lo = 0, hi = 0;
  std::array<std::int64_t, kBins> counts = {};
};

struct Percentile {
  double percent, value;
};

/// All values in the users' units (slope and intercept); of a sparse grid those of its active samples. NaN
/// and infinite samples are counted and otherwise left out.
///
/// min, max       of the finite values; both 0 when there are none
/// percentiles    0.1 1 5 25 50 75 95 99 99.9: the smallest value with so many percent of the values at or
///                below it; exact for integers whose range is below 65536, else within 1/65536 of the range
/// suggested_iso  best first, each strictly between min and max: 0 for level sets, Otsu's threshold of the
/// histogram, then
///                those of the percentiles 95, 75, 99, 50 and 25 that differ from min, max and all before by
///                1/64 of the range; of a constant volume the constant; empty without finite values, or where
///                no number lies between min and max
struct VolumeStatistics {
  std::int64_t finite_count = 0, nan_count = 0, infinite_count = 0;
  double min = 0, max = 0;
  Histogram histogram;
  std::array<Percentile, 9> percentiles = {};
  std::vector<double> suggested_iso;
};

/// Reads the samples twice where they are, in parallel; the result does not depend on the number of threads.
[[nodiscard]] VolumeStatistics statistics_of(const Volume& volume);

/// The edge of a histogram's bin that parts its values into the two most distinct classes, the middle of such
/// edges if neighbours are equally good.
///
/// source  Otsu: A threshold selection method from gray-level histograms, IEEE Trans. SMC 9(1), 1979
[[nodiscard]] double otsu_threshold(const Histogram& histogram);

}  // namespace isocast
