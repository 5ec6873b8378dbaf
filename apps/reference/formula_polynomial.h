// A formula along a ray as a polynomial, exactly.
#pragma once

#include <isocast/apps/reference/exact_formula.h>

#include <array>

namespace isocast::reference {

/// Degrees above this go another way.
inline constexpr int kMaxExactDegree = 100;

/// Whether the formula is a polynomial in x, y and z with rational coefficients, made of sums, differences,
/// products, whole powers, Chebyshev polynomials and quotients by numbers, and small enough: at most
/// kMaxExactDegree, and no more than about a second of work along a ray of doubles of like size.
[[nodiscard]] bool is_polynomial(const ExactFormula& formula);

/// One axis of p(s) = start + s span.
struct RationalAxis {
  Rational start, span;
};

/// f - iso along the ray, times some positive number: a polynomial in s with whole coefficients.
[[nodiscard]] WholePolynomial polynomial_along(const ExactFormula& formula,
                                               const std::array<RationalAxis, 3>& axes);

}  // namespace isocast::reference
