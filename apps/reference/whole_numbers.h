// Doubles as whole numbers, and back.
#pragma once

#include <gmpxx.h>

#include <initializer_list>
#include <span>
#include <vector>

namespace isocast::reference {

/// Finite doubles as whole numbers times one power of two, which is at most 1.
struct WholeNumbers {
  std::vector<mpz_class> value;
  int exponent = 0;
};
[[nodiscard]] WholeNumbers whole_numbers(std::initializer_list<std::span<const double>> lists);

/// value 2^exponent, within one step of doubles; infinite where it is beyond them.
[[nodiscard]] double to_double(const mpz_class& value, long exponent = 0);
/// n/d 2^exponent, within four steps.
[[nodiscard]] double ratio(const mpz_class& n, const mpz_class& d, long exponent = 0);

}  // namespace isocast::reference
