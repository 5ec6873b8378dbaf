// Fields and volumes with what is hard in them: noise, planes through samples, holes, scattered leaves.
#pragma once

#include <cmath>
#include <limits>
#include <random>

#include "make_tree.h"
#include "make_volume.h"

namespace isocast::test {

inline constexpr std::array<std::int64_t, 3> kDims = {37, 30, 41};

inline double wavy(std::int64_t i, std::int64_t j, std::int64_t k) {
  const double x = double(i), y = double(j), z = double(k);
  return 40 + 30 * std::sin(0.45 * x) * std::cos(0.5 * y) + 25 * std::sin(0.4 * z + 0.1 * x);
}
inline double rough(std::int64_t i, std::int64_t j, std::int64_t k) {
  const std::uint64_t x = static_cast<std::uint64_t>(i + 100 * j + 10000 * k + 1) * 0x9e3779b97f4a7c15u;
  return static_cast<double>(x >> 40 & 127);
}
// A plane that is met exactly: values that are zero at samples and on whole faces.
inline double flat(std::int64_t i, std::int64_t j, std::int64_t k) { return double(i + j - k % 2) + 20; }

inline std::shared_ptr<Volume> with_holes(std::shared_ptr<Volume> volume) {
  auto* samples = reinterpret_cast<float*>(const_cast<std::byte*>(volume->samples));
  for (std::int64_t i = 0; i < volume->count(); i += 97) samples[i] = std::nanf("");
  for (std::int64_t i = 5; i < volume->count(); i += 211) samples[i] = INFINITY;
  for (std::int64_t i = 50; i < volume->count(); i += 1009) samples[i] = -3e38f;
  return volume;
}

// Scattered leaves, also at negative places, with inactive samples; active and inactive tiles beside them.
inline std::shared_ptr<Volume> patchy_tree(SparseType type) {
  TreeMaker maker(type, 7);
  std::mt19937_64 random(3);
  for (int z = -2; z < 4; ++z)
    for (int y = -3; y < 3; ++y)
      for (int x = -2; x < 5; ++x) {
        const auto kind = random() % 6;
        const std::array<std::int32_t, 3> origin = {8 * x, 8 * y, 8 * z};
        if (kind == 0) maker.tile(origin, 3, 60, true);
        if (kind == 1) maker.tile(origin, 3, 70, false);
        if (kind < 3) continue;
        for (int n = 0; n < 512; ++n) {
          const std::array<std::int32_t, 3> p = {origin[0] + (n & 7), origin[1] + (n >> 3 & 7),
                                                 origin[2] + (n >> 6)};
          maker.set(p, wavy(p[0], p[1], p[2]), kind != 3 || random() % 4);
        }
      }
  maker.tile({128, 0, 0}, 7, 50, true);
  return maker.volume();
}

}  // namespace isocast::test
