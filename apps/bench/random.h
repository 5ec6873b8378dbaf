// Random numbers of one case: the n-th case can be made without the others.
#pragma once

#include <isocast/data_gen/hash.h>

#include <cstdint>

namespace isocast::bench {

/// A sequence that seed and index alone decide.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t index) : state_(hash_bits(hash_bits(seed) ^ index)) {}

  std::uint64_t next() { return hash_bits(state_++); }
  /// In [0, 1).
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double uniform(double lo, double hi) { return lo + (hi - lo) * uniform(); }
  /// In 0 ... n-1.
  int below(int n) { return static_cast<int>(next() % static_cast<std::uint64_t>(n)); }
  double sign() { return next() & 1 ? 1 : -1; }

 private:
  std::uint64_t state_;
};

}  // namespace isocast::bench
