// Transcendental functions of a Real: SLEEF's deterministic set, the same bits on every instruction set,
// within 1 ulp.
#pragma once

#include <isocast/math/pack.h>
#include <sleef.h>

namespace isocast::inline ISO_ISA {

inline float cos(float a) { return Sleef_cinz_cosf1_u10purec(a); }
inline float acos(float a) { return Sleef_cinz_acosf1_u10purec(a); }
inline float cbrt(float a) { return Sleef_cinz_cbrtf1_u10purec(a); }
inline double cos(double a) { return Sleef_cinz_cosd1_u10purec(a); }
inline double acos(double a) { return Sleef_cinz_acosd1_u10purec(a); }
inline double cbrt(double a) { return Sleef_cinz_cbrtd1_u10purec(a); }

inline Pack<float, 4> cos(Pack<float, 4> a) { return Pack<float, 4>(Sleef_cinz_cosf4_u10sse4(a.v)); }
inline Pack<float, 4> acos(Pack<float, 4> a) { return Pack<float, 4>(Sleef_cinz_acosf4_u10sse4(a.v)); }
inline Pack<float, 4> cbrt(Pack<float, 4> a) { return Pack<float, 4>(Sleef_cinz_cbrtf4_u10sse4(a.v)); }
inline Pack<double, 2> cos(Pack<double, 2> a) { return Pack<double, 2>(Sleef_cinz_cosd2_u10sse4(a.v)); }
inline Pack<double, 2> acos(Pack<double, 2> a) { return Pack<double, 2>(Sleef_cinz_acosd2_u10sse4(a.v)); }
inline Pack<double, 2> cbrt(Pack<double, 2> a) { return Pack<double, 2>(Sleef_cinz_cbrtd2_u10sse4(a.v)); }
#ifdef __AVX2__
inline Pack<float, 8> cos(Pack<float, 8> a) { return Pack<float, 8>(Sleef_cinz_cosf8_u10avx(a.v)); }
inline Pack<float, 8> acos(Pack<float, 8> a) { return Pack<float, 8>(Sleef_cinz_acosf8_u10avx(a.v)); }
inline Pack<float, 8> cbrt(Pack<float, 8> a) { return Pack<float, 8>(Sleef_cinz_cbrtf8_u10avx(a.v)); }
inline Pack<double, 4> cos(Pack<double, 4> a) { return Pack<double, 4>(Sleef_cinz_cosd4_u10avx(a.v)); }
inline Pack<double, 4> acos(Pack<double, 4> a) { return Pack<double, 4>(Sleef_cinz_acosd4_u10avx(a.v)); }
inline Pack<double, 4> cbrt(Pack<double, 4> a) { return Pack<double, 4>(Sleef_cinz_cbrtd4_u10avx(a.v)); }
#endif
#ifdef __AVX512F__
inline Pack<float, 16> cos(Pack<float, 16> a) {
  return Pack<float, 16>(Sleef_cinz_cosf16_u10avx512fnofma(a.v));
}
inline Pack<float, 16> acos(Pack<float, 16> a) {
  return Pack<float, 16>(Sleef_cinz_acosf16_u10avx512fnofma(a.v));
}
inline Pack<float, 16> cbrt(Pack<float, 16> a) {
  return Pack<float, 16>(Sleef_cinz_cbrtf16_u10avx512fnofma(a.v));
}
inline Pack<double, 8> cos(Pack<double, 8> a) {
  return Pack<double, 8>(Sleef_cinz_cosd8_u10avx512fnofma(a.v));
}
inline Pack<double, 8> acos(Pack<double, 8> a) {
  return Pack<double, 8>(Sleef_cinz_acosd8_u10avx512fnofma(a.v));
}
inline Pack<double, 8> cbrt(Pack<double, 8> a) {
  return Pack<double, 8>(Sleef_cinz_cbrtd8_u10avx512fnofma(a.v));
}
#endif

}  // namespace isocast::inline ISO_ISA
