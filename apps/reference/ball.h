// Arb's balls as values: real numbers that are known to some accuracy.
#pragma once

#include <arb.h>

namespace isocast::reference {

/// Every number between middle - radius and middle + radius, or not a number. Exact where the radius is zero.
class Ball {
 public:
  Ball() { arb_init(value_); }
  explicit Ball(double x) : Ball() { arb_set_d(value_, x); }
  Ball(const Ball& other) : Ball() { arb_set(value_, other.value_); }
  Ball(Ball&& other) noexcept : Ball() { arb_swap(value_, other.value_); }
  Ball& operator=(const Ball& other) {
    arb_set(value_, other.value_);
    return *this;
  }
  Ball& operator=(Ball&& other) noexcept {
    arb_swap(value_, other.value_);
    return *this;
  }
  ~Ball() { arb_clear(value_); }

  [[nodiscard]] bool is_number() const { return !arf_is_nan(arb_midref(value_)); }
  [[nodiscard]] bool is_finite() const { return arb_is_finite(value_); }
  [[nodiscard]] bool is_zero() const { return arb_is_zero(value_); }
  /// 1 or -1 where all numbers of the ball have that sign, else 0.
  [[nodiscard]] int sign() const { return arb_is_positive(value_) ? 1 : arb_is_negative(value_) ? -1 : 0; }
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

}  // namespace isocast::reference
