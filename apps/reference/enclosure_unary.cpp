#include <isocast/apps/reference/enclosure_parts.h>

namespace isocast::reference {
namespace {

// Between f at lo and f at hi, for f that only rises or only falls.
template <class F> void set_monotone(Ball& y, const Ends& x, slong bits, F f) {
  Ball at_lo, at_hi;
  arb_set_arf(at_lo.set(), x.lo);
  arb_set_arf(at_hi.set(), x.hi);
  f(at_lo.set());
  f(at_hi.set());
  arb_union(y.set(), at_lo.get(), at_hi.get(), bits);
}

// A step function that only rises: floor and the like, exact on numbers.
template <class F> void set_steps(Enclosure& y, const Enclosure& a, slong bits, F f) {
  Ends ends(a.value, bits);
  f(ends.lo);
  f(ends.hi);
  y.continuous = y.continuous && arf_equal(ends.lo, ends.hi);
  arb_set_interval_arf(y.value.set(), ends.lo, ends.hi, bits);
}
// Halves go away from zero.
void round_half_away(arf_t x) {
  if (arf_is_int(x)) return;
  if (arf_cmpabs_2exp_si(x, -1) < 0) return arf_zero(x);
  const bool negative = arf_sgn(x) < 0;
  arf_abs(x, x);
  arf_t half;
  arf_init(half);
  arf_set_d(half, 0.5);
  arf_add(x, x, half, ARF_PREC_EXACT, ARF_RND_DOWN);
  arf_clear(half);
  arf_floor(x, x);
  if (negative) arf_neg(x, x);
}

void cube_root(arb_struct* x, slong bits) {
  const bool negative = arb_is_negative(x);
  arb_abs(x, x);
  if (!arb_is_zero(x)) arb_root_ui(x, x, 3, bits);
  if (negative) arb_neg(x, x);
}

// asin or acos of the part in [-1, 1]; the derivative but for its sign.
template <class F>
void set_arc(Enclosure& y, const Enclosure& a, arb_struct* derivative, slong bits, bool sloped, F f) {
  Ball one(1), size;
  arb_abs(size.set(), a.value.get());
  if (arb_gt(size.get(), one.get())) {
    y.empty = true;
    return;
  }
  if (!arb_le(size.get(), one.get())) y.defined = y.continuous = false;
  Ends ends(a.value, bits);
  arf_struct* const both[] = {ends.lo, ends.hi};
  for (arf_struct* end : both) {
    if (arf_cmp_si(end, 1) > 0) arf_set_si(end, 1);
    if (arf_cmp_si(end, -1) < 0) arf_set_si(end, -1);
  }
  set_monotone(y.value, ends, bits, f);
  if (!sloped) return;
  arb_sqr(derivative, a.value.get(), bits);
  arb_sub(derivative, one.get(), derivative, bits);
  arb_rsqrt(derivative, derivative, bits);
}

}  // namespace

void set_power(Enclosure& y, const Ball& a, const fmpz* n, arb_struct* derivative, slong bits, bool sloped) {
  if (fmpz_sgn(n) < 0 && arb_contains_zero(a.get())) {
    y.empty = y.empty || a.is_zero();
    make_unknown(y);
    if (sloped) arb_zero_pm_inf(derivative);
    return;
  }
  arb_pow_fmpz(y.value.set(), a.get(), n, bits);
  if (fmpz_is_even(n)) arb_nonnegative_part(y.value.set(), y.value.get());
  if (!sloped) return;
  Rational less;
  fmpz_sub_ui(fmpq_numref(less.set()), n, 1);
  if (fmpz_is_zero(n)) {
    arb_zero(derivative);
    return;
  }
  arb_pow_fmpz(derivative, a.get(), fmpq_numref(less.get()), bits);
  arb_mul_fmpz(derivative, derivative, n, bits);
}

Enclosure unary(Op op, int n, const Enclosure& a, slong bits, bool want_slope) {
  Enclosure y = decorated_as(a, a);
  const bool sloped = want_slope && !a.slope.is_zero();
  Ball derivative;
  arb_struct *const v = y.value.set(), *const d = derivative.set();
  const arb_struct* const x = a.value.get();
  switch (op) {
    case Op::negate:
      arb_neg(v, x);
      arb_set_si(d, -1);
      break;
    case Op::abs:
      arb_abs(v, x);
      arb_sgn(d, x);
      break;
    case Op::sign: set_steps(y, a, bits, [](arf_t z) { arf_set_si(z, arf_sgn(z)); }); break;
    case Op::square:
      arb_sqr(v, x, bits);
      arb_nonnegative_part(v, v);
      arb_mul_2exp_si(d, x, 1);
      break;
    case Op::power: {
      Rational exponent;
      fmpq_set_si(exponent.set(), n, 1);
      set_power(y, a.value, fmpq_numref(exponent.get()), d, bits, sloped);
      break;
    }
    case Op::chebyshev:
      arb_chebyshev_t_ui(v, static_cast<ulong>(n), x, bits);
      if (sloped && n > 0) {
        arb_chebyshev_u_ui(d, static_cast<ulong>(n - 1), x, bits);
        arb_mul_si(d, d, n, bits);
      }
      break;
    case Op::sqrt:
      if (arb_is_negative(x)) y.empty = true;
      if (!arb_is_nonnegative(x)) y.defined = y.continuous = false;
      arb_sqrtpos(v, x, bits);
      if (sloped) {
        arb_mul_2exp_si(d, v, 1);
        arb_inv(d, d, bits);
      }
      break;
    case Op::cbrt:
      set_monotone(y.value, Ends(a.value, bits), bits, [&](arb_struct* z) { cube_root(z, bits); });
      if (sloped) {
        arb_sqr(d, v, bits);
        arb_mul_ui(d, d, 3, bits);
        arb_inv(d, d, bits);
      }
      break;
    case Op::exp:
      arb_exp(v, x, bits);
      arb_set(d, v);
      break;
    case Op::log:
    case Op::log10:
      if (!arb_is_positive(x)) {
        y.empty = y.empty || arb_is_nonpositive(x);
        make_unknown(y);
        break;
      }
      if (op == Op::log) arb_log(v, x, bits);
      else arb_log_base_ui(v, x, 10, bits);
      if (sloped) {
        arb_one(d);
        if (op == Op::log10) arb_const_log10(d, bits);
        arb_mul(d, d, x, bits);
        arb_inv(d, d, bits);
      }
      break;
    case Op::sin: arb_sin_cos(v, d, x, bits); break;
    case Op::cos:
      arb_sin_cos(d, v, x, bits);
      arb_neg(d, d);
      break;
    case Op::tan:
      arb_sin_cos(v, d, x, bits);
      if (arb_contains_zero(d)) {
        make_unknown(y);
        break;
      }
      arb_div(v, v, d, bits);
      arb_sqr(d, v, bits);
      arb_add_ui(d, d, 1, bits);
      break;
    case Op::asin: set_arc(y, a, d, bits, sloped, [&](arb_struct* z) { arb_asin(z, z, bits); }); break;
    case Op::acos:
      set_arc(y, a, d, bits, sloped, [&](arb_struct* z) { arb_acos(z, z, bits); });
      arb_neg(d, d);
      break;
    case Op::atan:
      arb_atan(v, x, bits);
      if (sloped) {
        arb_sqr(d, x, bits);
        arb_add_ui(d, d, 1, bits);
        arb_inv(d, d, bits);
      }
      break;
    case Op::sinh: arb_sinh_cosh(v, d, x, bits); break;
    case Op::cosh: arb_sinh_cosh(d, v, x, bits); break;
    case Op::tanh:
      arb_tanh(v, x, bits);
      arb_sqr(d, v, bits);
      arb_sub_ui(d, d, 1, bits);
      arb_neg(d, d);
      break;
    case Op::floor: set_steps(y, a, bits, [](arf_t z) { arf_floor(z, z); }); break;
    case Op::ceil: set_steps(y, a, bits, [](arf_t z) { arf_ceil(z, z); }); break;
    default: set_steps(y, a, bits, round_half_away); break;
  }
  if (sloped) arb_mul(y.slope.set(), a.slope.get(), d, bits);
  return y;
}

}  // namespace isocast::reference
