#include <isocast/apps/reference/enclosure_parts.h>

namespace isocast::reference {
namespace {

void make_known(Ball& ball) {
  if (!ball.is_finite()) arb_zero_pm_inf(ball.set());
}

Enclosure choose(const Enclosure& c, const Enclosure& a, const Enclosure& b, slong bits) {
  const bool always = c.value.sign() != 0, never = c.value.is_zero();
  Enclosure y = always ? a : b;
  if (!always && !never) {
    y = a.empty ? b : a;
    if (!a.empty && !b.empty) arb_union(y.value.set(), a.value.get(), b.value.get(), bits);
    y.defined = a.defined && b.defined;
    y.continuous = false;
    y.empty = a.empty && b.empty;
  }
  y.defined = y.defined && c.defined;
  y.continuous = y.continuous && c.defined;
  y.empty = y.empty || c.empty;
  return y;
}

}  // namespace

Enclosure enclosure_of(const Ball& value, const Ball& slope) { return {value, slope}; }

Enclosure apply(Op op, int n, const Enclosure& a, const Enclosure& b, const Enclosure& c, slong bits,
                bool sloped) {
  Enclosure y = operand_count(op) == 1   ? unary(op, n, a, bits, sloped)
                : operand_count(op) == 2 ? binary(op, a, b, bits, sloped)
                                         : choose(a, b, c, bits);
  make_known(y.value);
  make_known(y.slope);
  return y;
}

}  // namespace isocast::reference
