// The operations of formulas on one number, beside those of real.h: the same bits on every instruction set.
#pragma once

#include <isocast/math/elementary.h>

namespace isocast::inline ISO_ISA {

// Within 1 ulp, by SLEEF's deterministic functions.
inline float exp(float a) { return Sleef_cinz_expf1_u10purec(a); }
inline float log(float a) { return Sleef_cinz_logf1_u10purec(a); }
inline float log10(float a) { return Sleef_cinz_log10f1_u10purec(a); }
inline float sin(float a) { return Sleef_cinz_sinf1_u10purec(a); }
inline float tan(float a) { return Sleef_cinz_tanf1_u10purec(a); }
inline float asin(float a) { return Sleef_cinz_asinf1_u10purec(a); }
inline float atan(float a) { return Sleef_cinz_atanf1_u10purec(a); }
inline float sinh(float a) { return Sleef_cinz_sinhf1_u10purec(a); }
inline float cosh(float a) { return Sleef_cinz_coshf1_u10purec(a); }
inline float tanh(float a) { return Sleef_cinz_tanhf1_u10purec(a); }
inline float pow(float a, float b) { return Sleef_cinz_powf1_u10purec(a, b); }
inline float atan2(float a, float b) { return Sleef_cinz_atan2f1_u10purec(a, b); }
inline double exp(double a) { return Sleef_cinz_expd1_u10purec(a); }
inline double log(double a) { return Sleef_cinz_logd1_u10purec(a); }
inline double log10(double a) { return Sleef_cinz_log10d1_u10purec(a); }
inline double sin(double a) { return Sleef_cinz_sind1_u10purec(a); }
inline double tan(double a) { return Sleef_cinz_tand1_u10purec(a); }
inline double asin(double a) { return Sleef_cinz_asind1_u10purec(a); }
inline double atan(double a) { return Sleef_cinz_atand1_u10purec(a); }
inline double sinh(double a) { return Sleef_cinz_sinhd1_u10purec(a); }
inline double cosh(double a) { return Sleef_cinz_coshd1_u10purec(a); }
inline double tanh(double a) { return Sleef_cinz_tanhd1_u10purec(a); }
inline double pow(double a, double b) { return Sleef_cinz_powd1_u10purec(a, b); }
inline double atan2(double a, double b) { return Sleef_cinz_atan2d1_u10purec(a, b); }

inline float floor(float a) { return __builtin_floorf(a); }
inline float ceil(float a) { return __builtin_ceilf(a); }
inline double floor(double a) { return __builtin_floor(a); }
inline double ceil(double a) { return __builtin_ceil(a); }
/// Halves go away from zero.
inline float round(float a) { return __builtin_roundf(a); }
inline double round(double a) { return __builtin_round(a); }

/// -1, 0 or 1; a zero and NaN stay themselves.
template <Real R> inline R sign(R a) { return select(a > R(0), R(1), select(a < R(0), R(-1), a)); }

/// 0 for a < edge, 1 for a >= edge; NaN when either is.
template <Real R> inline R step(R edge, R a) {
  return select(a < edge, R(0), select(a >= edge, R(1), a + edge));
}

template <Real R> inline R square(R a) { return a * a; }

/// a^n by repeated squaring from the exponent's highest bit: x^500 in 13 products; 1 for n = 0.
template <Real R> inline R power(R a, int n) {
  if (n == 0) return R(1);
  const unsigned exponent = n < 0 ? 0u - static_cast<unsigned>(n) : static_cast<unsigned>(n);
  R product = a;
  for (unsigned bit = (1u << (31 - __builtin_clz(exponent))) >> 1; bit != 0; bit >>= 1) {
    product = product * product;
    if (exponent & bit) product = product * a;
  }
  return n < 0 ? R(1) / product : product;
}

}  // namespace isocast::inline ISO_ISA
