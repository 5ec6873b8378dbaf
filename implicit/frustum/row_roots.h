// Sixteen rays of a row of pixels: from their polynomials to their first roots.
#pragma once

#include <isocast/implicit/frustum/find_by_clipping.h>
#include <isocast/implicit/frustum/find_by_knots.h>
#include <isocast/implicit/frustum/find_by_signs.h>
#include <isocast/math/native.h>

namespace isocast::inline ISO_ISA {

/// Rays that are solved together: a thread of a GPU has one.
#ifdef ISO_ONE_RAY
inline constexpr int kRow = 1;
#else
inline constexpr int kRow = 16;
#endif

/// The finder that is asked for: the compiler knows it where kernels are compiled for one (ISO_FINDER).
inline RootFinder finder_of([[maybe_unused]] const FinderOptions& options) {
#ifdef ISO_FINDER
  return RootFinder(ISO_FINDER);
#else
  return options.finder;
#endif
}

template <Real R>
inline FirstRoot<R> find_first(const Bezier<R>& p, const BezierValues<R>& form, const FinderOptions& options,
                               R eps, Doubt<R> doubt, Mask<R> active) {
  switch (finder_of(options)) {
    case RootFinder::mr: return find_by_knots<RootFinder::mr>(p, options, eps, active);
    case RootFinder::lr_mult: return find_by_parts<RootFinder::lr_mult>(p, options, eps, active);
    case RootFinder::mr_mult: return find_by_knots<RootFinder::mr_mult>(p, options, eps, active);
    case RootFinder::schneider: return find_by_parts<RootFinder::schneider>(p, options, eps, active);
    case RootFinder::clip: return find_by_clipping(p, options, eps, active);
    case RootFinder::signs: return find_by_signs(p, form, options, eps, doubt, active);
    default: return find_by_parts<RootFinder::lr>(p, options, eps, active);
  }
}

/// Polynomials f - iso of kRow rays over [0, 1] each, scaled by any power of two.
///
/// c         [k][ray]: Bernstein coefficients, of which each is off by at most the ray's `margin`
/// eps       in [0, 1]
/// active    the ray is there
/// before    the sign in front of 0: 1 for f >= iso, -1 for f < iso, 0 unknown; behind: that behind 1
/// proves    whether proofs are wanted
/// guessed   the roots hold guesses: a hit may be one that can be proved without being searched for
template <class T> struct RowPolynomials {
  int degree;
  T c[kMostFormDegree + 1][kRow];
  T eps[kRow];
  bool active[kRow];
  signed char before[kRow], behind[kRow];
  T margin[kRow];
  bool proves, guessed = false;
};

/// s with the bracket lo, hi; negative: f < iso in front of it. proved: the hit, or that there is none.
struct RowRoots {
  double s[kRow], lo[kRow], hi[kRow];
  float steps[kRow];
  bool hit[kRow], proved[kRow], negative[kRow];
};

template <Real R> inline Mask<R> lanes_where(const bool* flags) {
  using T = Scalar<R>;
  T values[kWidth<R>];
  for (int l = 0; l < kWidth<R>; ++l) values[l] = T(flags[l]);
  return load<R>(values) != R(0);
}
template <Real R> inline void put_where(Mask<R> mask, bool* flags) {
  const unsigned bits = bits_of(mask);
  for (int l = 0; l < kWidth<R>; ++l) flags[l] = bits >> l & 1;
}

/// Roots of the rays that `wanted` names.
template <Real R>
inline void find_row(const RowPolynomials<Scalar<R>>& row, const FinderOptions& options, const bool* wanted,
                     RowRoots& roots) {
  using T = Scalar<R>;
  for (int first = 0; first < kRow; first += kWidth<R>) {
    bool some = false, all[kWidth<R>];
    for (int l = 0; l < kWidth<R>; ++l) some = (all[l] = row.active[first + l] && wanted[first + l]) || some;
    if (!some) continue;
    Bezier<R> p;
    p.degree = row.degree;
    p.c[0] = load<R>(row.c[0] + first);
    for (int k = 1; k <= row.degree; ++k) p.c[k] = load<R>(row.c[k] + first);
    const R size = p.largest(), eps = load<R>(row.eps + first);
    // what evaluating it rounds, and dividing it
    const Doubt<R> doubt{
        load<R>(row.margin + first) * R(T(1.0001)) + R(T(4 * row.degree + 8) * kUnitRoundoff<T>) * size,
        R(T(4 * row.degree) * kUnitRoundoff<T>) * size};
    const BezierValues<R> form(p);
    const Mask<R> active = lanes_where<R>(all);
    const Mask<R> start = negative(p.c[0]);
    // signs that roundings at the ends have hidden
    T before[kWidth<R>], behind[kWidth<R>];
    for (int l = 0; l < kWidth<R>; ++l) before[l] = row.before[first + l], behind[l] = row.behind[first + l];
    const R sign_before = load<R>(before), sign_behind = load<R>(behind);
    const Mask<R> known = sign_before != R(0);
    const Mask<R> at_start =
        active & ((known & (negative(sign_before) != start)) | ((!known) & (p.c[0] == R(0))));

    ProvedRoot<R> root = {R(0), R(0), R(0), Mask<R>(false)};
    if (row.proves && row.guessed) {
      T guesses[kWidth<R>];
      for (int l = 0; l < kWidth<R>; ++l) guesses[l] = T(roots.s[first + l]);
      const Mask<R> tried = active & lanes_where<R>(roots.hit + first) & !at_start;
      if (any(tried)) root = prove_root(p, form, load<R>(guesses), eps, doubt, tried);
    }
    const Mask<R> told = root.proved, sought = active & !told;
    const FirstRoot<R> found =
        any(sought) ? find_first(p, form, options, eps, doubt, sought) : FirstRoot<R>{};
    const Mask<R> at_end = (sought & !(found.hit | at_start)) & (sign_behind != R(0)) &
                           (negative(sign_behind) != negative(p.c[p.degree]));
    const Mask<R> inside = found.hit & !at_start;
    R s = select(at_start, R(0), select(at_end, R(1), found.s)), lo = max(s - eps, R(0)),
      hi = min(s + eps, R(1));
    if (row.proves) {
      if (any(inside)) root.replace(inside, prove_root(p, form, s, eps, doubt, inside, found.sure));
      s = select(told | inside, root.s, s);
      lo = select(told | inside, root.lo, lo), hi = select(told | inside, root.hi, hi);
      const Mask<R> misses = sought & !(found.hit | at_start | at_end);
      root.proved = root.proved | (misses & found.sure);
      const Mask<R> asked = misses & !found.sure;
      if (any(asked)) root.proved = root.proved | is_empty(p, doubt, asked);
    }
    T values[3][kWidth<R>], steps[kWidth<R>];
    store(values[0], s), store(values[1], lo), store(values[2], hi), store(steps, found.steps);
    bool hits[kWidth<R>], proofs[kWidth<R>], negatives[kWidth<R>];
    put_where<R>(told | inside | at_start | at_end, hits);
    put_where<R>(root.proved, proofs);
    put_where<R>(select(known, negative(sign_before), start), negatives);
    for (int l = 0; l < kWidth<R>; ++l) {
      if (!all[l]) continue;
      const int i = first + l;
      roots.s[i] = double(values[0][l]), roots.lo[i] = double(values[1][l]),
      roots.hi[i] = double(values[2][l]);
      roots.steps[i] = float(steps[l]);
      roots.hit[i] = hits[l], roots.proved[i] = proofs[l], roots.negative[i] = negatives[l];
    }
  }
}

}  // namespace isocast::inline ISO_ISA
