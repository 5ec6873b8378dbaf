#include <isocast/apps/reference/bracket.h>

#include <algorithm>
#include <cmath>

namespace isocast::reference {
namespace {

// Where the chord meets zero, in [0, 1].
double chord_zero(const Ball& f_lo, const Ball& f_hi) {
  Ball part;
  arf_struct* const at = arb_midref(part.set());
  arf_sub(at, arb_midref(f_lo.get()), arb_midref(f_hi.get()), 64, ARF_RND_NEAR);
  arf_div(at, arb_midref(f_lo.get()), at, 64, ARF_RND_NEAR);
  const double zero = arf_get_d(at, ARF_RND_NEAR);
  return zero >= 0 && zero <= 1 ? zero : 0.5;
}

}  // namespace

Ball between(const Ball& lo, const Ball& hi, double part) {
  Ball point;
  const Ball exact_part(part);
  arb_sub(point.set(), hi.get(), lo.get(), ARF_PREC_EXACT);
  arb_mul(point.set(), point.get(), exact_part.get(), ARF_PREC_EXACT);
  arb_add(point.set(), point.get(), lo.get(), ARF_PREC_EXACT);
  return point;
}

bool is_within(const Ball& lo, const Ball& hi, double width) {
  Ball length;
  const Ball most(width);
  arb_sub(length.set(), hi.get(), lo.get(), ARF_PREC_EXACT);
  return arb_le(length.get(), most.get());
}

Bracket refine(const ValueAt& value_at, Bracket root, Ball f_lo, Ball f_hi, double width) {
  int step = 1, failures = 0;
  while (!is_within(root.lo, root.hi, width) && failures < 4) {
    // guess by the chord in which of 2^step parts the root lies; the fourths are no points that f is likely
    // to vanish at
    const double parts = std::ldexp(1.0, step);
    const double part = std::clamp(std::floor(parts * chord_zero(f_lo, f_hi) - 0.5), 0.0, parts - 2);
    const double first = part + 0.5 - 0.0625 * failures;
    const Ball ends[] = {between(root.lo, root.hi, first / parts),
                         between(root.lo, root.hi, (first + 1) / parts)};
    bool right_guess = true, known = false;
    for (const Ball& s : ends) {
      Ball f = value_at(s);
      if (f.is_zero()) return {s, s};
      if (f.sign() == 0) continue;
      known = true;
      const bool before_root = f.sign() == f_lo.sign();
      right_guess = right_guess && before_root == (&s == ends);
      (before_root ? root.lo : root.hi) = s;
      (before_root ? f_lo : f_hi) = std::move(f);
      if (!before_root) break;
    }
    failures = known ? 0 : failures + 1;
    step = right_guess && known ? std::min(2 * step, 40) : std::max(1, step / 2);
  }
  return root;
}

}  // namespace isocast::reference
