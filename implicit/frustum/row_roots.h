// Sixteen rays of a row of pixels: from their polynomials to their first roots.
#pragma once

#include <isocast/implicit/frustum/find_by_clipping.h>
#include <isocast/implicit/frustum/find_by_knots.h>
#include <isocast/implicit/frustum/find_by_signs.h>
#include <isocast/math/mask_bits.h>

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

/// Signs of f - iso that roundings at an end may have hidden, bit by ray: negative where known.
struct RowSides {
  unsigned known = 0, negative = 0;
};

/// Polynomials f - iso of kRow rays over [0, 1] each, scaled by any power of two.
///
/// c         [k][ray]: Bernstein coefficients, of which each is off by at most the ray's `margin`
/// eps       in [0, 1]
/// before    the sides in front of 0; behind: those behind 1
/// proves    whether proofs are wanted
/// guessed   the roots hold guesses: a hit may be one that can be proved without being searched for
template <class T> struct RowPolynomials {
  int degree;
  T c[kMostFormDegree + 1][kRow];
  T eps[kRow], margin[kRow];
  RowSides before, behind;
  bool proves, guessed = false;
};

/// s with the bracket lo, hi; bit by ray negative: f < iso in front of it. proved: the hit, or that there is
/// none.
struct RowRoots {
  double s[kRow] = {}, lo[kRow] = {}, hi[kRow] = {};
  float steps[kRow] = {};
  unsigned hit = 0, proved = 0, negative = 0;
};

/// Roots of the rays whose bits are set; the others' stay.
template <Real R>
inline void find_row(const RowPolynomials<Scalar<R>>& row, const FinderOptions& options, unsigned wanted,
                     RowRoots& roots) {
  using T = Scalar<R>;
  for (int first = 0; first < kRow; first += kWidth<R>) {
    const Mask<R> active = lanes_of<R>(wanted >> first);
    if (!any(active)) continue;
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
    const Mask<R> start = negative(p.c[0]), known = lanes_of<R>(row.before.known >> first),
                  negative_before = lanes_of<R>(row.before.negative >> first);
    const Mask<R> at_start = active & ((known & (negative_before != start)) | ((!known) & (p.c[0] == R(0))));

    ProvedRoot<R> root = {R(0), R(0), R(0), Mask<R>(false)};
    if (row.proves && row.guessed) {
      T guesses[kWidth<R>];
      for (int l = 0; l < kWidth<R>; ++l) guesses[l] = T(roots.s[first + l]);
      const Mask<R> tried = active & lanes_of<R>(roots.hit >> first) & !at_start;
      if (any(tried)) root = prove_root(p, form, load<R>(guesses), eps, doubt, tried);
    }
    const Mask<R> told = root.proved, sought = active & !told;
    const FirstRoot<R> found =
        any(sought) ? find_first(p, form, options, eps, doubt, sought) : FirstRoot<R>{};
    const Mask<R> at_end = (sought & !(found.hit | at_start)) & lanes_of<R>(row.behind.known >> first) &
                           (lanes_of<R>(row.behind.negative >> first) != negative(p.c[p.degree]));
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
    const unsigned lanes = bits_of(active) << first;
    const auto put = [&](unsigned& bits, Mask<R> mask) {
      bits = (bits & ~lanes) | (bits_of(mask) << first & lanes);
    };
    put(roots.hit, told | inside | at_start | at_end);
    put(roots.proved, root.proved);
    put(roots.negative, select(known, negative_before, start));
    T values[3][kWidth<R>], steps[kWidth<R>];
    store(values[0], s), store(values[1], lo), store(values[2], hi), store(steps, found.steps);
    for (int l = 0; l < kWidth<R>; ++l) {
      const int i = first + l;
      const bool here = lanes >> i & 1;
      roots.s[i] = here ? double(values[0][l]) : roots.s[i];
      roots.lo[i] = here ? double(values[1][l]) : roots.lo[i];
      roots.hi[i] = here ? double(values[2][l]) : roots.hi[i];
      roots.steps[i] = here ? float(steps[l]) : roots.steps[i];
    }
  }
}

}  // namespace isocast::inline ISO_ISA
