// Polynomials over [0, 1] by their Bernstein coefficients, one a lane.
#pragma once

#include <isocast/math/real.h>

namespace isocast {

/// Degrees of frustum forms: above it, they come in parts of a smaller degree.
inline constexpr int kMostFormDegree = 24;
/// Degrees up to this have loops of their own.
inline constexpr int kMostUnrolled = 18;

/// of[n][k]: n over k, exact.
struct Binomials {
  double of[kMostFormDegree + 1][kMostFormDegree + 1] = {};
  constexpr Binomials() {
    for (int n = 0; n <= kMostFormDegree; ++n) {
      of[n][0] = of[n][n] = 1;
      for (int k = 1; k < n; ++k) of[n][k] = of[n - 1][k - 1] + of[n - 1][k];
    }
  }
};
inline constexpr Binomials kBinomials;

}  // namespace isocast

namespace isocast::inline ISO_ISA {

/// The coefficients of both parts of a polynomial of degree d, divided at s by de Casteljau's algorithm: each
/// of them is a mean of the given ones. kDegree 0: any degree.
template <int kDegree, Real R> inline void divide(const R* c, int d, R s, R* left, R* right) {
  const int n = kDegree ? kDegree : d;
  const R before = R(1) - s;
#pragma GCC unroll 24
  for (int i = 0; i <= n; ++i) right[i] = c[i];
  left[0] = c[0];
#pragma GCC unroll 24
  for (int r = 1; r <= n; ++r) {
#pragma GCC unroll 24
    for (int i = 0; i <= n - r; ++i) right[i] = before * right[i] + s * right[i + 1];
    left[r] = right[0];
  }
}

/// The part [0, s] alone, in place.
template <int kDegree, Real R> inline void keep_left(R* c, int d, R s) {
  const int n = kDegree ? kDegree : d;
  const R before = R(1) - s;
#pragma GCC unroll 24
  for (int r = 1; r <= n; ++r)
#pragma GCC unroll 24
    for (int i = n; i >= r; --i) c[i] = before * c[i - 1] + s * c[i];
}

/// The part [s, 1] alone, in place.
template <int kDegree, Real R> inline void keep_right(R* c, int d, R s) {
  const int n = kDegree ? kDegree : d;
  const R before = R(1) - s;
#pragma GCC unroll 24
  for (int r = 1; r <= n; ++r)
#pragma GCC unroll 24
    for (int i = 0; i <= n - r; ++i) c[i] = before * c[i] + s * c[i + 1];
}

/// The three for one degree.
template <Real R> struct BezierLoops {
  void (*divide)(const R* c, int d, R s, R* left, R* right);
  void (*keep_left)(R* c, int d, R s);
  void (*keep_right)(R* c, int d, R s);
};
#ifndef ISO_DEGREE
template <Real R, int kDegree>
inline constexpr BezierLoops<R> kBezierLoops = {divide<kDegree, R>, keep_left<kDegree, R>,
                                                keep_right<kDegree, R>};

template <Real R>
inline constexpr BezierLoops<R> kBezierTable[kMostUnrolled + 1] = {
    kBezierLoops<R, 0>,  kBezierLoops<R, 1>,  kBezierLoops<R, 2>,  kBezierLoops<R, 3>,  kBezierLoops<R, 4>,
    kBezierLoops<R, 5>,  kBezierLoops<R, 6>,  kBezierLoops<R, 7>,  kBezierLoops<R, 8>,  kBezierLoops<R, 9>,
    kBezierLoops<R, 10>, kBezierLoops<R, 11>, kBezierLoops<R, 12>, kBezierLoops<R, 13>, kBezierLoops<R, 14>,
    kBezierLoops<R, 15>, kBezierLoops<R, 16>, kBezierLoops<R, 17>, kBezierLoops<R, 18>};
#endif

/// A polynomial of a degree up to kMostFormDegree.
template <Real R> struct Bezier {
  int degree;
  R c[kMostFormDegree + 1];

  BezierLoops<R> loops() const {
#ifdef ISO_DEGREE
    // compiled for one degree
    return {isocast::divide<ISO_DEGREE, R>, isocast::keep_left<ISO_DEGREE, R>,
            isocast::keep_right<ISO_DEGREE, R>};
#else
    return kBezierTable<R>[degree <= kMostUnrolled ? degree : 0];
#endif
  }
  void divide(R s, Bezier& left, Bezier& right) const {
    left.degree = right.degree = degree;
    loops().divide(c, degree, s, left.c, right.c);
  }
  void keep_left(R s) { loops().keep_left(c, degree, s); }
  void keep_right(R s) { loops().keep_right(c, degree, s); }

  /// The value at s of [0, 1], and the slope: BezierValues is for more than one.
  R at(R s) const;
  R slope_at(R s) const;
  R largest() const {
    R size = abs(c[0]);
    for (int k = 1; k <= degree; ++k) size = max(size, abs(c[k]));
    return size;
  }
  /// All coefficients on one side of zero, by more than `margin`: no root.
  Mask<R> keeps_sign(R margin) const {
    R lo = c[0], hi = c[0];
    for (int k = 1; k <= degree; ++k) lo = min(lo, c[k]), hi = max(hi, c[k]);
    return (lo > margin) | (hi < -margin);
  }
  /// Two neighbours differ in sign.
  Mask<R> changes_sign() const {
    const Mask<R> first = negative(c[0]);
    Mask<R> changes = Mask<R>(false);
    for (int k = 1; k <= degree; ++k) changes = changes | (negative(c[k]) != first);
    return changes;
  }
};

template <Real R> inline void assign(Bezier<R>& to, Mask<R> where, const Bezier<R>& from) {
  for (int k = 0; k <= to.degree; ++k) to.c[k] = select(where, from.c[k], to.c[k]);
}

/// A polynomial and its slope anywhere in [0, 1], from coefficients and their differences times binomials.
template <Real R> class BezierValues {
 public:
  explicit BezierValues(const Bezier<R>& p) : degree_(p.degree) {
    using T = Scalar<R>;
    const int d = degree_;
    values_[0] = p.c[0], slopes_[0] = R(T(d)) * (p.c[1] - p.c[0]);
    for (int k = 1; k <= d; ++k) values_[k] = R(T(kBinomials.of[d][k])) * p.c[k];
    for (int k = 1; k < d; ++k) slopes_[k] = R(T(d * kBinomials.of[d - 1][k])) * (p.c[k + 1] - p.c[k]);
  }
  /// Within 4 degree unit roundoffs of the largest coefficient.
  R at(R s) const { return sum(values_, degree_, s); }
  R slope_at(R s) const { return sum(slopes_, degree_ - 1, s); }
  /// Both, with the bits of each.
  void find(R s, R& value, R& slope) const {
    const R before = R(1) - s;
    R power = R(1);
    value = values_[0], slope = slopes_[0];
    for (int k = 1; k < degree_; ++k) {
      power = power * s;
      value = value * before + power * values_[k];
      slope = slope * before + power * slopes_[k];
    }
    value = value * before + power * s * values_[degree_];
  }

 private:
  static R sum(const R* c, int d, R s) {
    const R before = R(1) - s;
    R power = R(1), sum = c[0];
    for (int k = 1; k <= d; ++k) {
      power = power * s;
      sum = sum * before + power * c[k];
    }
    return sum;
  }

  int degree_;
  R values_[kMostFormDegree + 1], slopes_[kMostFormDegree + 1];
};
template <Real R> inline R Bezier<R>::at(R s) const { return BezierValues<R>(*this).at(s); }
template <Real R> inline R Bezier<R>::slope_at(R s) const { return BezierValues<R>(*this).slope_at(s); }

/// The first zero of the control polygon, s, between coefficients k - 1 and k.
template <Real R> struct PolygonZero {
  Mask<R> found;
  R s, k;
  R changes;  // of sign, in all
};
template <Real R> inline PolygonZero<R> polygon_zero(const Bezier<R>& p) {
  using T = Scalar<R>;
  PolygonZero<R> zero{Mask<R>(false), R(0), R(0), R(0)};
  R before = p.c[0], behind = p.c[0];
  for (int k = p.degree; k >= 1; --k) {
    const Mask<R> here = negative(p.c[k - 1]) != negative(p.c[k]);
    zero.found = zero.found | here;
    zero.changes = zero.changes + select(here, R(1), R(0));
    zero.k = select(here, R(T(k)), zero.k);
    before = select(here, p.c[k - 1], before);
    behind = select(here, p.c[k], behind);
  }
  const R share = before / (before - behind);
  zero.s = ((zero.k - R(1)) + select(share == share, share, R(0))) / R(T(p.degree));
  return zero;
}

}  // namespace isocast::inline ISO_ISA
