// A number of a formula, kept exactly.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace isocast {

/// `text` is the exact number: "<digits>e<exponent>" without leading or trailing zeros of the digits
/// ("-25e-1" is -2.5, "0e0" is zero), or "pi", "e", "phi". `value` is the nearest double, `exact` whether it
/// is the same number.
struct Constant {
  std::string text;
  double value;
  bool exact;
};

/// Reads a decimal literal such as -1, .5 or 1e-3. Nothing when `literal` is no such literal, or when the
/// number is beyond the range of double precision (infinite, or not zero but rounded to zero).
[[nodiscard]] std::optional<Constant> decimal_constant(std::string_view literal);

/// The shortest decimal that reads back as `value`, which must be finite: 0.1 is 1/10 and not the double
/// nearest to it.
[[nodiscard]] Constant shortest_constant(double value);

/// Exactly the finite double `value`.
[[nodiscard]] Constant exact_constant(double value);

/// "pi", "e" or "phi" (the golden ratio); nothing for any other name.
[[nodiscard]] std::optional<Constant> named_constant(std::string_view name);

}  // namespace isocast
