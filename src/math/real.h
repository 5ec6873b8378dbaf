// The vocabulary of numbers that every kernel is written in, spelt for one lane: float and double.
#pragma once

#include <isocast/isa/isa.h>
#include <isocast/isa/std.h>

namespace isocast::inline ISO_ISA {

/// What a Real is made of: its scalar type, its mask, its number of lanes. Pack (pack.h) has its own.
template <class R> struct RealTraits;
template <> struct RealTraits<float> {
  using Scalar = float;
  using Mask = bool;
  static constexpr int width = 1;
};
template <> struct RealTraits<double> {
  using Scalar = double;
  using Mask = bool;
  static constexpr int width = 1;
};

template <class R> using Scalar = typename RealTraits<R>::Scalar;
template <class R> using Mask = typename RealTraits<R>::Mask;
template <class R> inline constexpr int kWidth = RealTraits<R>::width;

/// float, double or a Pack of them.
template <class R>
concept Real = requires {
  typename RealTraits<R>::Scalar;
};
template <class T>
concept ScalarReal = Real<T> && RealTraits<T>::width == 1;

/// Half the spacing of numbers at 1: a correctly rounded operation is off by at most kUnitRoundoff times its
/// result.
template <class T> inline constexpr T kUnitRoundoff = T(0);
template <> inline constexpr float kUnitRoundoff<float> = 0x1p-24f;
template <> inline constexpr double kUnitRoundoff<double> = 0x1p-53;

template <ScalarReal T> ISO_HD constexpr T select(bool mask, T a, T b) { return mask ? a : b; }
ISO_HD constexpr bool select(bool mask, bool a, bool b) { return mask ? a : b; }
ISO_HD constexpr bool any(bool mask) { return mask; }
/// One bit a lane, lane 0 lowest.
ISO_HD constexpr unsigned bits_of(bool mask) { return mask ? 1u : 0u; }
/// The second operand when either is NaN, as in SSE.
template <ScalarReal T> ISO_HD constexpr T min(T a, T b) { return a < b ? a : b; }
template <ScalarReal T> ISO_HD constexpr T max(T a, T b) { return a > b ? a : b; }
ISO_HD inline float abs(float a) { return __builtin_fabsf(a); }
ISO_HD inline double abs(double a) { return __builtin_fabs(a); }
ISO_HD inline float sqrt(float a) { return __builtin_sqrtf(a); }
ISO_HD inline double sqrt(double a) { return __builtin_sqrt(a); }
ISO_HD inline float floor(float a) { return __builtin_floorf(a); }
ISO_HD inline double floor(double a) { return __builtin_floor(a); }
ISO_HD inline float ceil(float a) { return __builtin_ceilf(a); }
ISO_HD inline double ceil(double a) { return __builtin_ceil(a); }

/// The sign bit. Samples minus iso are never -0, and an underflow keeps its sign: so this calls exactly zero
/// positive and stays consistent where a comparison with 0 would not (design.md, decision 5).
ISO_HD inline bool negative(float a) { return __builtin_bit_cast(std::int32_t, a) < 0; }
ISO_HD inline bool negative(double a) { return __builtin_bit_cast(std::int64_t, a) < 0; }
/// Magnitude of a, sign of b.
ISO_HD inline float copysign(float a, float b) { return __builtin_copysignf(a, b); }
ISO_HD inline double copysign(double a, double b) { return __builtin_copysign(a, b); }

/// A power of two p with 1 <= p |a| < 2 for normal a below the top two binades; never zero, infinite or NaN.
/// Scaling by it is exact and keeps squares and products of the largest of several numbers from over- and
/// underflow.
ISO_HD inline float inverse_power_of_two(float a) {
  const std::uint32_t e = __builtin_bit_cast(std::uint32_t, a) & 0x7f800000u;
  const std::uint32_t inverse = 0x7f000000u - (e > 0x7e800000u ? 0x7e800000u : e);
  return __builtin_bit_cast(float, inverse);
}
ISO_HD inline double inverse_power_of_two(double a) {
  const std::uint64_t e = __builtin_bit_cast(std::uint64_t, a) & 0x7ff0000000000000u;
  const std::uint64_t inverse = 0x7fe0000000000000u - (e > 0x7fd0000000000000u ? 0x7fd0000000000000u : e);
  return __builtin_bit_cast(double, inverse);
}

template <ScalarReal T> ISO_HD inline T load(const T* p, T) { return *p; }
template <Real R> ISO_HD inline R load(const Scalar<R>* p) { return load(p, R{}); }
template <ScalarReal T> ISO_HD inline void store(T* p, T a) { *p = a; }

/// Unfused on every instruction set and on the GPU, so that all give the same bits.
template <Real R> ISO_HD inline R mul_add(R a, R b, R c) { return a * b + c; }
/// (1-t) a + t b: exactly a at t = 0 and b at t = 1 for finite operands, and of one sign if a and b are.
template <Real R> ISO_HD inline R lerp(R a, R b, R t) { return (R(1) - t) * a + t * b; }
template <Real R> ISO_HD inline R clamp01(R a) { return min(max(a, R(0)), R(1)); }

}  // namespace isocast::inline ISO_ISA
