#include <isocast/base/interrupt.h>
#include <isocast/base/progress.h>
#include <isocast/volume/sample.h>
#include <isocast/volume/statistics.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isocast {
namespace {

// The samples of a volume as runs: for_each calls visit(first sample, count, weight) in parallel, where every
// sample of a run stands for `weight` of them.
template <class S> struct DenseSamples {
  using Sample = S;
  const Volume& volume;

  [[nodiscard]] std::int64_t steps() const { return volume.count(); }
  template <class Visit> void for_each(Progress& progress, const Visit& visit) const {
    constexpr std::int64_t kSlab = std::int64_t(1) << 20;
    const S* const samples = reinterpret_cast<const S*>(volume.samples);
    const oneapi::tbb::blocked_range<std::int64_t> all(0, volume.count(), kSlab);
    oneapi::tbb::parallel_for(all, [&](const oneapi::tbb::blocked_range<std::int64_t>& slab) {
      throw_if_interrupted();
      visit(samples + slab.begin(), slab.end() - slab.begin(), std::int64_t(1));
      progress.add(slab.end() - slab.begin());
    });
  }
};

// The active samples of a tree; tiles count for all that they fill.
template <class S> struct ActiveSamples {
  using Sample = typename SparseSample<S>::Type;
  const SparseTree& tree;

  [[nodiscard]] std::int64_t steps() const { return static_cast<std::int64_t>(tree.leaves().size()); }
  template <class Visit> void for_each(Progress& progress, const Visit& visit) const {
    const oneapi::tbb::blocked_range<std::size_t> all(0, tree.leaves().size(), 2048);
    oneapi::tbb::parallel_for(all, [&](const oneapi::tbb::blocked_range<std::size_t>& some) {
      throw_if_interrupted();
      Sample active[kLeafSamples];
      for (const SparseLeaf& leaf : tree.leaves().subspan(some.begin(), some.size())) {
        std::int64_t count = 0;
        for (int n = 0; n < kLeafSamples; ++n)
          if (leaf_active(leaf, n)) active[count++] = SparseSample<S>::of_leaf(leaf, n);
        visit(active, count, std::int64_t(1));
      }
      progress.add(static_cast<std::int64_t>(some.size()));
    });
    for (const TileBlock& block : tree.active_tiles()) {
      const Sample value = tile_value<S>(block.tile);
      visit(&value, 1, std::int64_t(1) << 3 * block.edge);
    }
  }
};

template <class Visit> decltype(auto) visit_samples(const Volume& volume, const Visit& visit) {
  if (volume.tree)
    return visit_sparse_type(volume.tree->type(),
                             [&]<class S>(SparseTag<S>) { return visit(ActiveSamples<S>{*volume.tree}); });
  return visit_sample_type(volume.type,
                           [&]<class S>(SampleTag<S>) { return visit(DenseSamples<S>{volume}); });
}

// Stored units, finite samples only.
struct StoredRange {
  double lo = std::numeric_limits<double>::infinity(), hi = -std::numeric_limits<double>::infinity();
  std::int64_t count = 0, nan_count = 0, infinite_count = 0;
};

template <class Samples> StoredRange range_of(const Samples& all, Progress& progress) {
  using S = typename Samples::Sample;
  using A = typename SampleTraits<S>::Arithmetic;
  oneapi::tbb::enumerable_thread_specific<StoredRange> partial;
  all.for_each(progress, [&](const S* samples, std::int64_t count, std::int64_t weight) {
    A lo = std::numeric_limits<A>::max(), hi = std::numeric_limits<A>::lowest();
    std::int64_t nan_count = 0, infinite_count = 0;
    for (std::int64_t i = 0; i < count; ++i) {
      const A v = number(samples[i]);
      if constexpr (std::is_floating_point_v<A>) {
        nan_count += v != v;
        infinite_count += std::isinf(v);
        if (!std::isfinite(v)) continue;
      }
      lo = std::min(lo, v);
      hi = std::max(hi, v);
    }
    StoredRange& range = partial.local();
    range.count += count * weight;
    range.nan_count += nan_count * weight;
    range.infinite_count += infinite_count * weight;
    if (nan_count + infinite_count == count) return;
    range.lo = std::min(range.lo, double(lo));
    range.hi = std::max(range.hi, double(hi));
  });
  StoredRange total;
  for (const StoredRange& range : partial) {
    total.lo = std::min(total.lo, range.lo);
    total.hi = std::max(total.hi, range.hi);
    total.count += range.count;
    total.nan_count += range.nan_count;
    total.infinite_count += range.infinite_count;
  }
  return total;
}

// Counts in many bins between lo and hi (lo < hi), in stored units: one bin a value where these are few
// integers, each at position bin / (bins - 1) of the range; else equal intervals, at their centres.
struct FineHistogram {
  static constexpr std::size_t kMostBins = 65536;
  double lo = 0, hi = 0;
  bool one_bin_a_value = false;
  std::vector<std::int64_t> counts;

