// Rounding outward by arithmetic: the same bits on every Real, instruction set and GPU, whatever the mode.
#pragma once

#include <isocast/math/real.h>

namespace isocast::inline ISO_ISA {

/// Kernels are also built with bounds that are the nearest numbers, as the papers have them: they prove
/// nothing.
#ifdef ISO_ROUND_NEAREST
inline constexpr bool kOutward = false;
#else
inline constexpr bool kOutward = true;
#endif

/// Spacing of numbers at 1.
template <class T> inline constexpr T kSpacing = T(2) * kUnitRoundoff<T>;
template <class T> inline constexpr T kInfinity = T(__builtin_inff());
template <class T> inline constexpr T kLargest = T(0);
template <> inline constexpr float kLargest<float> = __FLT_MAX__;
template <> inline constexpr double kLargest<double> = __DBL_MAX__;
/// The smallest positive number.
template <class T> inline constexpr T kSmallest = T(0);
template <> inline constexpr float kSmallest<float> = __FLT_DENORM_MIN__;
template <> inline constexpr double kSmallest<double> = __DBL_DENORM_MIN__;

/// x - (|x| spacings + smallest); -inf stays, +inf becomes the largest finite number.
template <Real R> ISO_HD inline R lowered(R x, Scalar<R> spacings, Scalar<R> smallest) {
  using T = Scalar<R>;
  if constexpr (!kOutward) return x;
  const R below = x - (abs(x) * R(spacings * kSpacing<T>) + R(smallest * kSmallest<T>));
  return select(x > R(kLargest<T>), R(kLargest<T>), below);
}

/// At most the true result, for x the nearest number to it: two spacings below at most. +inf, an overflow,
/// becomes the largest finite number: a lower bound is never +inf, an upper bound never -inf.
template <Real R> ISO_HD inline R down(R x) { return lowered(x, 1, 1); }
/// The same of a sum, a difference or a square root, which cannot underflow: zero is exact.
template <Real R> ISO_HD inline R down_exact_zero(R x) { return lowered(x, 1, 0); }
/// What a library function is off by at most, in ulps. SLEEF's functions keep within 1. On CUDA: meant to
/// cover the table of standard functions of the CUDA C++ Programming Guide; docs/cuda.md says how sure that
/// is.
#ifdef __CUDACC__
template <class T> inline constexpr T kLibraryUlps = sizeof(T) == 4 ? T(8) : T(2);
#else
template <class T> inline constexpr T kLibraryUlps = T(1);
#endif

/// The same of a library function: an ulp of the true value is two spacings of x where a power of two lies
/// between. Overflow proves only half of the largest number: exp and pow of doubles call
/// it up to 2e-6 too early.
template <Real R> ISO_HD inline R down_library(R x) {
  using T = Scalar<R>;
  return lowered(select(x > R(kLargest<T>), R(kLargest<T> / T(2)), x), 2 * kLibraryUlps<T>,
                 2 * kLibraryUlps<T>);
}

/// A radius, with room for as many roundings of numbers as large as `size`.
template <Real R> ISO_HD inline R with_roundings(R radius, R size, Scalar<R> spacings = 1) {
  if constexpr (!kOutward) return radius;
  return radius + R(spacings * kSpacing<Scalar<R>>) * size;
}

/// At least the true result: the mirror images.
template <Real R> ISO_HD inline R up(R x) { return -down(-x); }
template <Real R> ISO_HD inline R up_exact_zero(R x) { return -down_exact_zero(-x); }
template <Real R> ISO_HD inline R up_library(R x) { return -down_library(-x); }

}  // namespace isocast::inline ISO_ISA
