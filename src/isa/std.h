// The few standard types that kernels may use.
#pragma once

#ifdef __CUDACC_RTC__
// What compiles at run time has no standard headers.
namespace std {
using size_t = decltype(sizeof 0);
using int8_t = signed char;
using uint8_t = unsigned char;
using int16_t = short;
using uint16_t = unsigned short;
using int32_t = int;
using uint32_t = unsigned;
using int64_t = long long;
using uint64_t = unsigned long long;
enum class byte : unsigned char {};
}  // namespace std
// Nor the compiler's own functions.
inline float __builtin_fabsf(float a) { return fabsf(a); }
inline double __builtin_fabs(double a) { return fabs(a); }
inline float __builtin_sqrtf(float a) { return sqrtf(a); }
inline double __builtin_sqrt(double a) { return sqrt(a); }
inline float __builtin_floorf(float a) { return floorf(a); }
inline double __builtin_floor(double a) { return floor(a); }
inline float __builtin_ceilf(float a) { return ceilf(a); }
inline double __builtin_ceil(double a) { return ceil(a); }
inline float __builtin_copysignf(float a, float b) { return copysignf(a, b); }
inline double __builtin_copysign(double a, double b) { return copysign(a, b); }
constexpr double __builtin_inf() { return __builtin_bit_cast(double, 0x7ff0000000000000ull); }
constexpr float __builtin_inff() { return __builtin_bit_cast(float, 0x7f800000u); }
constexpr double __builtin_nan(const char*) { return __builtin_bit_cast(double, 0x7ff8000000000000ull); }
#define __FLT_MAX__ 0x1.fffffep+127f
#define __DBL_MAX__ 0x1.fffffffffffffp+1023
#define __FLT_DENORM_MIN__ 0x1p-149f
#define __DBL_DENORM_MIN__ 0x1p-1074
#else
#include <cstddef>
#include <cstdint>
#endif
