// The functions that a formula may call.
#pragma once

#include <isocast/implicit/expression/expression.h>

#include <cstddef>
#include <span>
#include <string_view>

namespace isocast {

/// One function: how many arguments it takes, and the graph of a call. With `degree_first` the first argument
/// has to be a constant node, a whole number from 0 to kMaxChebyshevDegree.
struct Builtin {
  std::string_view name;
  std::size_t min_arguments, max_arguments;
  NodeId (*build)(Expression&, std::span<const NodeId> arguments);
  bool degree_first = false;
};

/// All functions. clamp, hypot, mix, mod and smoothstep are written in simpler ones: mod(a, b) = a - b
/// floor(a / b).
[[nodiscard]] std::span<const Builtin> builtins();

/// The function of that name, or null.
[[nodiscard]] const Builtin* find_builtin(std::string_view name);

}  // namespace isocast