  [[nodiscard]] double position(std::size_t bin) const {
    return one_bin_a_value ? double(bin) / double(counts.size() - 1)
                           : (double(bin) + 0.5) / double(counts.size());
  }
  [[nodiscard]] double value(std::size_t bin) const {
    return one_bin_a_value ? lo + double(bin) : (1 - position(bin)) * lo + position(bin) * hi;
  }
};

template <class Samples>
FineHistogram fine_histogram(const Samples& all, double lo, double hi, Progress& progress) {
  using S = typename Samples::Sample;
  using A = typename SampleTraits<S>::Arithmetic;
  FineHistogram fine;
  fine.lo = lo;
  fine.hi = hi;
  fine.one_bin_a_value = std::is_integral_v<A> && hi - lo < double(FineHistogram::kMostBins);
  const std::size_t bins = fine.one_bin_a_value ? std::size_t(hi - lo) + 1 : FineHistogram::kMostBins;

  // halves, where the range of doubles itself overflows
  const double unit = std::isfinite(hi - lo) ? 1 : 0.5, start = lo * unit, width = hi * unit - start;
  const double scale = fine.one_bin_a_value ? 1 : double(bins) / width;
  const bool scalable = std::isfinite(scale);
  oneapi::tbb::enumerable_thread_specific<std::vector<std::int64_t>> partial(
      [&] { return std::vector<std::int64_t>(bins); });
  all.for_each(progress, [&](const S* samples, std::int64_t count, std::int64_t weight) {
    std::vector<std::int64_t>& counts = partial.local();
    for (std::int64_t i = 0; i < count; ++i) {
      const double v = double(number(samples[i]));
      if (std::is_floating_point_v<A> && !std::isfinite(v)) continue;
      const double offset = v * unit - start, bin = scalable ? offset * scale : offset / width * double(bins);
      counts[std::min(std::size_t(bin), bins - 1)] += weight;
    }
  });
  fine.counts.resize(bins);
  for (const std::vector<std::int64_t>& counts : partial)
    for (std::size_t b = 0; b < bins; ++b) fine.counts[b] += counts[b];
  return fine;
}

// The bin, counted from the smallest scaled value, that completes so many percent of all values.
std::size_t percentile_bin(const std::vector<std::int64_t>& counts, std::int64_t total, double percent) {
  const double wanted = std::max(1.0, std::ceil(percent / 100 * double(total)));
  std::size_t bin = 0;
  for (std::int64_t below = counts[0]; double(below) < wanted && bin + 1 < counts.size();
       below += counts[bin])
    ++bin;
  return bin;
}

std::vector<double> suggest(const VolumeStatistics& s) {
  if (s.finite_count == 0) return {};
  if (!(s.min < s.max)) return {s.min};
  std::vector<double> isos;
  const double otsu = otsu_threshold(s.histogram), apart = s.max / 64 - s.min / 64;
  if (otsu > s.min && otsu < s.max) isos.push_back(otsu);
  for (const int p : {6, 5, 7, 4, 3}) {
    const double iso = s.percentiles[p].value;
    const auto near = [&](double other) { return std::abs(iso - other) < apart; };
    const bool inside = iso > s.min && iso < s.max && !near(s.min) && !near(s.max);
    if (inside && std::ranges::none_of(isos, near)) isos.push_back(iso);
  }
  return isos;
}

}  // namespace

