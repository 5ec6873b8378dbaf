// Operands for property tests of inclusions, biased to where rules break.
#pragma once

#include <isocast/apps/bench/random.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isocast::test {

/// Any finite number: ends of what there is, small integers and their halves, multiples of pi/2 and their
/// neighbours, where exp begins to overflow, moderate numbers, every magnitude.
template <class T> T any_finite(bench::Random& random) {
  using Limits = std::numeric_limits<T>;
  const T special[] = {0, 1, Limits::denorm_min(), Limits::min(), Limits::max(), Limits::epsilon()};
  const double sign = random.sign();
  double x = 0;
  switch (random.below(9)) {
    case 0: x = special[random.below(6)]; break;
    case 1: x = 0.5 * random.below(9); break;
    case 2: x = 1.5707963267948966 * random.below(random.below(2) ? 8 : 100'000); break;
    case 3: x = std::exp2(random.uniform(Limits::min_exponent - Limits::digits, Limits::max_exponent)); break;
    case 4: x = std::exp2(random.uniform(-8, 8)); break;
    case 5: x = random.uniform(0, 100); break;
    case 6: x = std::log(Limits::max()) * random.uniform(1 - 1e-8, 1 + 1e-8); break;
    default: x = random.uniform(0, 2); break;
  }
  T y = static_cast<T>(sign * x);
  if (random.below(4) == 0) y = std::nextafter(y, static_cast<T>(random.sign() * Limits::infinity()));
  return std::clamp(y, Limits::lowest(), Limits::max());
}

/// lo <= hi: points, neighbours, narrow and wide ones, ends at zero and infinity.
template <class T> struct Range { T lo, hi; };
template <class T> Range<T> any_range(bench::Random& random) {
  using Limits = std::numeric_limits<T>;
  T a = any_finite<T>(random), b = a;
  switch (random.below(8)) {
    case 0: break;
    case 1: b = std::nextafter(a, Limits::max()); break;
    case 2: b = static_cast<T>(a + std::abs(a) * random.uniform(0, 1e-4)); break;
    case 3: b = static_cast<T>(a + random.uniform(0, 4)); break;
    case 4: b = 0; break;
    default: b = any_finite<T>(random); break;
  }
  b = std::clamp(b, Limits::lowest(), Limits::max());
  Range<T> range = {std::min(a, b), std::max(a, b)};
  if (random.below(16) == 0) range.lo = -Limits::infinity();
  if (random.below(16) == 0) range.hi = Limits::infinity();
  return range;
}

/// A number of the range: its ends, zero, an integer, anything between.
template <class T> T any_member(bench::Random& random, const Range<T>& range) {
  const T lo = std::max(range.lo, std::numeric_limits<T>::lowest());
  const T hi = std::min(range.hi, std::numeric_limits<T>::max());
  T x = lo;
  switch (random.below(6)) {
    case 0: break;
    case 1: x = hi; break;
    case 2: x = 0; break;
    case 3: x = std::floor(hi); break;
    case 4: x = any_finite<T>(random); break;
    default: x = static_cast<T>(lo + random.uniform() * (static_cast<double>(hi) - lo)); break;
  }
  return std::clamp(std::isnan(x) ? lo : x, lo, hi);
}

}  // namespace isocast::test
