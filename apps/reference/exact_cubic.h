// Real roots of integer polynomials of degree three and less, isolated without rounding.
#pragma once

#include <gmpxx.h>

#include <array>
#include <vector>

namespace isocast::reference {

/// c[0] + c[1] s + c[2] s^2 + c[3] s^3; leading coefficients may be zero.
using ExactCubic = std::array<mpz_class, 4>;
[[nodiscard]] bool is_zero(const ExactCubic& p);

/// Roots are known to 2^-kRootBits.
inline constexpr int kRootBits = 63;

/// A root s with numerator/2^bits <= s <= (numerator + 1)/2^bits, or the lower end itself where `exact`.
struct ExactRoot {
  mpz_class numerator;
  int bits;
  bool exact;
  int multiplicity;
};

/// The value at n/2^bits, times 2^(3 bits).
[[nodiscard]] mpz_class scaled_value(const ExactCubic& p, const mpz_class& n, int bits);

/// Every distinct root in [0,1], in order; p is not zero. The intervals are at most 2^-kRootBits wide.
///
/// Multiple roots of a cubic are rational and have closed forms; simple ones are isolated by Descartes' rule
/// on Bernstein coefficients and narrowed by quadratic interval refinement.
/// source  Rouillier, Zimmermann: Efficient isolation of a polynomial's real roots, 2004; Abbott: Quadratic
///         interval refinement for real roots, 2006
[[nodiscard]] std::vector<ExactRoot> roots_in_unit_interval(const ExactCubic& p);

}  // namespace isocast::reference
