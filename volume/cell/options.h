// Which cell intersector runs and with which options: plain data that crosses the kernel table.
#pragma once

#include <isocast/isa/std.h>

namespace isocast {

enum class CellMethod : std::uint8_t { midpoint, linear, neubauer, schwarze, marmitt, certified };
inline constexpr int kCellMethodCount = 6;

/// Meanings and defaults per method are in the method table (volume/methods.cpp).
struct CellOptions {
  int iterations = 3;
  bool adaptive = false;
  bool stable = true;
  bool face = false;
  bool touch = false;
  bool bisection = false;
};

}  // namespace isocast
