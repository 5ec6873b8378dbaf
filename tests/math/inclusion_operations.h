// The operations that inclusions have, by name, for any kind of them.
#pragma once

#include <isocast/math/gradient_functions.h>
#include <math/inclusion_names.h>

namespace isocast::inline ISO_ISA {

/// a operation b, or operation a; `power` raises a to n, `chebyshev` has the
/// degree |n|.
template <class F> F apply(test::Inclusion operation, const F& a, const F& b, int n) {
  switch (operation) {
    case test::Inclusion::negate: return -a;
    case test::Inclusion::abs: return abs(a);
    case test::Inclusion::sign: return sign(a);
    case test::Inclusion::square: return square(a);
    case test::Inclusion::power: return power(a, n);
    case test::Inclusion::chebyshev: return chebyshev(a, n < 0 ? -n : n);
    case test::Inclusion::sqrt: return sqrt(a);
    case test::Inclusion::cbrt: return cbrt(a);
    case test::Inclusion::exp: return exp(a);
    case test::Inclusion::log: return log(a);
    case test::Inclusion::log10: return log10(a);
    case test::Inclusion::sin: return sin(a);
    case test::Inclusion::cos: return cos(a);
    case test::Inclusion::tan: return tan(a);
    case test::Inclusion::asin: return asin(a);
    case test::Inclusion::acos: return acos(a);
    case test::Inclusion::atan: return atan(a);
    case test::Inclusion::sinh: return sinh(a);
    case test::Inclusion::cosh: return cosh(a);
    case test::Inclusion::tanh: return tanh(a);
    case test::Inclusion::floor: return floor(a);
    case test::Inclusion::ceil: return ceil(a);
    case test::Inclusion::round: return round(a);
    case test::Inclusion::add: return a + b;
    case test::Inclusion::subtract: return a - b;
    case test::Inclusion::multiply: return a * b;
    case test::Inclusion::divide: return a / b;
    case test::Inclusion::min: return min(a, b);
    case test::Inclusion::max: return max(a, b);
    case test::Inclusion::pow: return pow(a, b);
    case test::Inclusion::atan2: return atan2(a, b);
    case test::Inclusion::hypot: return hypot(a, b);
    case test::Inclusion::mod: return mod(a, b);
    case test::Inclusion::step: return step(a, b);
    default: return choose(a, b, a);
  }
}

}  // namespace isocast::inline ISO_ISA
