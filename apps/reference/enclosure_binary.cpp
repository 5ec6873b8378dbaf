#include <isocast/apps/reference/enclosure_parts.h>

namespace isocast::reference {
namespace {

// Whole exponents of more bits than the first take longer as powers than by logarithms, where these exist;
// all whole doubles are below the second, and what is far above would fill the memory as an integer.
constexpr slong kQuickExponentBits = 64, kMaxExponentBits = 2000;

// a^b for a real b.
void set_pow(Enclosure& y, const Enclosure& a, const Enclosure& b, slong bits, bool sloped) {
  Rational whole;
  if (b.slope.is_zero() && arb_is_exact(b.value.get()) &&
      arf_cmpabs_2exp_si(arb_midref(b.value.get()),
                         a.value.sign() > 0 ? kQuickExponentBits : kMaxExponentBits) < 0 &&
      arb_get_unique_fmpz(fmpq_numref(whole.set()), b.value.get())) {
    Ball derivative;
    set_power(y, a.value, fmpq_numref(whole.get()), derivative.set(), bits, sloped);
    if (sloped) arb_mul(y.slope.set(), a.slope.get(), derivative.get(), bits);
    return;
  }
  if (a.value.sign() > 0) {
    // y (b' log a + b a' / a)
    arb_pow(y.value.set(), a.value.get(), b.value.get(), bits);
    if (!sloped) return;
    Ball part;
    arb_log(y.slope.set(), a.value.get(), bits);
    arb_mul(y.slope.set(), y.slope.get(), b.slope.get(), bits);
    arb_div(part.set(), a.slope.get(), a.value.get(), bits);
    arb_addmul(y.slope.set(), part.get(), b.value.get(), bits);
    arb_mul(y.slope.set(), y.slope.get(), y.value.get(), bits);
    return;
  }
  // the part of a from 0 on
  const bool no_integer = !arb_contains_int(b.value.get()), positive = b.value.sign() > 0;
  const bool no_negative = arb_is_nonnegative(a.value.get());
  y.empty = y.empty || (no_integer && a.value.sign() < 0);
  if (!positive || !(no_integer || no_negative)) {
    make_unknown(y);
    return;
  }
  if (!no_negative) y.defined = y.continuous = false;
  Ball zero, largest;
  const Ends ends(a.value, bits);
  arb_set_arf(largest.set(), ends.hi);
  arb_pow(y.value.set(), largest.get(), b.value.get(), bits);
  arb_union(y.value.set(), y.value.get(), zero.get(), bits);
  arb_zero_pm_inf(y.slope.set());
}

// The angle of the point (x, b).
void set_atan2(Enclosure& y, const Enclosure& b, const Enclosure& x, slong bits, bool sloped) {
  arb_atan2(y.value.set(), b.value.get(), x.value.get(), bits);
  const bool on_axis = b.value.is_zero() && (x.value.sign() < 0 || x.value.is_zero());
  if (x.value.sign() <= 0 && b.value.sign() == 0 && !on_axis) y.continuous = false;
  if (!sloped) return;
  Ball square;
  arb_sqr(square.set(), x.value.get(), bits);
  arb_addmul(square.set(), b.value.get(), b.value.get(), bits);
  arb_mul(y.slope.set(), x.value.get(), b.slope.get(), bits);
  arb_submul(y.slope.set(), b.value.get(), x.slope.get(), bits);
  arb_div(y.slope.set(), y.slope.get(), square.get(), bits);
}

}  // namespace

Enclosure binary(Op op, const Enclosure& a, const Enclosure& b, slong bits, bool want_slope) {
  Enclosure y = decorated_as(a, b);
  const bool sloped = want_slope && !(a.slope.is_zero() && b.slope.is_zero());
  arb_struct *const v = y.value.set(), *const s = y.slope.set();
  const arb_struct *const x = a.value.get(), *const z = b.value.get();
  switch (op) {
    case Op::add:
      arb_add(v, x, z, bits);
      if (sloped) arb_add(s, a.slope.get(), b.slope.get(), bits);
      break;
    case Op::subtract:
      arb_sub(v, x, z, bits);
      if (sloped) arb_sub(s, a.slope.get(), b.slope.get(), bits);
      break;
    case Op::multiply:
      arb_mul(v, x, z, bits);
      if (!sloped) break;
      if (!b.slope.is_zero()) arb_mul(s, x, b.slope.get(), bits);
      if (!a.slope.is_zero()) arb_addmul(s, a.slope.get(), z, bits);
      break;
    case Op::divide:
      if (arb_contains_zero(z)) {
        y.empty = y.empty || b.value.is_zero();
        make_unknown(y);
        break;
      }
      arb_div(v, x, z, bits);
      if (!sloped) break;
      if (!b.slope.is_zero()) arb_mul(s, v, b.slope.get(), bits);
      arb_sub(s, a.slope.get(), s, bits);
      arb_div(s, s, z, bits);
      break;
    case Op::min:
    case Op::max: {
      const bool first = op == Op::min ? arb_le(x, z) : arb_ge(x, z),
                 second = op == Op::min ? arb_gt(x, z) : arb_lt(x, z);
      if (op == Op::min) arb_min(v, x, z, bits);
      else arb_max(v, x, z, bits);
      if (!sloped) break;
      if (first || second) y.slope = first ? a.slope : b.slope;
      else arb_union(s, a.slope.get(), b.slope.get(), bits);
      break;
    }
    case Op::pow: set_pow(y, a, b, bits, sloped); break;
    case Op::atan2: set_atan2(y, a, b, bits, sloped); break;
    default: {  // step
      const bool always = arb_ge(z, x), never = arb_lt(z, x);
      y.continuous = y.continuous && (always || never);
      arb_set_d(v, always ? 1 : never ? 0 : 0.5);
      if (!always && !never) arb_add_error_2exp_si(v, -1);
      break;
    }
  }
  return y;
}

}  // namespace isocast::reference
