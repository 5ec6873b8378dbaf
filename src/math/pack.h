// Several lanes of float or double in one register, on the compiler's vector types. Never included by .cu
// files.
#pragma once

#include <immintrin.h>
#include <isocast/math/real.h>

namespace isocast::inline ISO_ISA {

/// The compiler's vector types of W lanes: of T, and of integers as wide as T.
template <class T, int W> struct PackTypes;
template <int W> struct PackTypes<float, W> {
  using Int = std::int32_t;
  using MaskRegister = std::uint16_t;
  typedef float Vector __attribute__((vector_size(W * 4)));
  typedef Int IntVector __attribute__((vector_size(W * 4)));
};
template <int W> struct PackTypes<double, W> {
  using Int = std::int64_t;
  using MaskRegister = std::uint8_t;
  typedef double Vector __attribute__((vector_size(W * 8)));
  typedef Int IntVector __attribute__((vector_size(W * 8)));
};

/// Lanes of a comparison: all bits of a lane set or none. T and W are those of the Pack that was compared.
template <class T, int W> struct PackMask {
  using Int = typename PackTypes<T, W>::Int;
  using Bits = typename PackTypes<T, W>::IntVector;
  Bits v;
  PackMask() = default;
  PackMask(Bits x) : v(x) {}
  explicit PackMask(bool b) : v(Bits{} - Int(b)) {}
  friend PackMask operator&(PackMask a, PackMask b) { return Bits(a.v & b.v); }
  friend PackMask operator|(PackMask a, PackMask b) { return Bits(a.v | b.v); }
  friend PackMask operator!=(PackMask a, PackMask b) { return Bits(a.v ^ b.v); }
  friend PackMask operator==(PackMask a, PackMask b) { return Bits(~(a.v ^ b.v)); }
  friend PackMask operator!(PackMask a) { return Bits(~a.v); }
};

#ifdef __AVX512DQ__
/// AVX-512 has registers for masks: one bit a lane.
template <class T, int W>
requires(W * sizeof(T) == 64) struct PackMask<T, W> {
  using Bits = typename PackTypes<T, W>::MaskRegister;
  Bits v;
  PackMask() = default;
  PackMask(Bits x) : v(x) {}
  explicit PackMask(bool b) : v(Bits(-int(b))) {}
  friend PackMask operator&(PackMask a, PackMask b) { return Bits(a.v & b.v); }
  friend PackMask operator|(PackMask a, PackMask b) { return Bits(a.v | b.v); }
  friend PackMask operator!=(PackMask a, PackMask b) { return Bits(a.v ^ b.v); }
  friend PackMask operator==(PackMask a, PackMask b) { return Bits(~(a.v ^ b.v)); }
  friend PackMask operator!(PackMask a) { return Bits(~a.v); }
};
#endif

/// W lanes of T, exactly one register wide (g++ 12 makes wider ones several times slower: use an array of
/// packs).
template <class T, int W> struct Pack {
  static_assert(W * sizeof(T) == 16 || W * sizeof(T) == 32 || W * sizeof(T) == 64, "one register");
  using Int = typename PackTypes<T, W>::Int;
  using Vector = typename PackTypes<T, W>::Vector;
  using IntVector = typename PackTypes<T, W>::IntVector;
  Vector v;
  Pack() = default;
  Pack(Vector x) : v(x) {}
  explicit Pack(T x) : v(Vector{} + x) {}
  friend Pack operator+(Pack a, Pack b) { return Vector(a.v + b.v); }
  friend Pack operator-(Pack a, Pack b) { return Vector(a.v - b.v); }
  friend Pack operator*(Pack a, Pack b) { return Vector(a.v * b.v); }
  friend Pack operator/(Pack a, Pack b) { return Vector(a.v / b.v); }
  friend Pack operator-(Pack a) { return Vector(-a.v); }
};

template <class T, int W> struct RealTraits<Pack<T, W>> {
  using Scalar = T;
  using Mask = PackMask<T, W>;
  static constexpr int width = W;
};

template <class T, int W> inline constexpr bool kMaskRegisters = sizeof(PackMask<T, W>) < sizeof(Pack<T, W>);

// Comparisons are false for NaN, but for != (as in C).
#define ISO_PACK_COMPARISON(op, predicate)                                                  \
  template <class T, int W> inline PackMask<T, W> operator op(Pack<T, W> a, Pack<T, W> b) { \
    if constexpr (!kMaskRegisters<T, W>) return a.v op b.v;                                 \
    else if constexpr (sizeof(T) == 4) return _mm512_cmp_ps_mask(a.v, b.v, predicate);      \
    else return _mm512_cmp_pd_mask(a.v, b.v, predicate);                                    \
  }
ISO_PACK_COMPARISON(<, _CMP_LT_OQ)
ISO_PACK_COMPARISON(<=, _CMP_LE_OQ)
ISO_PACK_COMPARISON(>, _CMP_GT_OQ)
ISO_PACK_COMPARISON(>=, _CMP_GE_OQ)
ISO_PACK_COMPARISON(==, _CMP_EQ_OQ)
ISO_PACK_COMPARISON(!=, _CMP_NEQ_UQ)
#undef ISO_PACK_COMPARISON

template <class T, int W> inline Pack<T, W> select(PackMask<T, W> m, Pack<T, W> a, Pack<T, W> b) {
  if constexpr (!kMaskRegisters<T, W>) return typename Pack<T, W>::Vector(m.v ? a.v : b.v);
  else if constexpr (sizeof(T) == 4) return Pack<T, W>(_mm512_mask_blend_ps(m.v, b.v, a.v));
  else return Pack<T, W>(_mm512_mask_blend_pd(m.v, b.v, a.v));
}
template <class T, int W> inline PackMask<T, W> select(PackMask<T, W> m, PackMask<T, W> a, PackMask<T, W> b) {
  return (m & a) | ((!m) & b);
}
template <class T, int W> inline Pack<T, W> min(Pack<T, W> a, Pack<T, W> b) {
  if constexpr (!kMaskRegisters<T, W>) return select(a < b, a, b);
  else if constexpr (sizeof(T) == 4) return Pack<T, W>(_mm512_maskz_min_ps(0xffff, a.v, b.v));
  else return Pack<T, W>(_mm512_maskz_min_pd(0xff, a.v, b.v));
}
template <class T, int W> inline Pack<T, W> max(Pack<T, W> a, Pack<T, W> b) {
  if constexpr (!kMaskRegisters<T, W>) return select(a > b, a, b);
  else if constexpr (sizeof(T) == 4) return Pack<T, W>(_mm512_maskz_max_ps(0xffff, a.v, b.v));
  else return Pack<T, W>(_mm512_maskz_max_pd(0xff, a.v, b.v));
}

// Bits of a pack as integers and back.
template <class T, int W> inline typename Pack<T, W>::IntVector int_bits(Pack<T, W> a) {
  return __builtin_bit_cast(typename Pack<T, W>::IntVector, a.v);
}
template <class T, int W> inline Pack<T, W> from_int_bits(typename Pack<T, W>::IntVector a) {
  return __builtin_bit_cast(typename Pack<T, W>::Vector, a);
}
template <class T, int W>
inline constexpr
    typename Pack<T, W>::Int kSignBit = sizeof(T) == 4 ? typename Pack<T, W>::Int(0x80000000u)
                                                       : typename Pack<T, W>::Int(0x8000000000000000ull);

template <class T, int W> inline Pack<T, W> abs(Pack<T, W> a) {
  return from_int_bits<T, W>(int_bits(a) & ~kSignBit<T, W>);
}
template <class T, int W> inline PackMask<T, W> negative(Pack<T, W> a) {
  if constexpr (!kMaskRegisters<T, W>) return int_bits(a) < 0;
  else if constexpr (sizeof(T) == 4) return _mm512_movepi32_mask(__m512i(a.v));
  else return _mm512_movepi64_mask(__m512i(a.v));
}
template <class T, int W> inline Pack<T, W> copysign(Pack<T, W> a, Pack<T, W> b) {
  return from_int_bits<T, W>((int_bits(a) & ~kSignBit<T, W>) | (int_bits(b) & kSignBit<T, W>));
}
template <class T, int W> inline Pack<T, W> inverse_power_of_two(Pack<T, W> a) {
  using Int = typename Pack<T, W>::Int;
  constexpr Int exponent = sizeof(T) == 4 ? Int(0x7f800000) : Int(0x7ff0000000000000);
  constexpr Int top = sizeof(T) == 4 ? Int(0x7e800000) : Int(0x7fd0000000000000);
  constexpr Int base = sizeof(T) == 4 ? Int(0x7f000000) : Int(0x7fe0000000000000);
  const auto e = int_bits(a) & exponent;
  const typename Pack<T, W>::IntVector limited = e > top ? (e - e + top) : e;
  return from_int_bits<T, W>(base - limited);
}

// The two operations that vector types lack: square roots, and a mask as bits.
inline Pack<float, 4> sqrt(Pack<float, 4> a) { return Pack<float, 4>(_mm_sqrt_ps(a.v)); }
inline Pack<double, 2> sqrt(Pack<double, 2> a) { return Pack<double, 2>(_mm_sqrt_pd(a.v)); }
inline unsigned bits_of(PackMask<float, 4> m) { return unsigned(_mm_movemask_ps(__m128(m.v))); }
inline unsigned bits_of(PackMask<double, 2> m) { return unsigned(_mm_movemask_pd(__m128d(m.v))); }
#ifdef __AVX2__
inline Pack<float, 8> sqrt(Pack<float, 8> a) { return Pack<float, 8>(_mm256_sqrt_ps(a.v)); }
inline Pack<double, 4> sqrt(Pack<double, 4> a) { return Pack<double, 4>(_mm256_sqrt_pd(a.v)); }
inline unsigned bits_of(PackMask<float, 8> m) { return unsigned(_mm256_movemask_ps(__m256(m.v))); }
inline unsigned bits_of(PackMask<double, 4> m) { return unsigned(_mm256_movemask_pd(__m256d(m.v))); }
#endif
#ifdef __AVX512DQ__
inline Pack<float, 16> sqrt(Pack<float, 16> a) { return Pack<float, 16>(_mm512_maskz_sqrt_ps(0xffff, a.v)); }
inline Pack<double, 8> sqrt(Pack<double, 8> a) { return Pack<double, 8>(_mm512_maskz_sqrt_pd(0xff, a.v)); }
inline unsigned bits_of(PackMask<float, 16> m) { return m.v; }
inline unsigned bits_of(PackMask<double, 8> m) { return m.v; }
#endif
template <class T, int W> inline bool any(PackMask<T, W> m) { return bits_of(m) != 0; }

/// Adding and subtracting what leaves no digits after the point rounds to nearest; what came out above steps
/// back.
template <class T, int W> inline Pack<T, W> floor(Pack<T, W> a) {
  using R = Pack<T, W>;
  const R no_fraction = R(T(1) / (T(2) * kUnitRoundoff<T>));
  const R nearest = copysign((abs(a) + no_fraction) - no_fraction, a);
  const R below = nearest - select(nearest > a, R(T(1)), R(T(0)));
  return select(abs(a) < no_fraction, below, a);
}
template <class T, int W> inline Pack<T, W> ceil(Pack<T, W> a) { return -floor(-a); }

template <class T, int W> inline Pack<T, W> load(const T* p, Pack<T, W>) {
  Pack<T, W> a;
  __builtin_memcpy(&a.v, p, sizeof a.v);
  return a;
}
template <class T, int W> inline void store(T* p, Pack<T, W> a) { __builtin_memcpy(p, &a.v, sizeof a.v); }

/// The widest Real of the instruction set that this file is compiled for: one lane without one.
template <class T> struct NativeReal {
#if defined(__AVX512DQ__)
  using Type = Pack<T, 64 / sizeof(T)>;
#elif defined(__AVX2__)
  using Type = Pack<T, 32 / sizeof(T)>;
#elif defined(__SSE4_2__)
  using Type = Pack<T, 16 / sizeof(T)>;
#else
  using Type = T;
#endif
};
template <class T> using Native = typename NativeReal<T>::Type;

}  // namespace isocast::inline ISO_ISA
