// Every operation on sixteen inclusions of every kind, compiled once per instruction set.
#pragma once

#include <isocast/isa/cpu.h>
#include <math/inclusion_names.h>

namespace isocast::test {

/// Intervals as lo, hi; affine forms as c, e, r; gradients of intervals as the value's lo, hi.
enum class Kind { interval, affine_1, affine_3, gradient };
inline constexpr int kKindCount = 4;
inline constexpr int kInclusionLanes = 16;
inline constexpr int kNumbersIn = 5, kNumbersOut = 12;

/// out = a operation b, lane by lane; number k of lane i at [k * 16 + i]. What a kind has no use for is left.
/// The decorations come out as 1 (defined) + 2 (continuous) + 4 (empty), the last number of each inclusion.
struct InclusionKernels {
  void (*apply_float)(Kind, Inclusion, int n, const float* a, const float* b, float* out);
  void (*apply_double)(Kind, Inclusion, int n, const double* a, const double* b, double* out);
};

[[nodiscard]] const InclusionKernels& inclusion_kernels(Isa isa);

}  // namespace isocast::test
