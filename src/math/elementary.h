// Transcendental functions of a Real: SLEEF's deterministic set, the same bits on every instruction set,
// within 1 ulp. On a GPU, its library's.
#pragma once

#ifdef __CUDACC__
#include <isocast/math/elementary_device.h>
#else
#include <isocast/math/pack.h>
#include <sleef.h>

namespace isocast::inline ISO_ISA {

// One function of one or two arguments for a register of F floats or D doubles.
#define ISO_SLEEF_LANES(name, F, D, set)                             \
  inline Pack<float, F> name(Pack<float, F> a) {                     \
    return Pack<float, F>(Sleef_cinz_##name##f##F##_u10##set(a.v));  \
  }                                                                  \
  inline Pack<double, D> name(Pack<double, D> a) {                   \
    return Pack<double, D>(Sleef_cinz_##name##d##D##_u10##set(a.v)); \
  }
#define ISO_SLEEF_LANES_2(name, F, D, set)                                \
  inline Pack<float, F> name(Pack<float, F> a, Pack<float, F> b) {        \
    return Pack<float, F>(Sleef_cinz_##name##f##F##_u10##set(a.v, b.v));  \
  }                                                                       \
  inline Pack<double, D> name(Pack<double, D> a, Pack<double, D> b) {     \
    return Pack<double, D>(Sleef_cinz_##name##d##D##_u10##set(a.v, b.v)); \
  }

// For every register of the instruction set that this file is compiled for.
#if defined(__AVX512F__)
#define ISO_SLEEF_PACKS(lanes, name) \
  lanes(name, 4, 2, sse4) lanes(name, 8, 4, avx) lanes(name, 16, 8, avx512fnofma)
#elif defined(__AVX2__)
#define ISO_SLEEF_PACKS(lanes, name) lanes(name, 4, 2, sse4) lanes(name, 8, 4, avx)
#else
#define ISO_SLEEF_PACKS(lanes, name) lanes(name, 4, 2, sse4)
#endif

#define ISO_SLEEF(name)                                                      \
  inline float name(float a) { return Sleef_cinz_##name##f1_u10purec(a); }   \
  inline double name(double a) { return Sleef_cinz_##name##d1_u10purec(a); } \
  ISO_SLEEF_PACKS(ISO_SLEEF_LANES, name)
#define ISO_SLEEF_2(name)                                                                 \
  inline float name(float a, float b) { return Sleef_cinz_##name##f1_u10purec(a, b); }    \
  inline double name(double a, double b) { return Sleef_cinz_##name##d1_u10purec(a, b); } \
  ISO_SLEEF_PACKS(ISO_SLEEF_LANES_2, name)

ISO_SLEEF(cbrt)
ISO_SLEEF(exp)
ISO_SLEEF(log)
ISO_SLEEF(log10)
ISO_SLEEF(sin)
ISO_SLEEF(cos)
ISO_SLEEF(tan)
ISO_SLEEF(asin)
ISO_SLEEF(acos)
ISO_SLEEF(atan)
ISO_SLEEF(sinh)
ISO_SLEEF(cosh)
ISO_SLEEF(tanh)
ISO_SLEEF_2(pow)
ISO_SLEEF_2(atan2)

#undef ISO_SLEEF_2
#undef ISO_SLEEF
#undef ISO_SLEEF_PACKS
#undef ISO_SLEEF_LANES_2
#undef ISO_SLEEF_LANES

}  // namespace isocast::inline ISO_ISA

#endif
