// One sample as a number, and as a side of the iso-value.
#pragma once

#include <isocast/math/real.h>
#include <isocast/volume/sample_type.h>

namespace isocast::inline ISO_ISA {

/// IEEE binary16 to float, exact.
ISO_HD inline float to_float(Half h) {
  const std::uint32_t sign = std::uint32_t(h.bits & 0x8000u) << 16, magnitude = h.bits & 0x7fffu;
  if (magnitude >= 0x7c00u) return __builtin_bit_cast(float, sign | 0x7f800000u | (magnitude & 0x3ffu) << 13);
  if (magnitude >= 0x400u) return __builtin_bit_cast(float, sign | ((magnitude << 13) + (112u << 23)));
  return copysign(float(magnitude) * 0x1p-24f, __builtin_bit_cast(float, sign));
}

/// How samples of type S are compared and subtracted. Arithmetic: samples as numbers. Key: a threshold k such
/// that the corner value, sample minus iso in precision T, is negative exactly where sample < k (host side:
/// iso_key in volume_surface.cpp).
template <class S> struct SampleTraits {
  using Arithmetic = S;
  using Key = std::int32_t;
  static constexpr bool wide = false;
};
template <> struct SampleTraits<Half> {
  using Arithmetic = float;
  using Key = float;
  static constexpr bool wide = false;
};
template <> struct SampleTraits<float> {
  using Arithmetic = float;
  using Key = float;
  static constexpr bool wide = false;
};
template <> struct SampleTraits<double> {
  using Arithmetic = double;
  using Key = double;
  static constexpr bool wide = true;
};
template <> struct SampleTraits<std::uint32_t> {
  using Arithmetic = std::uint32_t;
  using Key = std::int64_t;
  static constexpr bool wide = true;
};
template <> struct SampleTraits<std::int32_t> {
  using Arithmetic = std::int32_t;
  using Key = std::int64_t;
  static constexpr bool wide = true;
};
// compared and subtracted as doubles: exact up to 2^53
template <> struct SampleTraits<std::int64_t> {
  using Arithmetic = double;
  using Key = double;
  static constexpr bool wide = true;
};

template <class S> ISO_HD inline typename SampleTraits<S>::Arithmetic number(S s) {
  return typename SampleTraits<S>::Arithmetic(s);
}
ISO_HD inline float number(Half s) { return to_float(s); }

/// Sample minus iso in T: in double first where the sample needs it (u32, i32, f64). Never -0.
template <class T, class S> ISO_HD inline T corner_value(S s, double iso) {
  if constexpr (SampleTraits<S>::wide) return T(double(number(s)) - iso);
  else return T(number(s)) - T(iso);
}

/// Bit i set: some of eight corners lie below key i and some do not.
template <class S>
ISO_HD inline std::uint32_t parted_isos(const S (&corners)[8], const typename SampleTraits<S>::Key* keys,
                                        int count) {
  std::uint32_t parted = 0;
  for (int i = 0; i < count; ++i) {
    int below = 0;
    for (int k = 0; k < 8; ++k) below += number(corners[k]) < keys[i];
    parted |= std::uint32_t(below > 0 && below < 8) << i;
  }
  return parted;
}

/// Whether some key parts the values lo...hi.
template <class A, class Key> ISO_HD inline bool parts_range(A lo, A hi, const Key* keys, int count) {
  bool parts = false;
  for (int i = 0; i < count; ++i) parts = parts | (lo < keys[i] && !(hi < keys[i]));
  return parts;
}

}  // namespace isocast::inline ISO_ISA
