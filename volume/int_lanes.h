// Lanes of registers as whole numbers, and some of them one behind the other.
#pragma once

#include <isocast/math/pack.h>

namespace isocast::inline ISO_ISA {

/// As many whole numbers as R has lanes of float.
template <Real R> struct IntLanes { using Type = typename R::IntVector; };
template <> struct IntLanes<float> { using Type = std::int32_t; };
template <Real R> using Ints = typename IntLanes<R>::Type;

template <Real R> inline Ints<R> load_ints(const std::int32_t* from) {
  Ints<R> v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
template <Real R> inline R to_real(Ints<R> v) {
  if constexpr (kWidth<R> == 1) return R(v);
  else return R(__builtin_convertvector(v, typename R::Vector));
}
/// Towards zero.
template <Real R> inline Ints<R> to_ints(R v) {
  if constexpr (kWidth<R> == 1) return Ints<R>(v);
  else return __builtin_convertvector(v.v, Ints<R>);
}

/// Lanes of double from and to other types.
template <Real R> inline R load_as(const std::int32_t* from) {
#ifdef __AVX512DQ__
  return R(_mm512_maskz_cvtepi32_pd(0xff, _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from))));
#else
  double lanes[kWidth<R>];
  for (int l = 0; l < kWidth<R>; ++l) lanes[l] = double(from[l]);
  return load<R>(lanes);
#endif
}
template <Real R> inline void store_as(double* to, R v) { store(to, v); }
template <Real R> inline void store_as(float* to, R v) {
#ifdef __AVX512DQ__
  _mm256_storeu_ps(to, _mm512_maskz_cvtpd_ps(0xff, v.v));
#else
  double lanes[kWidth<R>];
  store(lanes, v);
  for (int l = 0; l < kWidth<R>; ++l) to[l] = float(lanes[l]);
#endif
}

/// Writes the lanes of `bits` one behind the other; as many numbers as there are lanes may be overwritten.
template <class V> inline void put_ints(std::int32_t* to, V v, unsigned bits) {
#ifdef __AVX512DQ__
  _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(__mmask16(bits), __m512i(v)));
#else
  std::int32_t lanes[sizeof(V) / sizeof(std::int32_t)];
  __builtin_memcpy(lanes, &v, sizeof v);
  for (; bits; bits &= bits - 1) *to++ = lanes[__builtin_ctz(bits)];
#endif
}
template <Real R> inline void put_reals(float* to, R v, unsigned bits) {
#ifdef __AVX512DQ__
  _mm512_storeu_ps(to, _mm512_maskz_compress_ps(__mmask16(bits), v.v));
#else
  float lanes[kWidth<R>];
  store(lanes, v);
  for (; bits; bits &= bits - 1) *to++ = lanes[__builtin_ctz(bits)];
#endif
}

/// Writes the numbers of the bits that are set, exclusive-ored with `flip`; as put_ints. Returns how many.
inline int put_numbers(std::int32_t* to, std::uint64_t bits, int flip) {
#ifdef __AVX512DQ__
  typedef std::int32_t V __attribute__((vector_size(64)));
  int n = 0;
  for (int i = 0; i < 64; i += 16) {
    const V lanes = (V{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15} + i) ^ flip;
    const unsigned some = unsigned(bits >> i & 0xffff);
    put_ints(to + n, lanes, some);
    n += __builtin_popcount(some);
  }
  return n;
#else
  int n = 0;
  for (; bits; bits &= bits - 1) to[n++] = __builtin_ctzll(bits) ^ flip;
  return n;
#endif
}

}  // namespace isocast::inline ISO_ISA
