// Random numbers that depend on a counter alone, so that every thread and slab finds the same.
#pragma once

#include <cstdint>
#include <initializer_list>

namespace isocast {

/// Mixes the bits of a counter: the finaliser of SplitMix64 (G. L. Steele, D. Lea, C. H. Flood: Fast
/// splittable pseudorandom number generators, OOPSLA 2014).
[[nodiscard]] constexpr std::uint64_t hash_bits(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Uniform in [0, 1), a function of the keys and their order.
[[nodiscard]] constexpr double hash_uniform(std::initializer_list<std::uint64_t> keys) {
  std::uint64_t state = 0;
  for (const std::uint64_t key : keys) state = hash_bits(state ^ key);
  return static_cast<double>(state >> 11) * 0x1p-53;
}

}  // namespace isocast
