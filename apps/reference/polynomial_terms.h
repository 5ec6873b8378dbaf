// The terms of a formula that is a polynomial in x, y and z, exactly.
#pragma once

#include <isocast/implicit/expression/expression.h>

#include <string>
#include <vector>

namespace isocast::reference {

/// A term coefficient x^i y^j z^k. The coefficient is a rational number such as -3/2, or, where numbers like
/// pi or sqrt(2) enter, a ball such as [1.618 +/- 1e-20]; it lies between lo and hi.
struct PolynomialTerm {
  int i, j, k;
  std::string coefficient;
  double lo, hi;
};

/// degree    in all, of the terms as they are: what cancels does not count
/// rational  all coefficients are
/// terms     highest powers of x first; a formula that is 0 has none
/// reason    what keeps it from being a polynomial, or from being written as one; else empty
struct PolynomialTerms {
  int degree = 0;
  bool rational = true;
  std::vector<PolynomialTerm> terms;
  std::string reason;
};

/// With time fixed. No more than some 10^5 terms of a degree up to kMostPolynomialDegree.
[[nodiscard]] PolynomialTerms polynomial_terms(const Expression& expression, double time);

}  // namespace isocast::reference
