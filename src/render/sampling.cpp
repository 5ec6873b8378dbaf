#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/math/elementary.h>
#include <isocast/render/sampling.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isocast {
namespace {

std::uint32_t reversed(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = (x & 0xff00ff00u) >> 8 | (x & 0x00ff00ffu) << 8;
  x = (x & 0xf0f0f0f0u) >> 4 | (x & 0x0f0f0f0fu) << 4;
  x = (x & 0xccccccccu) >> 2 | (x & 0x33333333u) << 2;
  return (x & 0xaaaaaaaau) >> 1 | (x & 0x55555555u) << 1;
}

// Each digit is changed by those above it: reversed, a product with an even number moves bits upwards only.
std::uint32_t scrambled(std::uint32_t digits, std::uint32_t seed) {
  std::uint32_t x = reversed(digits) + seed;
  for (const std::uint32_t even : {0x7857dd86u, 0x2e84496eu, 0xba6f875eu}) x ^= x * even;
  return reversed(x);
}

// Sobol's second dimension: Pascal's triangle modulo 2.
std::uint32_t second_digits(std::uint32_t index) {
  std::uint32_t digits = 0;
  for (std::uint32_t column = 0x80000000u; index; index >>= 1, column ^= column >> 1)
    if (index & 1) digits ^= column;
  return digits;
}

// Of 600 seeds those with the least error of edges. The shifts of the upper digits bring the first point
// next to the centre, which takes its place.
constexpr std::uint32_t kSeeds[2] = {0x3dab9535u, 0xc3533b28u}, kShifts[2] = {0x73000000u, 0x9f000000u};

double weight(PixelFilter filter, double x) {
  constexpr double kBlackman = 1.5;
  const auto wave = [&](int n) { return cos(n * std::numbers::pi * x / kBlackman); };
  switch (filter) {
    case PixelFilter::triangle: return 1 - std::abs(x);
    case PixelFilter::gaussian: return exp(-2 * x * x);
    case PixelFilter::blackman: return 0.42 + 0.5 * wave(1) + 0.08 * wave(2);
    default: return 1;
  }
}
double radius_of(PixelFilter filter) {
  return filter == PixelFilter::box ? 0.5 : filter == PixelFilter::triangle ? 1 : 1.5;
}

// Turns shares of a filter's weight along an axis into distances from the centre.
class FilterWarp {
 public:
  explicit FilterWarp(PixelFilter filter) : radius_(radius_of(filter)) {
    for (int i = 0; i < kCells; ++i) sums_[i + 1] = sums_[i] + weight(filter, place(i + 0.5));
  }
  [[nodiscard]] double operator()(double share) const {
    const double sum = share * sums_[kCells];
    const auto above = std::upper_bound(std::begin(sums_) + 1, std::end(sums_) - 1, sum);
    const double lo = *(above - 1), hi = *above;
    return place(static_cast<double>(above - 1 - sums_) + (sum - lo) / (hi - lo));
  }

 private:
  static constexpr int kCells = 1024;
  [[nodiscard]] double place(double cell) const { return (2 * cell / kCells - 1) * radius_; }
  double radius_, sums_[kCells + 1] = {};
};

}  // namespace

UnitPoint scrambled_sobol(std::uint32_t index, std::uint32_t seed_u, std::uint32_t seed_v) {
  return {scrambled(reversed(index), seed_u) * 0x1p-32, scrambled(second_digits(index), seed_v) * 0x1p-32};
}

std::uint32_t seed_of(std::uint32_t number) {
  // Steele, Lea, Flood: Fast splittable pseudorandom number generators, OOPSLA 2014
  std::uint64_t x = (number + std::uint64_t(1)) * 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return static_cast<std::uint32_t>(x >> 32);
}

PixelFilter filter_from_name(std::string_view name) {
  constexpr std::string_view names[] = {"box", "triangle", "gaussian", "blackman"};
  const auto found = std::ranges::find(names, name);
  if (found == std::end(names))
    throw InputError(
        fmt::format("the filter '{}' is unknown, expected box, triangle, gaussian or blackman", name));
  return static_cast<PixelFilter>(found - names);
}

std::vector<PixelSample> pixel_samples(int count, PixelFilter filter) {
  std::vector<PixelSample> samples = {{0, 0, 0.5, 0.5}};
  const FilterWarp warp(filter);
  for (int i = 1; i < count; ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    const double u = (scrambled(reversed(index), kSeeds[0]) ^ kShifts[0]) * 0x1p-32,
                 v = (scrambled(second_digits(index), kSeeds[1]) ^ kShifts[1]) * 0x1p-32;
    const double x = 0.5 + warp(u), y = 0.5 + warp(v), column = std::floor(x), row = std::floor(y);
    samples.push_back({static_cast<int>(column), static_cast<int>(row), x - column, y - row});
  }
  return samples;
}

}  // namespace isocast
