// What the operations on enclosures share.
#pragma once

#include <isocast/apps/reference/enclosure.h>
#include <isocast/apps/reference/flint_values.h>

namespace isocast::reference {

inline void make_unknown(Enclosure& y) {
  arb_zero_pm_inf(y.value.set());
  arb_zero_pm_inf(y.slope.set());
  y.defined = y.continuous = false;
}

// The decorations of an operation that is continuous everywhere.
inline Enclosure decorated_as(const Enclosure& a, const Enclosure& b) {
  Enclosure y;
  y.defined = a.defined && b.defined;
  y.continuous = a.continuous && b.continuous;
  y.empty = a.empty || b.empty;
  return y;
}

/// Least and largest number of a ball.
struct Ends {
  arf_t lo, hi;
  Ends(const Ball& x, slong bits) {
    arf_init(lo);
    arf_init(hi);
    arb_get_interval_arf(lo, hi, x.get(), bits);
  }
  Ends(const Ends&) = delete;
  Ends& operator=(const Ends&) = delete;
  ~Ends() {
    arf_clear(lo);
    arf_clear(hi);
  }
};

/// a^n and its derivative, of a alone.
void set_power(Enclosure& y, const Ball& a, const fmpz* n, arb_struct* derivative, slong bits, bool sloped);

[[nodiscard]] Enclosure unary(Op op, int n, const Enclosure& a, slong bits, bool want_slope);
[[nodiscard]] Enclosure binary(Op op, const Enclosure& a, const Enclosure& b, slong bits, bool want_slope);

}  // namespace isocast::reference
