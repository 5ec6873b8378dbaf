// Certified: marmitt's root, with a proof that it is one and the first, or that there is none.
#pragma once

#include <isocast/math/rounding.h>
#include <isocast/volume/cell/marmitt.h>

namespace isocast::inline ISO_ISA {

/// The cubic's coefficients over [a, b], a <= b: averages of those over [0, 1].
template <Real R> ISO_HD inline BernsteinCubic<R> part_of(const BernsteinCubic<R>& p, R a, R b) {
  const R a0 = lerp(p.c0, p.c1, a), a1 = lerp(p.c1, p.c2, a), a2 = lerp(p.c2, p.c3, a);
  const R b0 = lerp(p.c0, p.c1, b), b1 = lerp(p.c1, p.c2, b), b2 = lerp(p.c2, p.c3, b);
  const R aa0 = lerp(a0, a1, a), aa1 = lerp(a1, a2, a), bb0 = lerp(b0, b1, b), bb1 = lerp(b1, b2, b);
  return {lerp(aa0, aa1, a), lerp(aa0, aa1, b), lerp(bb0, bb1, a), lerp(bb0, bb1, b)};
}

/// How far any coefficient of the cubic, or of a part of it, is from the true one: 13 unit roundoffs of the
/// largest corner for cubic_along, 9 for part_of, and for a chord whose ends are off by `slack` the largest
/// slope of an average of corners in three directions, for each of its factors.
template <Real R> ISO_HD inline R coefficient_error(const Cell<R>& cell) {
  using T = Scalar<R>;
  R largest = abs(cell.f[0]);
  for (int i = 1; i < 8; ++i) largest = max(largest, abs(cell.f[i]));
  return largest * (R(T(32) * kUnitRoundoff<T>) + R(7) * cell.slack) + R(T(64) * kSmallest<T>);
}

/// All coefficients above `error`, or below its negative: there is no root. Not so where one is NaN, of
/// corners whose sums overflow.
template <Real R> ISO_HD inline Mask<R> has_one_sign(const BernsteinCubic<R>& p, R error) {
  return ((p.c0 > error) & (p.c1 > error) & (p.c2 > error) & (p.c3 > error)) |
         ((p.c0 < -error) & (p.c1 < -error) & (p.c2 < -error) & (p.c3 < -error));
}
/// The same of the derivative, where the ends have different signs: there is one root.
template <Real R> ISO_HD inline Mask<R> has_one_root(const BernsteinCubic<R>& p, R error) {
  const R d0 = p.c1 - p.c0, d1 = p.c2 - p.c1, d2 = p.c3 - p.c2, least = R(4) * error;
  const Mask<R> rises = (d0 > least) & (d1 > least) & (d2 > least) & (p.c0 < -error) & (p.c3 > error),
                falls = (d0 < -least) & (d1 < -least) & (d2 < -least) & (p.c0 > error) & (p.c3 < -error);
  return rises | falls;
}

/// Parts shorter than this fraction of the chord are not divided.
template <class T> inline constexpr T kLeastPart = T(0);
template <> inline constexpr float kLeastPart<float> = 0x1p-16f;
template <> inline constexpr double kLeastPart<double> = 0x1p-40;

inline constexpr int kMostParts = 256;

/// Whether p has no root from `begin` to `end`: part after part, each twice or half as long as the one
/// before.
template <Real R>
ISO_HD inline Mask<R> has_none(const BernsteinCubic<R>& p, R begin, R end, R error, Mask<R> active) {
  Mask<R> proved = Mask<R>(false);
  R at = begin, part = end - begin;
  for (int round = 0; round < kMostParts && any(active); ++round) {
    const R to = select(at + part < end, at + part, end);
    const Mask<R> clear = active & has_one_sign(part_of(p, at, to), error);
    proved = proved | (clear & (to >= end));
    at = select(clear, to, at);
    part = select(clear, R(2) * part, R(0.5) * part);
    active = active & !proved & (part > R(kLeastPart<Scalar<R>>));
  }
  return proved;
}

/// Half a bracket is shorter than this fraction of the chord.
inline constexpr float kWidest = 0x1p-8f;

/// marmitt's answer (stable, adaptive), `proved` where there is no root in [begin, 1], or none before s_lo
/// and exactly one between s_lo and s_hi, of f as it is: nothing was rounded, and the ends of the chord may
/// lie up to `slack` elsewhere. The bracket is as wide as the proof needs, less than 2^-7 of the chord.
///
/// The signs of four Bernstein coefficients, which are averages of corner values, decide most cells.
/// source  Farouki, Rajan: On the numerical condition of polynomials in Bernstein form, 1987, for the bounds;
///         the method is ours
template <Real R> ISO_HD inline Root<R> certified(const Cell<R>& cell, const CellOptions& options) {
  using T = Scalar<R>;
  const BernsteinCubic<R> p = cubic_along(cell);
  const R error = coefficient_error(cell);
  // a carried sign that contradicts the coefficients is marmitt's to interpret
  const Mask<R> contradicts = (cell.carry == cell.carry) & (negative(cell.carry) != negative(p.c0));
  const Mask<R> empty = has_one_sign(p, error) & !contradicts, open = !empty;
  if (!any(open)) return {R(0), R(0), R(0), Mask<R>(false), Mask<R>(false), Mask<R>(false), empty};

  Root<R> root = first_root(p, cell, options);
  R lo = root.s_lo, hi = root.s_hi, width = max(hi - lo, R(kTolerance<T>));
  Mask<R> wide = root.hit & open & (width < R(T(kWidest)));
  for (; any(wide); width = R(4) * width) {
    const R from = max(cell.begin, root.s - width), to = min(R(1), root.s + width);
    const Mask<R> found = wide & has_one_root(part_of(p, from, to), error);
    lo = select(found, from, lo);
    hi = select(found, to, hi);
    root.proved = root.proved | found;
    wide = wide & !found & (R(4) * width < R(T(kWidest)));
  }
  const R end = select(root.hit, lo, R(1));
  const Mask<R> missed = !root.hit;
  const Mask<R> none = has_none(p, cell.begin, end, error, open & (root.proved | missed));
  root.proved = empty | none;
  root.s_lo = select(root.proved, lo, root.s_lo);
  root.s_hi = select(root.proved, hi, root.s_hi);
  return root;
}

}  // namespace isocast::inline ISO_ISA