VolumeStatistics statistics_of(const Volume& volume) {
  constexpr double kPercents[] = {0.1, 1, 5, 25, 50, 75, 95, 99, 99.9};
  Progress progress("statistics", 2 * visit_samples(volume, [](const auto& all) { return all.steps(); }));
  VolumeStatistics s;
  for (std::size_t p = 0; p < s.percentiles.size(); ++p) s.percentiles[p].percent = kPercents[p];

  // the range, in the users' units: a negative slope exchanges its ends
  const StoredRange range = visit_samples(volume, [&](const auto& all) { return range_of(all, progress); });
  s.nan_count = range.nan_count;
  s.infinite_count = range.infinite_count;
  s.finite_count = range.count - s.nan_count - s.infinite_count;
  if (s.finite_count == 0) return s;
  const auto scaled = [&](double stored) { return volume.slope * stored + volume.intercept; };
  s.min = std::min(scaled(range.lo), scaled(range.hi));
  s.max = std::max(scaled(range.lo), scaled(range.hi));
  s.histogram.lo = s.min;
  s.histogram.hi = s.max;

  // a point: everything is there
  if (!(s.min < s.max)) {
    s.histogram.counts[0] = s.finite_count;
    for (Percentile& p : s.percentiles) p.value = s.min;
    s.suggested_iso = suggest(s);
    return s;
  }

  // the distribution, with the bins in the order of the users' values
  FineHistogram fine = visit_samples(
      volume, [&](const auto& all) { return fine_histogram(all, range.lo, range.hi, progress); });
  const std::size_t bins = fine.counts.size();
  const bool reversed = volume.slope < 0;
  if (reversed) std::ranges::reverse(fine.counts);
  for (std::size_t b = 0; b < bins; ++b)
    s.histogram.counts[std::min(int(fine.position(b) * Histogram::kBins), Histogram::kBins - 1)] +=
        fine.counts[b];
  for (Percentile& p : s.percentiles) {
    const std::size_t bin = percentile_bin(fine.counts, s.finite_count, p.percent);
    p.value = scaled(fine.value(reversed ? bins - 1 - bin : bin));
  }
  s.suggested_iso = suggest(s);
  // distances to a surface: the surface itself
  if (volume.grid_class == "level set" && s.min < 0 && s.max > 0) {
    std::erase(s.suggested_iso, 0.0);
    s.suggested_iso.insert(s.suggested_iso.begin(), 0.0);
  }
  return s;
}

double otsu_threshold(const Histogram& histogram) {
  // moments in bins
  double total = 0, total_moment = 0;
  for (int b = 0; b < Histogram::kBins; ++b) {
    total += double(histogram.counts[b]);
    total_moment += b * double(histogram.counts[b]);
  }

  // the variance between the classes below and above each edge
  double best = -1, weight = 0, moment = 0;
  int first = 1, last = 1;
  for (int edge = 1; edge < Histogram::kBins; ++edge) {
    weight += double(histogram.counts[edge - 1]);
    moment += (edge - 1) * double(histogram.counts[edge - 1]);
    if (weight == 0 || weight == total) continue;
    const double distance = moment / weight - (total_moment - moment) / (total - weight);
    const double variance = weight / total * (1 - weight / total) * distance * distance;
    if (variance > best) {
      best = variance;
      first = last = edge;
    } else if (variance == best && last == edge - 1) {
      last = edge;
    }
  }
  const double position = 0.5 * (first + last) / Histogram::kBins;
  return (1 - position) * histogram.lo + position * histogram.hi;
}

}  // namespace isocast
