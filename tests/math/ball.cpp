#include <isocast/apps/reference/enclosure.h>
#include <math/ball.h>
#include <math/inclusion_op.h>

#include <cstdlib>

namespace isocast::test {

namespace {

constexpr slong kBits = 200;

Ball value_of(Op op, const Ball& a, const Ball& b, const Ball& c, int n) {
  using reference::enclosure_of;
  reference::Enclosure y =
      reference::apply(op, n, enclosure_of(a), enclosure_of(b), enclosure_of(c), kBits, false);
  if (y.empty || !y.defined) arb_indeterminate(y.value.set());
  return y.value;
}

}  // namespace

Ball truth(Inclusion operation, const Ball& a, const Ball& b, int n) {
  if (!a.is_number()) return a;
  if (operation >= Inclusion::add && !b.is_number()) return b;
  switch (operation) {
    case Inclusion::hypot: {
      Ball y;
      arb_hypot(y.set(), a.get(), b.get(), kBits);
      return y;
    }
    case Inclusion::mod: {
      const Ball whole = truth(Inclusion::floor, truth(Inclusion::divide, a, b, 0), b, 0);
      return truth(Inclusion::subtract, a, truth(Inclusion::multiply, whole, b, 0), 0);
    }
    case Inclusion::chebyshev: n = std::abs(n); [[fallthrough]];
    default: return value_of(op_of(operation), a, b, a, n);
  }
}

Ball multiply_add(const Ball& a, const Ball& b, const Ball& c) {
  Ball y;
  arb_mul(y.set(), a.get(), b.get(), kBits);
  arb_add(y.set(), y.get(), c.get(), kBits);
  return y;
}

}  // namespace isocast::test
