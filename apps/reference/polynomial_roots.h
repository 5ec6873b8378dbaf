// Real roots of a polynomial with whole coefficients, isolated without rounding.
#pragma once

#include <isocast/apps/reference/bracket.h>
#include <isocast/apps/reference/flint_values.h>

#include <vector>

namespace isocast::reference {

/// lo = hi: the root itself; else it is the only one between lo and hi.
struct PolynomialRoot {
  Bracket s;
  bool crossing;
};

/// The first `max_roots` distinct roots of p in [0, 1], in order, multiple ones among them, in brackets of at
/// most `width`; p is not zero.
///
/// source  Rouillier, Zimmermann: Efficient isolation of a polynomial's real roots, 2004 (Descartes' rule on
///         Bernstein coefficients, of the square-free part)
[[nodiscard]] std::vector<PolynomialRoot> roots_in_unit_interval(const WholePolynomial& p, double width,
                                                                 std::size_t max_roots);

}  // namespace isocast::reference
