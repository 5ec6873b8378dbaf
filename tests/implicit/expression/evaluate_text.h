// A formula's value from its text, and the message of a failure.
#pragma once

#include <isocast/base/error.h>
#include <isocast/implicit/expression/evaluate.h>
#include <isocast/implicit/expression/parse.h>
#include <isocast/implicit/expression/simplify.h>
#include <isocast/implicit/expression/tape.h>

#include <array>
#include <string>
#include <vector>

namespace isocast::test {

template <class T = double> T run(const Tape& tape, const std::array<T, 4>& at) {
  std::vector<T> registers(tape.registers);
  return evaluate(tape.view(), at.data(), registers.data());
}

inline double value(std::string_view text, const std::array<double, 4>& at = {},
                    const Parameters& parameters = {}) {
  return run(make_tape(simplify(parse_expression(text, parameters))), at);
}

/// What parse_expression complains about; empty when it does not.
inline std::string complaint(std::string_view text, const Parameters& parameters = {}) {
  try {
    static_cast<void>(parse_expression(text, parameters));
    return {};
  } catch (const InputError& error) { return error.what(); }
}

}  // namespace isocast::test
