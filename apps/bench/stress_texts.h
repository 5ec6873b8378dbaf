// Formulas that are too long to be typed.
#pragma once

#include <string>

namespace isocast::bench {

/// T50 written as powers of the variable, without its constant term, by which it would be recognised.
[[nodiscard]] std::string chebyshev_powers(const char* variable);

/// x - 1/n times ... times x - n/n, but for a factor: n roots in a row, in two ways to write it.
[[nodiscard]] std::string wilkinson_factors(int n);
/// n <= 18: coefficients have 64 bits.
[[nodiscard]] std::string wilkinson_powers(int n);

}  // namespace isocast::bench
