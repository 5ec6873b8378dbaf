// Whether a formula is a polynomial in x, y and z, and of which degree.
#pragma once

#include <isocast/implicit/expression/tape.h>

#include <optional>
#include <string>

namespace isocast {

/// Degrees above this are not told.
inline constexpr int kMostPolynomialDegree = 60;

/// degree  in all, at most: terms that cancel are not seen; nothing if the formula is no polynomial
/// reason  then what keeps it from being one: "not a polynomial because of sin"
struct PolynomialDegree {
  std::optional<int> degree;
  std::string reason;
};

/// With time and parameters fixed. An operation on numbers alone is a number, whatever it is, as long as it
/// is defined.
[[nodiscard]] PolynomialDegree polynomial_degree(const Tape& tape);
[[nodiscard]] PolynomialDegree polynomial_degree(const Expression& expression);

}  // namespace isocast
