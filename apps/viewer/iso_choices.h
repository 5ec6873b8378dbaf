// Iso-values that the histogram offers.
#pragma once

#include <isocast/volume/statistics.h>

#include <string>
#include <vector>

namespace isocast::viewer {

struct IsoChoice {
  std::string name;
  double value;
};

/// Otsu's threshold (or the best of suggested_iso) and percentiles, those that lie strictly between the least
/// and the greatest value, without repetitions.
[[nodiscard]] std::vector<IsoChoice> iso_choices(const VolumeStatistics& statistics);

/// The iso-value that `percent` of the values reach or exceed, linear inside a bin; clamped to the range.
[[nodiscard]] double enclosing_iso(const Histogram& histogram, double percent);

}  // namespace isocast::viewer
