// Transcendental functions of a number on a GPU: the device library's, whose bits are its own.
#pragma once

#include <isocast/math/real.h>

#ifdef __CUDACC__
namespace isocast::inline ISO_ISA {

#define ISO_DEVICE(name)                                     \
  ISO_HD inline float name(float a) { return ::name##f(a); } \
  ISO_HD inline double name(double a) { return ::name(a); }
#define ISO_DEVICE_2(name)                                               \
  ISO_HD inline float name(float a, float b) { return ::name##f(a, b); } \
  ISO_HD inline double name(double a, double b) { return ::name(a, b); }

ISO_DEVICE(cbrt)
ISO_DEVICE(exp)
ISO_DEVICE(log)
ISO_DEVICE(log10)
ISO_DEVICE(sin)
ISO_DEVICE(cos)
ISO_DEVICE(tan)
ISO_DEVICE(asin)
ISO_DEVICE(acos)
ISO_DEVICE(atan)
ISO_DEVICE(sinh)
ISO_DEVICE(cosh)
ISO_DEVICE(tanh)
ISO_DEVICE_2(pow)
ISO_DEVICE_2(atan2)

#undef ISO_DEVICE_2
#undef ISO_DEVICE

}  // namespace isocast::inline ISO_ISA
#endif
