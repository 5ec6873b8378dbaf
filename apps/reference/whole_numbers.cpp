#include <isocast/apps/reference/whole_numbers.h>

#include <algorithm>
#include <cmath>

namespace isocast::reference {
namespace {

// std::ldexp of exponents beyond int's.
double scaled(double mantissa, long exponent) {
  constexpr long kBeyond = 5000;
  return std::ldexp(mantissa, static_cast<int>(std::clamp(exponent, -kBeyond, kBeyond)));
}

}  // namespace

WholeNumbers whole_numbers(std::initializer_list<std::span<const double>> lists) {
  // the unit in the last place of x, as an exponent
  const auto unit = [](double x) { return x == 0 ? 0 : std::max(std::ilogb(x), -1022) - 52; };
  WholeNumbers result;
  for (const auto& list : lists)
    for (const double x : list) result.exponent = std::min(result.exponent, unit(x));
  for (const auto& list : lists)
    for (const double x : list)
      result.value.push_back(mpz_class(std::ldexp(x, -unit(x))) << (unit(x) - result.exponent));
  return result;
}

double to_double(const mpz_class& value, long exponent) {
  long own;
  const double mantissa = mpz_get_d_2exp(&own, value.get_mpz_t());
  return scaled(mantissa, own + exponent);
}

double ratio(const mpz_class& n, const mpz_class& d, long exponent) {
  long n_own, d_own;
  const double mantissa = mpz_get_d_2exp(&n_own, n.get_mpz_t()) / mpz_get_d_2exp(&d_own, d.get_mpz_t());
  return scaled(mantissa, n_own - d_own + exponent);
}

}  // namespace isocast::reference
