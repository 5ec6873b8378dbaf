// A ray in grid space without any rounding, and the cells' part of it.
#pragma once

#include <isocast/apps/reference/chord_cubic.h>
#include <isocast/math/transform.h>

#include <array>
#include <compare>
#include <cstdint>
#include <optional>

namespace isocast::reference {

/// n/d with d > 0, not reduced.
struct Fraction {
  mpz_class n, d;
  friend std::strong_ordering operator<=>(const Fraction& a, const Fraction& b) {
    return cmp(a.n * b.d, b.n * a.d) <=> 0;
  }
  friend bool operator==(const Fraction& a, const Fraction& b) { return a <=> b == 0; }
};
[[nodiscard]] Fraction fraction(double x);
/// The doubles at or beside x.
[[nodiscard]] double floor_double(const Fraction& x);
[[nodiscard]] double ceil_double(const Fraction& x);

using Cell = std::array<std::int32_t, 3>;

/// in <= t <= out.
struct LineRange {
  Fraction in, out;
};
/// in + s (out - in) for s = n/2^bits.
[[nodiscard]] Fraction point_of(const LineRange& range, const mpz_class& n, int bits);

/// The same line by rounded numbers, from its point nearest to some center: its coordinates within 2^-50 of
/// themselves, those of d too; the largest of d lies between 1/2 and 1, unless d is zero.
struct RoundedLine {
  double o[3], d[3];
};

/// p(t) = M (o + t d, 1) of a ray in world space and the stored matrix M = grid_from_world: all of it as it
/// stands.
class ExactLine {
 public:
  /// All numbers are finite.
  ExactLine(const Transform& grid_from_world, const Double3& o, const Double3& d);

  [[nodiscard]] RoundedLine near(const Double3& center) const;
  /// The part of [range.in, range.out] in the closed cell; nothing where that is a point or empty.
  [[nodiscard]] std::optional<LineRange> within(const Cell& cell, const LineRange& range) const;
  /// Entry and exit of a part in the cell's coordinates; `f` is left to the caller.
  [[nodiscard]] ExactChord chord(const Cell& cell, const LineRange& range) const;

 private:
  // times 2^shift_
  mpz_class o_[3], d_[3];
  int shift_;
};

}  // namespace isocast::reference
