// f over a part of the view's frustum as a polynomial: a Chebyshev series across, in Bernstein form along.
#pragma once

#include <isocast/implicit/frustum/bezier.h>
#include <isocast/math/native.h>

namespace isocast::inline ISO_ISA {

/// The coefficients b of sum over i + j <= across and k <= along of b_ijk T_i(u) T_j(v) B_k(w), u and v in
/// [-1, 1], w in [0, 1]: rows of k, filled up with zeros to whole registers, of (0, 0), (1, 0), .. (0, 1), ..
struct PatchShape {
  int across, along;
  int row() const { return (along + 8) / 8 * 8; }
  int pairs() const { return (across + 1) * (across + 2) / 2; }
  int pair(int i, int j) const { return j * (across + 1) - j * (j - 1) / 2 + i; }
  int size() const { return pairs() * row(); }
};
/// The longest row.
inline constexpr int kMostDepths = (kMostFormDegree + 8) / 8 * 8;
/// Halvings of a block's form, and cuts before the first and after each of them, at most.
inline constexpr int kMostHalvings = 3, kMostCuts = 3;

/// to[x] = sum over m, first <= m < end, of weights[m] from(m)[x], x < length, a multiple of 8.
template <class From>
inline void sum_rows(double* to, int length, const double* weights, int first, int end, From from) {
  for (int x = 0; x < length; x += kWidth<Wide>) {
    Wide sum = Wide(weights[first]) * load<Wide>(from(first) + x);
    for (int m = first + 1; m < end; ++m) sum = sum + Wide(weights[m]) * load<Wide>(from(m) + x);
    store(to + x, sum);
  }
}

/// A half of a form along u (kAxis 0) or v (1); half: chebyshev_half's.
template <int kAxis>
inline void halve(double* out, const double* in, const PatchShape& shape, const double* half) {
  const int row = shape.row();
  for (int j = 0; j <= shape.across; ++j)
    for (int i = 0; i <= shape.across - j; ++i) {
      const int own = kAxis == 0 ? i : j, other = kAxis == 0 ? j : i;
      sum_rows(out + shape.pair(i, j) * row, row, half + own * (kMostFormDegree + 1), own,
               shape.across - other + 1,
               [&](int m) { return in + (kAxis == 0 ? shape.pair(m, j) : shape.pair(i, m)) * row; });
    }
}

/// Leaves out what is of the highest degrees across, as far as it is everywhere at most `most` together;
/// says how much that is.
inline double drop_degrees(double* b, PatchShape& shape, double most) {
  const int row = shape.row();
  int across = shape.across;
  double dropped = 0, sums[kMostDepths] = {};
  for (; across > 0; --across) {
    double here = 0;
    for (int x = 0; x < row; x += kWidth<Wide>) {
      Wide sum = load<Wide>(sums + x);
      for (int j = 0; j <= across; ++j) sum = sum + abs(load<Wide>(b + shape.pair(across - j, j) * row + x));
      store(sums + x, sum);
    }
    for (int k = 0; k <= shape.along; ++k) here = max(sums[k], here);
    if (!(here <= most)) break;
    dropped = here;
  }
  const PatchShape smaller{across, shape.along};
  for (int j = 1; j <= across && across < shape.across; ++j)
    for (int x = 0; x < (across - j + 1) * row; x += kWidth<Wide>)
      store(b + smaller.pair(0, j) * row + x, load<Wide>(b + shape.pair(0, j) * row + x));
  shape = smaller;
  return dropped * (1 + 0x1p-40);
}

/// Least and greatest of a T_1 + b T_2 over [-1, 1].
inline void find_extremes(Wide a, Wide b, Wide& lo, Wide& hi) {
  const Wide ends = abs(a), bow = abs(b);
  // at the ends, or where the slope vanishes between them
  const Wide turn = bow + a * (a / (Wide(8) * bow));
  const Mask<Wide> turns = ends<Wide(4) * bow, up = b> Wide(0);
  lo = select(turns & up, Wide(-1) * turn, b - ends);
  hi = select(turns & !up, turn, b + ends);
}

/// Bounds of each coefficient along, anywhere across.
///
/// source  the terms' sizes, but for parabolas in u alone and in v alone, whose extremes are known
inline void find_hull(const double* b, const PatchShape& shape, double* lo, double* hi) {
  const int row = shape.row(), n = shape.across;
  const auto term = [&](int i, int j, int x) {
    return i + j <= n ? load<Wide>(b + shape.pair(i, j) * row + x) : Wide(0);
  };
  for (int x = 0; x < row; x += kWidth<Wide>) {
    Wide sum = Wide(0), lo_u, hi_u, lo_v, hi_v;
    for (int j = 0; j <= n; ++j)
      for (int i = j > 2 ? 0 : j == 0 ? 3 : 1; i <= n - j; ++i)
        sum = sum + abs(load<Wide>(b + shape.pair(i, j) * row + x));
    find_extremes(term(1, 0, x), term(2, 0, x), lo_u, hi_u);
    find_extremes(term(0, 1, x), term(0, 2, x), lo_v, hi_v);
    const Wide mean = term(0, 0, x),
               room = Wide(0x1p-45) * (abs(mean) + abs(lo_u) + abs(hi_u) + abs(lo_v) + abs(hi_v) + sum);
    store(lo + x, mean + (lo_u + lo_v - sum) - room);
    store(hi + x, mean + (hi_u + hi_v + sum) + room);
  }
}

/// At least |each coefficient along| anywhere across.
inline double largest(const double* b, const PatchShape& shape) {
  const int row = shape.row();
  double sums[kMostDepths], most = 0;
  for (int x = 0; x < row; x += kWidth<Wide>) {
    Wide sum = Wide(0);
    for (int p = 0; p < shape.pairs(); ++p) sum = sum + abs(load<Wide>(b + p * row + x));
    store(sums + x, sum);
  }
  for (int k = 0; k <= shape.along; ++k) most = sums[k] <= most ? most : sums[k];  // NaN stays
  return most * (1 + 0x1p-40);
}

/// Keeps the depths from `first` to `last` of [0, 1].
inline void cut(double* b, const PatchShape& shape, double first, double last) {
  const int row = shape.row(), d = shape.along;
  double ways[kMostFormDegree + 1][kMostDepths], in[kMostDepths], place[kWidth<Wide>];
  for (int l = 0; l < kWidth<Wide>; ++l) place[l] = l;
  for (int x = 0; x < row; x += kWidth<Wide>) {
    // coefficient i is the blossom with d - i arguments `first` and i arguments `last`
    const Wide i = load<Wide>(place) + Wide(x);
    Wide c[kMostFormDegree + 1];
    c[0] = select(i <= Wide(d), Wide(1), Wide(0));
    for (int k = 1; k <= d; ++k) {
      const Wide s = select(i <= Wide(d - k), Wide(first), Wide(last)), before = Wide(1) - s;
      c[k] = s * c[k - 1];
      for (int m = k - 1; m >= 1; --m) c[m] = before * c[m] + s * c[m - 1];
      c[0] = before * c[0];
    }
    for (int k = 0; k <= d; ++k) store(ways[k] + x, c[k]);
  }
  for (int p = 0; p < shape.pairs(); ++p) {
    double* const at = b + p * row;
    for (int x = 0; x < row; x += kWidth<Wide>) store(in + x, load<Wide>(at + x));
    sum_rows(at, row, in, 0, d + 1, [&](int k) { return ways[k]; });
  }
}

}  // namespace isocast::inline ISO_ISA
