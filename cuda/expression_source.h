// A formula as source text, for a compiler to take the place of the tape.
#pragma once

#include <isocast/implicit/expression/tape.h>

#include <string>

namespace isocast {

/// The header `isocast/implicit/expression/evaluate.h` for one formula: evaluate_some of it alone, every
/// operation of the tape on a value of its own, over any kind of number that the tape runs on (R,
/// Interval<R>, AffineForm<R, N>, Gradient<...>). The tape that it is called with is not looked at. Numbers
/// are written in hexadecimal: exact.
[[nodiscard]] std::string expression_header(const Tape& tape);

/// The same as statements, over x, y, z, w of type R; the last one sets *registers.
[[nodiscard]] std::string expression_body(const Tape& tape);

}  // namespace isocast
