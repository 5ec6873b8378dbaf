// Range, histogram, percentiles and suggested iso-values of small volumes whose answers are known.
#include <isocast/volume/statistics.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "make_tree.h"

using namespace isocast;

namespace {

template <class S>
VolumeStatistics statistics_of_values(SampleType type, const std::vector<S>& values, double slope = 1,
                                      double intercept = 0) {
  Volume volume;
  volume.type = type;
  volume.dims = {std::int64_t(values.size()), 1, 1};
  volume.samples = reinterpret_cast<const std::byte*>(values.data());
  volume.slope = slope;
  volume.intercept = intercept;
  return statistics_of(volume);
}

std::int64_t total(const Histogram& histogram) {
  return std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::int64_t(0));
}

// Strictly inside the range, none twice.
void check_suggestions(const VolumeStatistics& s) {
  REQUIRE(!s.suggested_iso.empty());
  for (std::size_t i = 0; i < s.suggested_iso.size(); ++i) {
    CHECK(s.suggested_iso[i] > s.min);
    CHECK(s.suggested_iso[i] < s.max);
    for (std::size_t j = 0; j < i; ++j) CHECK(s.suggested_iso[i] != s.suggested_iso[j]);
  }
}

}  // namespace

TEST_CASE("bytes are counted exactly", "[statistics]") {
  std::vector<std::uint8_t> values;
  for (int v = 0; v < 256; ++v) values.insert(values.end(), v == 7 ? 1001 : 1000, std::uint8_t(v));
  const VolumeStatistics s = statistics_of_values(SampleType::u8, values);
  CHECK(s.min == 0);
  CHECK(s.max == 255);
  CHECK(s.finite_count == 256001);
  for (int b = 0; b < 256; ++b) CHECK(s.histogram.counts[b] == (b == 7 ? 1001 : 1000));
  CHECK(s.percentiles[0].percent == 0.1);
  CHECK(s.percentiles[0].value == 0);
  CHECK(s.percentiles[4].value == 127);
  CHECK(s.percentiles[7].value == 253);
  check_suggestions(s);
  CHECK(s.suggested_iso[0] == Approx(127.5).margin(1));
}

TEST_CASE("slope and intercept scale everything, also a negative slope", "[statistics]") {
  std::vector<std::int16_t> values;
  for (int v = -1000; v <= 3000; ++v) values.push_back(std::int16_t(v));
  const VolumeStatistics up = statistics_of_values(SampleType::i16, values, 0.5, 10),
                         down = statistics_of_values(SampleType::i16, values, -0.5, 10);
  CHECK(up.min == -490);
  CHECK(up.max == 1510);
  CHECK(up.percentiles[4].value == 510);
  CHECK(down.min == -1490);
  CHECK(down.max == 510);
  CHECK(down.percentiles[4].value == -490);
  CHECK(down.percentiles[3].value < down.percentiles[5].value);
  CHECK(total(up.histogram) == 4001);
  CHECK(total(down.histogram) == 4001);
  check_suggestions(down);
}

TEST_CASE("every type is read", "[statistics]") {
  const auto check = [](const VolumeStatistics& s, double lo, double hi) {
    CHECK(s.min == lo);
    CHECK(s.max == hi);
    CHECK(total(s.histogram) == 4);
    check_suggestions(s);
  };
  check(statistics_of_values<std::int8_t>(SampleType::i8, {-128, 0, 1, 127}), -128, 127);
  check(statistics_of_values<std::uint16_t>(SampleType::u16, {0, 5, 7, 65535}), 0, 65535);
  check(statistics_of_values<std::uint32_t>(SampleType::u32, {0, 5, 7, 4294967295u}), 0, 4294967295.0);
  check(statistics_of_values<std::int32_t>(SampleType::i32, {-2147483647 - 1, 5, 7, 2147483647}),
        -2147483648.0, 2147483647);
  check(statistics_of_values<std::uint16_t>(SampleType::f16, {0x3c00, 0xc000, 0, 0x7bff}), -2, 65504);
  check(statistics_of_values<float>(SampleType::f32, {-1e38f, 0, 1, 3e38f}), double(-1e38f), double(3e38f));
  check(statistics_of_values<double>(SampleType::f64, {-1.7e308, 0, 1, 1.7e308}), -1.7e308, 1.7e308);
  check(statistics_of_values<double>(SampleType::f64, {0, 1e-320, 2e-320, 5e-320}), 0, 5e-320);
}

