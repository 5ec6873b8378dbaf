// Functions of a Real that need no library beyond its vocabulary.
#pragma once

#include <isocast/math/bits.h>
#include <isocast/math/real.h>

namespace isocast::inline ISO_ISA {

/// -1, 0 or 1; a zero and NaN stay themselves.
template <Real R> ISO_HD inline R sign(R a) { return select(a > R(0), R(1), select(a < R(0), R(-1), a)); }

/// 0 for a < edge, 1 for a >= edge; NaN when either is.
template <Real R> ISO_HD inline R step(R edge, R a) {
  return select(a < edge, R(0), select(a >= edge, R(1), a + edge));
}

/// To the nearest integer, halves away from zero.
template <Real R> ISO_HD inline R round(R a) {
  const R below = floor(abs(a));
  return copysign(below + select(abs(a) - below >= R(0.5), R(1), R(0)), a);
}

template <Real R> ISO_HD inline R square(R a) { return a * a; }

template <Real R> ISO_HD inline R hypot(R a, R b) { return sqrt(a * a + b * b); }
/// Of b's sign, or zero.
template <Real R> ISO_HD inline R mod(R a, R b) { return a - b * floor(a / b); }

/// a^n by repeated squaring from the exponent's highest bit: x^500 in 13 products; 1 for n = 0.
template <Real R> ISO_HD inline R power(R a, int n) {
  if (n == 0) return R(1);
  const unsigned exponent = n < 0 ? 0u - static_cast<unsigned>(n) : static_cast<unsigned>(n);
  R product = a;
  for (unsigned bit = (1u << highest_bit(exponent)) >> 1; bit != 0; bit >>= 1) {
    product = product * product;
    if (exponent & bit) product = product * a;
  }
  return n < 0 ? R(1) / product : product;
}

/// a where `condition` is not 0, else b; the condition itself when it is NaN.
template <Real R> ISO_HD inline R choose(R condition, R a, R b) {
  return select(condition == R(0), b, select(condition == condition, a, condition));
}

/// The Chebyshev polynomial T_n(a), n >= 0; 1 for n = 0. With u half the spacing of numbers at 1, off by at
/// most 2 n u max(1, |T_n(a)|): the recurrence of the differences T_k - T_(k-1) at |a|, where |a| - 1 is
/// exact near the ends (Reinsch; J. Oliver: An error analysis of the modified Clenshaw method for evaluating
/// Chebyshev and Fourier series, IMA J. Appl. Math. 20, 1977).
template <Real R> ISO_HD inline R chebyshev(R a, int n) {
  if (n == 0) return R(1);
  const R size = abs(a), slope = R(2) * (size - R(1));
  R value = size, difference = size - R(1);
  for (int k = 1; k < n; ++k) {
    difference = slope * value + difference;
    value = value + difference;
  }
  return n % 2 == 1 ? select(a < R(0), -value, value) : value;
}

/// The same of any kind of number that has square(), with 2 log2(n) products and no error bound of its own:
/// T_2k = 2 T_k^2 - 1, T_(2k+1) = 2 T_k T_(k+1) - a.
template <class F> ISO_HD inline F chebyshev_by_doubling(const F& a, int n) {
  const F one(1), two(2);
  F low = one, high = a;
  for (unsigned bit = n > 0 ? 1u << highest_bit(static_cast<unsigned>(n)) : 0u; bit != 0; bit >>= 1) {
    const F odd = two * (low * high) - a;
    if (static_cast<unsigned>(n) & bit) low = odd, high = two * square(high) - one;
    else high = odd, low = two * square(low) - one;
  }
  return low;
}

}  // namespace isocast::inline ISO_ISA
