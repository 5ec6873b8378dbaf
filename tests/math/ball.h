// Arb's balls as values: the truth that inclusions are held against.
#pragma once

#include <arb.h>
#include <math/inclusion_names.h>

namespace isocast::test {

/// A real number known to about 200 bits (fewer where its size is beyond Arb), or not a number.
class Ball {
 public:
  Ball() { arb_init(value_); }
  explicit Ball(double x) : Ball() { arb_set_d(value_, x); }
  Ball(const Ball& other) : Ball() { arb_set(value_, other.value_); }
  Ball& operator=(const Ball& other) {
    arb_set(value_, other.value_);
    return *this;
  }
  ~Ball() { arb_clear(value_); }

  [[nodiscard]] bool is_number() const { return !arf_is_nan(arb_midref(value_)); }
  /// Certainly outside [lo, hi].
  [[nodiscard]] bool outside(double lo, double hi) const {
    const Ball low(lo), high(hi);
    return arb_lt(value_, low.value_) || arb_gt(value_, high.value_);
  }
  [[nodiscard]] const arb_struct* get() const { return value_; }
  [[nodiscard]] arb_struct* set() { return value_; }

 private:
  arb_t value_;
};

/// The same operation as apply() of inclusion_operations.h, on real numbers; not a number where it is
/// undefined or, of operands that are not exact, undecided.
[[nodiscard]] Ball truth(Inclusion operation, const Ball& a, const Ball& b, int n);

/// a b + c.
[[nodiscard]] Ball multiply_add(const Ball& a, const Ball& b, const Ball& c);

}  // namespace isocast::test
