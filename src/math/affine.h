// Reduced affine arithmetic over any Real: what a form is, and + - * with the rounding in its error term.
#pragma once

#include <isocast/math/interval.h>

namespace isocast::inline ISO_ISA {

/// f(0), f(1) ... f(N-1), with constant indices: so arrays of structs stay in registers.
template <int N, class F> ISO_HD inline void each_symbol(F f) {
  static_assert(N == 1 || N == 3);
  f(0);
  if constexpr (N == 3) f(1), f(2);
}

/// f = c + sum of e[k] E_k + r E, where it is defined: E_k in [-1, 1] the symbols that all forms share (the
/// ray parameter; a beam has three), E in [-1, 1] an error of this form alone.
///
/// c, e  finite; r >= 0, all roundings so far included, or +inf: nothing is known, which is what NaN and
///       overflow become
/// defined, continuous, empty  as in Interval, over all E_k
/// source  Knoll et al. 2009; Messine: Extensions of affine arithmetic, Journal of Universal Computer Science
///         8(11), 2002 (its AF1)
template <Real R, int N> struct AffineForm {
  R c, e[N], r;
  Mask<R> defined, continuous, empty;

  AffineForm() = default;
  /// The constant x.
  ISO_HD explicit AffineForm(R x) : AffineForm(Interval<R>(x)) {}
  ISO_HD explicit AffineForm(Scalar<R> x) requires(kWidth<R> > 1) : AffineForm(R(x)) {}
  /// Anything in [y.lo, y.hi], related to no symbol.
  ISO_HD explicit AffineForm(const Interval<R>& y);
};

/// An upper bound of what two dozen roundings made r, a sum of positive numbers; zero is exact.
template <Real R> ISO_HD inline R raised(R r) { return with_roundings(r, r, 12); }
/// The same with what the products of one operation can lose by underflow.
template <Real R> ISO_HD inline R with_underflow(R r) {
  if constexpr (!kOutward) return r;
  return r + R(Scalar<R>(12) * kSmallest<Scalar<R>>);
}

/// sum |e[k]|, nearly.
template <Real R, int N> ISO_HD inline R spread(const AffineForm<R, N>& a) {
  R sum = R(0);
  each_symbol<N>([&](int k) { sum = sum + abs(a.e[k]); });
  return sum;
}

/// a with its rounding: where it overflowed nothing is known.
template <Real R, int N> ISO_HD inline AffineForm<R, N> settled(AffineForm<R, N> a) {
  using T = Scalar<R>;
  a.r = raised(a.r);
  const Mask<R> known = abs(a.c) + spread(a) + a.r <= R(kLargest<T>);
  a.c = select(known, a.c, R(0));
  each_symbol<N>([&](int k) { a.e[k] = select(known, a.e[k], R(0)); });
  a.r = select(known, a.r, R(kInfinity<T>));
  return a;
}

template <Real R, int N>
ISO_HD inline AffineForm<R, N> decorated_as(const Interval<R>& y, AffineForm<R, N> a) {
  a.defined = y.defined, a.continuous = y.continuous, a.empty = y.empty;
  return a;
}
/// a with the decorations of two operands.
template <Real R, int N>
ISO_HD inline AffineForm<R, N> decorated_as(const AffineForm<R, N>& x, const AffineForm<R, N>& y,
                                            AffineForm<R, N> a) {
  a.defined = x.defined & y.defined, a.continuous = x.continuous & y.continuous, a.empty = x.empty | y.empty;
  return a;
}

template <Real R, int N> ISO_HD inline AffineForm<R, N>::AffineForm(const Interval<R>& y) {
  c = select(y.lo == y.hi, y.lo, R(0.5) * y.lo + R(0.5) * y.hi);
  each_symbol<N>([&](int k) { e[k] = R(0); });
  r = max(y.hi - c, c - y.lo);
  *this = decorated_as(y, settled(*this));
  r = select(y.lo == y.hi, R(0), r);
}

/// An argument from lo to hi that follows the symbol E_k.
template <Real R, int N> ISO_HD inline AffineForm<R, N> affine_argument(R lo, R hi, int k) {
  AffineForm<R, N> a{Interval<R>(lo, hi)};
  a.e[k] = select(a.r <= R(kLargest<Scalar<R>>), a.r, R(0));
  a.r = a.r - a.e[k];
  return a;
}

/// All values of a, with its decorations.
template <Real R, int N> ISO_HD inline Interval<R> interval_of(const AffineForm<R, N>& a) {
  const R radius = raised(spread(a) + a.r);
  return Interval<R>(down_exact_zero(a.c - radius), up_exact_zero(a.c + radius), a.defined, a.continuous,
                     a.empty);
}

/// The same with f's interval kept beside the form: narrower than either, and what either proves.
template <Real R, int N>
ISO_HD inline Interval<R> interval_of(const AffineForm<R, N>& a, const Interval<R>& beside) {
  return intersected(interval_of(a), beside);
}

/// Lane by lane a where m holds, else b.
template <Real R, int N>
ISO_HD inline AffineForm<R, N> select(Mask<R> m, const AffineForm<R, N>& a, const AffineForm<R, N>& b) {
  AffineForm<R, N> y = a;
  y.c = select(m, a.c, b.c);
  each_symbol<N>([&](int k) { y.e[k] = select(m, a.e[k], b.e[k]); });
  y.r = select(m, a.r, b.r);
  y.defined = select(m, a.defined, b.defined);
  y.continuous = select(m, a.continuous, b.continuous);
  y.empty = select(m, a.empty, b.empty);
  return y;
}

/// slope a + offset +- error, error >= 0.
template <Real R, int N>
ISO_HD inline AffineForm<R, N> mapped(const AffineForm<R, N>& a, R slope, R offset, R error) {
  AffineForm<R, N> y = a;
  const R scaled = slope * a.c;
  y.c = scaled + offset;
  each_symbol<N>([&](int k) { y.e[k] = slope * a.e[k]; });
  y.r = with_underflow(with_roundings(abs(slope) * a.r + error, abs(scaled) + abs(y.c) + spread(y)));
  return settled(y);
}

template <Real R, int N> ISO_HD inline AffineForm<R, N> operator-(const AffineForm<R, N>& a) {
  AffineForm<R, N> y = a;
  y.c = -a.c;
  each_symbol<N>([&](int k) { y.e[k] = -a.e[k]; });
  return y;
}
template <Real R, int N>
ISO_HD inline AffineForm<R, N> operator+(const AffineForm<R, N>& a, const AffineForm<R, N>& b) {
  AffineForm<R, N> y = a;
  y.c = a.c + b.c;
  each_symbol<N>([&](int k) { y.e[k] = a.e[k] + b.e[k]; });
  y.r = with_roundings(a.r + b.r, abs(y.c) + spread(y));
  return decorated_as(a, b, settled(y));
}
template <Real R, int N>
ISO_HD inline AffineForm<R, N> operator-(const AffineForm<R, N>& a, const AffineForm<R, N>& b) {
  return a + (-b);
}

/// The linear part exactly; of the rest, a.e[k] b.e[k] E_k^2 lies between 0 and its product: half of it moves
/// to the middle.
template <Real R, int N>
ISO_HD inline AffineForm<R, N> operator*(const AffineForm<R, N>& a, const AffineForm<R, N>& b) {
  AffineForm<R, N> y = a;
  R squares = R(0), half = R(0);
  each_symbol<N>([&](int k) {
    y.e[k] = a.c * b.e[k] + b.c * a.e[k];
    const R product = R(0.5) * (a.e[k] * b.e[k]);
    squares = squares + product;
    half = half + abs(product);
  });
  y.c = a.c * b.c + squares;
  const R spread_a = spread(a), spread_b = spread(b), radius_a = spread_a + a.r, radius_b = spread_b + b.r;
  const R linear = abs(a.c) * spread_b + abs(b.c) * spread_a, quadratic = radius_a * radius_b;
  y.r = with_underflow(with_roundings(abs(a.c) * b.r + abs(b.c) * a.r + max(quadratic - half, R(0)),
                                      abs(a.c * b.c) + linear + R(8) * quadratic));
  return decorated_as(a, b, settled(y));
}

/// Chebyshev's approximation of the square, which is the convex rule in closed form.
template <Real R, int N> ISO_HD inline AffineForm<R, N> square(const AffineForm<R, N>& a) {
  AffineForm<R, N> y = a;
  const R spread_a = spread(a), radius = spread_a + a.r, q = R(0.5) * (radius * radius);
  y.c = a.c * a.c + q;
  each_symbol<N>([&](int k) { y.e[k] = R(2) * (a.c * a.e[k]); });
  const R linear = R(2) * abs(a.c) * spread_a;
  y.r = with_underflow(with_roundings(R(2) * abs(a.c) * a.r + q, a.c * a.c + linear + R(8) * q));
  return settled(y);
}

}  // namespace isocast::inline ISO_ISA
