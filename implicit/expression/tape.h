// A formula as instructions over few registers.
#pragma once

#include <isocast/implicit/expression/expression.h>

#include <vector>

namespace isocast {

/// What evaluate.h runs. A register is used again as soon as its value is needed no more; the result is in
/// `result`.
struct Tape {
  std::vector<Instruction> code;
  std::vector<TapeConstant> constants;
  std::uint32_t registers = 0, result = 0;

  [[nodiscard]] TapeView view() const { return {code.data(), code.size(), constants.data(), result}; }
};

/// Only what the root needs, each node once; of two operands the one that needs more registers comes first.
[[nodiscard]] Tape make_tape(const Expression& expression);

}  // namespace isocast
