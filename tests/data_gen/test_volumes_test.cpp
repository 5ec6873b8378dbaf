// The named test volumes.
#include <isocast/data_gen/hash.h>
#include <isocast/data_gen/test_volumes.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

using namespace isocast;
using std::numbers::pi;

namespace {

// All samples of a test volume on an n^3 grid over [-1, 1]^3.
std::vector<double> sampled(std::string_view name, std::int64_t n, const TestVolumeSettings& settings = {}) {
  const SampleGrid grid = {{n, n, n}, {}};
  std::vector<double> all(static_cast<std::size_t>(n * n * n));
  sample_rows(test_volume_field(*find_test_volume(name), settings), grid, 0, grid.rows(),
              [&](std::int64_t row, std::span<const double> values) {
                std::ranges::copy(values, all.begin() + row * n);
              });
  return all;
}

double coordinate(std::int64_t index, std::int64_t n) {
  return -1 + 2 * static_cast<double>(index) / static_cast<double>(n - 1);
}

}  // namespace

TEST_CASE("marschner_lobb is the published signal") {
  const std::int64_t n = 21;
  const std::vector<double> all = sampled("marschner_lobb", n),
                            other = sampled("marschner_lobb", n, {{"fM", 3}, {"alpha", 0.5}});
  for (std::int64_t i = 0; i < n * n * n; ++i) {
    const double x = coordinate(i % n, n), y = coordinate(i / n % n, n), z = coordinate(i / n / n, n);
    const auto signal = [&](double fm, double alpha) {
      const double ripple = std::cos(2 * pi * fm * std::cos(pi * std::hypot(x, y) / 2));
      return (1 - std::sin(pi * z / 2) + alpha * (1 + ripple)) / (2 * (1 + alpha));
    };
    REQUIRE(all[std::size_t(i)] == Approx(signal(6, 0.25)).margin(1e-12));
    REQUIRE(other[std::size_t(i)] == Approx(signal(3, 0.5)).margin(1e-12));
  }
}

TEST_CASE("gyroid repeats `periods` times along the edge") {
  const std::vector<double> all = sampled("gyroid", 33, {{"periods", 2}});
  const auto at = [&](int i, int j, int k) { return all[std::size_t(i + 33 * (j + 33 * k))]; };
  for (int i = 0; i < 17; ++i) CHECK(at(i, 5, 9) == Approx(at(i + 16, 5, 9)).margin(1e-12));
  const double k = 2 * pi, x = coordinate(3, 33), y = coordinate(5, 33), z = coordinate(9, 33);
  CHECK(at(3, 5, 9) == Approx(std::sin(k * x) * std::cos(k * y) + std::sin(k * y) * std::cos(k * z) +
                              std::sin(k * z) * std::cos(k * x)));
}

TEST_CASE("noise is uniform, depends on the seed and on the voxel alone") {
  const std::vector<double> one = sampled("noise", 32), two = sampled("noise", 32, {{"seed", 2}}),
                            larger = sampled("noise", 40);
  CHECK(one == sampled("noise", 32));
  double mean = 0, product = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    REQUIRE((one[i] >= 0 && one[i] < 1));
    mean += one[i] / double(one.size());
    product += (one[i] - 0.5) * (two[i] - 0.5) / double(one.size());
  }
  CHECK(mean == Approx(0.5).margin(0.01));
  CHECK(product == Approx(0).margin(0.003));
  CHECK(larger[std::size_t(7 + 40 * (5 + 40 * 3))] == one[std::size_t(7 + 32 * (5 + 32 * 3))]);
  CHECK(one[0] == hash_uniform({1, 0, 0, 0}));
}

TEST_CASE("checkerboard and constant") {
  const std::vector<double> board = sampled("checkerboard", 4);
  for (std::size_t i = 0; i < board.size(); ++i) CHECK(board[i] == double((i % 4 + i / 4 % 4 + i / 16) % 2));
  for (const double value : sampled("constant", 3, {{"value", -2.5}})) CHECK(value == -2.5);
}

TEST_CASE("vessel is a tube at its trunk, and branches") {
  const std::int64_t n = 65;
  const std::vector<double> trunk = sampled("vessel", n, {{"levels", 0}}), tree = sampled("vessel", n);
  const auto place = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
    return std::size_t(i + n * (j + n * k));
  };
  CHECK(trunk[place(32, 32, 0)] == 1);
  CHECK(trunk[place(32, 32, 8)] == Approx(1));
  CHECK(trunk[place(32 + 4, 32, 0)] == Approx(1 - (4 * 2.0 / 64) / (2 * 0.11)));
  CHECK(trunk[place(45, 32, 0)] == 0);
  double volume = 0, trunk_volume = 0;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    REQUIRE((tree[i] >= trunk[i] && tree[i] <= 1));
    volume += tree[i] > 0.5;
    trunk_volume += trunk[i] > 0.5;
  }
  CHECK(volume > 2 * trunk_volume);
  CHECK(tree != sampled("vessel", n, {{"seed", 9}}));
}

TEST_CASE("unknown names and settings") {
  CHECK(find_test_volume("nois") == nullptr);
  CHECK(test_volumes().size() == 6);
  CHECK_THROWS_WITH(sampled("noise", 2, {{"sed", 1}}),
                    "found the setting 'sed', expected one of seed of the test volume noise");
  CHECK_THROWS_WITH(sampled("checkerboard", 2, {{"a", 1}}),
                    "found the setting 'a', expected none of the test volume checkerboard");
  CHECK_THROWS_WITH(sampled("noise", 2, {{"seed", 0.5}}),
                    "found seed = 0.5, expected a whole number from 0 to 9007199254740992");
  CHECK_THROWS_WITH(sampled("vessel", 2, {{"levels", 99}}),
                    "found levels = 99, expected a whole number from 0 to 10");
}
