#include <fmt/format.h>
#include <isocast/apps/viewer/iso_choices.h>

#include <algorithm>
#include <numeric>

namespace isocast::viewer {

std::vector<IsoChoice> iso_choices(const VolumeStatistics& statistics) {
  std::vector<IsoChoice> choices;
  const auto offer = [&](std::string name, double value) {
    if (!(value > statistics.min && value < statistics.max)) return;
    const auto same = std::ranges::find(choices, value, &IsoChoice::value);
    if (same == choices.end()) choices.push_back({std::move(name), value});
    else same->name += ", " + name;
  };
  if (!statistics.suggested_iso.empty()) offer("Best", statistics.suggested_iso.front());
  offer("Otsu", otsu_threshold(statistics.histogram));
  for (const Percentile& p : statistics.percentiles) offer(fmt::format("{} %", p.percent), p.value);
  return choices;
}

double enclosing_iso(const Histogram& histogram, double percent) {
  const double all = std::accumulate(histogram.counts.begin(), histogram.counts.end(), 0.0),
               wanted = all * std::clamp(percent, 0.0, 100.0) / 100,
               width = (histogram.hi - histogram.lo) / Histogram::kBins;
  double above = 0;
  for (int bin = Histogram::kBins - 1; bin >= 0; --bin) {
    const auto count = static_cast<double>(histogram.counts[static_cast<std::size_t>(bin)]);
    if (count > 0 && above + count >= wanted)
      return histogram.lo + width * (bin + 1 - (wanted - above) / count);
    above += count;
  }
  return histogram.lo;
}

}  // namespace isocast::viewer