TEST_CASE("NaN and infinities are counted and left out", "[statistics]") {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  const VolumeStatistics s = statistics_of_values<double>(SampleType::f64, {nan, 1, inf, 2, -inf, nan, nan});
  CHECK(s.nan_count == 3);
  CHECK(s.infinite_count == 2);
  CHECK(s.finite_count == 2);
  CHECK(s.min == 1);
  CHECK(s.max == 2);
  CHECK(total(s.histogram) == 2);
  const VolumeStatistics none = statistics_of_values<float>(SampleType::f32, {float(nan), float(inf)});
  CHECK(none.finite_count == 0);
  CHECK(none.min == 0);
  CHECK(none.max == 0);
  CHECK(none.suggested_iso.empty());
}

TEST_CASE("a constant volume suggests its constant", "[statistics]") {
  const VolumeStatistics s = statistics_of_values<std::uint8_t>(SampleType::u8, {9, 9, 9}, 2, 1);
  CHECK(s.min == 19);
  CHECK(s.max == 19);
  CHECK(s.suggested_iso == std::vector<double>{19});
  CHECK(s.percentiles[4].value == 19);
  CHECK(total(s.histogram) == 3);
}

TEST_CASE("Otsu parts two classes in the middle of the gap", "[statistics]") {
  const VolumeStatistics binary = statistics_of_values<std::uint8_t>(SampleType::u8, {0, 0, 0, 1, 1});
  CHECK(binary.suggested_iso == std::vector<double>{0.5});

  // two humps around 50 and 200
  std::vector<std::uint8_t> values;
  for (int v = 0; v < 256; ++v) {
    const double hump =
        900 * std::exp(-(v - 50) * (v - 50) / 200.0) + 300 * std::exp(-(v - 200) * (v - 200) / 200.0) + 1;
    values.insert(values.end(), static_cast<std::size_t>(hump), std::uint8_t(v));
  }
  const VolumeStatistics humps = statistics_of_values(SampleType::u8, values);
  CHECK(humps.suggested_iso[0] > 90);
  CHECK(humps.suggested_iso[0] < 160);
  check_suggestions(humps);
}

TEST_CASE("of a sparse grid the active samples count, tiles for all that they fill") {
  test::TreeMaker tree(SparseType::f32, -7);
  tree.set({0, 0, 0}, 1, true);
  tree.set({0, 0, 1}, 3, true);
  tree.set({0, 0, 2}, 99, false);
  tree.tile({8, 0, 0}, 3, 2, true);
  tree.tile({16, 0, 0}, 3, 88, false);
  const auto volume = tree.volume();
  VolumeStatistics s = statistics_of(*volume);
  CHECK(s.finite_count == 514);
  CHECK(s.min == 1);
  CHECK(s.max == 3);
  CHECK(s.histogram.counts[0] == 1);
  CHECK(s.histogram.counts[128] == 512);
  CHECK(s.histogram.counts[255] == 1);
  for (auto grid_class : {"fog volume", "level set"}) {
    test::TreeMaker distances(SparseType::f32, 3);
    for (std::int32_t i = 0; i < 8; ++i) distances.set({i, 0, 0}, i - 2, true);
    const auto band = distances.volume();
    band->grid_class = grid_class;
    s = statistics_of(*band);
    CHECK((s.suggested_iso.front() == 0) == (std::string(grid_class) == "level set"));
  }
}
