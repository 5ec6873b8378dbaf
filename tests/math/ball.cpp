#include <math/ball.h>

namespace isocast::test {

namespace {

constexpr slong kBits = 200;

void undecided(Ball& y) { arb_indeterminate(y.set()); }

void set_truth(Ball& y, bool yes, bool no) {
  if (yes == no) undecided(y);
  else arb_set_si(y.set(), yes);
}

// a - b floor(a / b).
void modulo(Ball& y, const Ball& a, const Ball& b) {
  arb_div(y.set(), a.get(), b.get(), kBits);
  arb_floor(y.set(), y.get(), kBits);
  arb_mul(y.set(), y.get(), b.get(), kBits);
  arb_sub(y.set(), a.get(), y.get(), kBits);
}

// Halves go away from zero.
void round_half_up(Ball& y, const Ball& a) {
  const Ball half(0.5);
  if (arb_is_nonnegative(a.get())) {
    arb_add(y.set(), a.get(), half.get(), kBits);
    arb_floor(y.set(), y.get(), kBits);
  } else if (arb_is_negative(a.get())) {
    arb_sub(y.set(), a.get(), half.get(), kBits);
    arb_ceil(y.set(), y.get(), kBits);
  } else {
    undecided(y);
  }
}

}  // namespace

Ball truth(Inclusion operation, const Ball& a, const Ball& b, int n) {
  Ball y;
  arb_struct* const out = y.set();
  const arb_struct *const x = a.get(), *const z = b.get();
  if (!a.is_number()) return a;
  if (operation >= Inclusion::add && !b.is_number()) return b;
  switch (operation) {
    case Inclusion::negate: arb_neg(out, x); break;
    case Inclusion::abs: arb_abs(out, x); break;
    case Inclusion::sign: arb_sgn(out, x); break;
    case Inclusion::square: arb_sqr(out, x, kBits); break;
    case Inclusion::power: {
      arb_pow_ui(out, x, static_cast<ulong>(n < 0 ? -n : n), kBits);
      if (n < 0) arb_inv(out, out, kBits);
      break;
    }
    case Inclusion::chebyshev: arb_chebyshev_t_ui(out, static_cast<ulong>(n < 0 ? -n : n), x, kBits); break;
    case Inclusion::sqrt: arb_sqrt(out, x, kBits); break;
    case Inclusion::cbrt: {
      arb_abs(out, x);
      if (!arb_is_zero(x)) arb_root_ui(out, out, 3, kBits);
      if (arb_is_negative(x)) arb_neg(out, out);
      else if (!arb_is_nonnegative(x)) undecided(y);
      break;
    }
    case Inclusion::exp: arb_exp(out, x, kBits); break;
    case Inclusion::log: arb_log(out, x, kBits); break;
    case Inclusion::log10: arb_log_base_ui(out, x, 10, kBits); break;
    case Inclusion::sin: arb_sin(out, x, kBits); break;
    case Inclusion::cos: arb_cos(out, x, kBits); break;
    case Inclusion::tan: arb_tan(out, x, kBits); break;
    case Inclusion::asin: arb_asin(out, x, kBits); break;
    case Inclusion::acos: arb_acos(out, x, kBits); break;
    case Inclusion::atan: arb_atan(out, x, kBits); break;
    case Inclusion::sinh: arb_sinh(out, x, kBits); break;
    case Inclusion::cosh: arb_cosh(out, x, kBits); break;
    case Inclusion::tanh: arb_tanh(out, x, kBits); break;
    case Inclusion::floor: arb_floor(out, x, kBits); break;
    case Inclusion::ceil: arb_ceil(out, x, kBits); break;
    case Inclusion::round: round_half_up(y, a); break;
    case Inclusion::add: arb_add(out, x, z, kBits); break;
    case Inclusion::subtract: arb_sub(out, x, z, kBits); break;
    case Inclusion::multiply: arb_mul(out, x, z, kBits); break;
    case Inclusion::divide: arb_div(out, x, z, kBits); break;
    case Inclusion::min: arb_min(out, x, z, kBits); break;
    case Inclusion::max: arb_max(out, x, z, kBits); break;
    case Inclusion::pow: arb_pow(out, x, z, kBits); break;
    case Inclusion::atan2: arb_atan2(out, x, z, kBits); break;
    case Inclusion::hypot: arb_hypot(out, x, z, kBits); break;
    case Inclusion::mod: modulo(y, a, b); break;
    case Inclusion::step: set_truth(y, arb_ge(z, x), arb_lt(z, x)); break;
    case Inclusion::choose: {
      if (!arb_contains_zero(x)) arb_set(out, z);
      else if (arb_is_zero(x)) arb_set(out, x);
      else undecided(y);
      break;
    }
  }
  const bool has_value = operation == Inclusion::exp || operation == Inclusion::sinh ||
                         operation == Inclusion::cosh || (operation == Inclusion::pow && arb_is_positive(x));
  if (has_value && !arb_is_finite(out)) arb_zero_pm_inf(out);
  return y;
}

Ball multiply_add(const Ball& a, const Ball& b, const Ball& c) {
  Ball y;
  arb_mul(y.set(), a.get(), b.get(), kBits);
  arb_add(y.set(), y.get(), c.get(), kBits);
  return y;
}

}  // namespace isocast::test
