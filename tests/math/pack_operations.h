// Every operation of the vocabulary on sixteen numbers, compiled once per instruction set.
#pragma once

#include <isocast/isa/cpu.h>

#include <cstdint>

namespace isocast::test {

enum class Operation {
  add,
  subtract,
  multiply,
  divide,
  negate,
  minimum,
  maximum,
  absolute,
  square_root,
  multiply_add,
  lerp,
  clamp,
  copy_sign,
  inverse_power,
  select_less,
  less,
  less_equal,
  greater,
  greater_equal,
  equal,
  not_equal,
  sign,
  mask_and,
  mask_or,
  mask_xor,
  mask_equal,
  mask_not,
  mask_select,
  cosine,
  arc_cosine,
  cube_root
};
inline constexpr int kOperationCount = 31;
inline constexpr int kLanes = 16;

/// apply: out = a operation b (c), lane by lane; masks come out as 1 and 0. lanes_of: one bit a lane,
/// set where a < b, and in bit 16 whether any() agrees with them in every register.
struct PackOperations {
  void (*apply_float)(Operation, const float* a, const float* b, const float* c, float* out);
  void (*apply_double)(Operation, const double* a, const double* b, const double* c, double* out);
  std::uint32_t (*lanes_of_float)(const float* a, const float* b);
  std::uint32_t (*lanes_of_double)(const double* a, const double* b);
};

[[nodiscard]] const PackOperations& pack_operations(Isa isa);

}  // namespace isocast::test
