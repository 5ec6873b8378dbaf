// The form of f over a block of the picture, from values of f.
#pragma once

#include <isocast/implicit/frustum/block_query.h>
#include <isocast/implicit/frustum/patch.h>
#include <isocast/implicit/solve/inclusion.h>

namespace isocast::inline ISO_ISA {

/// Points across at which f is asked for, at each of degree + 1 depths.
inline int points_across(int degree) { return (degree + 1) * (degree + 2) / 2; }

/// f at the depths of all points across: rows of depths, filled up with the last.
inline void evaluate_points(const FrustumQuery& query, void* registers, double* values) {
  constexpr int kPacks = 16;
  const PixelLines& lines = query.lines;
  const double half = 8 * query.tiles;
  const int d = query.along.degree, row = PatchShape{d, d}.row();
  double depths[kMostDepths];
  for (int k = 0; k < row; ++k)
    depths[k] = query.s0 + (query.s1 - query.s0) * query.along.points[k < d ? k : d];
  Wide inputs[4 * kPacks];
  int waiting = 0;
  const auto flush = [&] {
    const Wide* const f = evaluate_some<kPacks>(query.tape, static_cast<const Wide*>(inputs),
                                                static_cast<Wide*>(registers), waiting);
    for (int p = 0; p < waiting; ++p, values += kWidth<Wide>) store(values, f[p]);
    waiting = 0;
  };
  for (int j = 0; j <= d + 1; ++j)
    for (int i = j % 2; i <= d; i += 2) {
      const double u = query.u0 + half * (1 + query.across.columns[i]),
                   v = query.v0 + half * (1 + query.across.rows[j]);
      for (int x = 0; x < row; x += kWidth<Wide>) {
        for (int a = 0; a < 3; ++a)
          inputs[a * kPacks + waiting] =
              Wide(lines.o[a] + v * lines.o_v[a] + u * lines.o_u[a]) +
              load<Wide>(depths + x) * Wide(lines.d[a] + v * lines.d_v[a] + u * lines.d_u[a]);
        inputs[3 * kPacks + waiting] = Wide(query.time);
        if (++waiting == kPacks) flush();
      }
    }
  if (waiting) flush();
}

/// Series across from values: at each depth by itself. between: room for (d + 1) (d + 2) rows.
inline void find_series(const FrustumQuery& query, const double* values, double* between, double* b) {
  const int d = query.along.degree, n = d + 1;
  const PatchShape shape{d, d};
  const int row = shape.row();
  for (int j = 0; j <= n; ++j) {
    const int first = j % 2, count = (d - first) / 2 + 1;
    for (int k = 0; k < n; ++k) {
      double weights[kMostFormDegree + 1];
      for (int i = 0; i < count; ++i) weights[i] = query.across.from_columns[k * n + first + 2 * i];
      sum_rows(between + (j * n + k) * row, row, weights, 0, count, [&](int i) { return values + i * row; });
    }
    values += count * row;
  }
  for (int l = 0; l < n; ++l)
    for (int k = 0; k < n - l; ++k)
      sum_rows(b + shape.pair(k, l) * row, row, query.across.from_rows + l * (n + 1), 0, n + 1,
               [&](int j) { return between + (j * n + k) * row; });
}

/// From values at the depths to Bernstein coefficients; how far the form is from the values then.
inline double find_bernstein(const FrustumQuery& query, double* b, const PatchShape& shape) {
  const int row = shape.row(), n = shape.along + 1;
  double to[kMostFormDegree + 1][kMostDepths] = {}, back[kMostFormDegree + 1][kMostDepths] = {};
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k)
      to[k][i] = query.along.from_values[i * n + k], back[k][i] = query.along.at_points[i * n + k];
  double values[kMostDepths], again[kMostDepths], off[kMostDepths] = {}, most = 0;
  for (int p = 0; p < shape.pairs(); ++p) {
    double* const at = b + p * row;
    for (int k = 0; k < n; ++k) values[k] = at[k];
    sum_rows(at, row, values, 0, n, [&](int k) { return to[k]; });
    sum_rows(again, row, at, 0, n, [&](int k) { return back[k]; });
    for (int k = 0; k < n; ++k) off[k] += abs(again[k] - values[k]);
  }
  for (int k = 0; k < n; ++k) most = off[k] <= most ? most : off[k];  // NaN stays
  return most;
}

/// The form of f over a block: its shape, and how far it can be from f anywhere there and its coefficients
/// from what they should be, after halving it for each tile and cutting it (infinite where f is not finite).
/// negligible: what terms that are left out of a part may come to.
struct BlockForm {
  PatchShape shape;
  double margin, negligible;
};

/// unit     unit roundoff of whoever looks for the roots
/// b        room for the largest form; scratch: for it and (d + 1) (d + 2) rows of depths
/// source   Higham: Accuracy and stability of numerical algorithms, SIAM 2002, chapter 3, for sums; what of a
///          series is left out is at most its terms' sizes
inline BlockForm interpolate(const FrustumQuery& query, double unit, double* b, double* scratch,
                             void* registers) {
  constexpr double kUnit = 0x1p-53;
  const int d = query.along.degree;
  PatchShape shape{d, d};
  const int pairs = shape.pairs();
  evaluate_points(query, registers, scratch);
  Wide peak = Wide(0);
  for (int x = 0; x < shape.size(); x += kWidth<Wide>) {
    const Wide f = abs(load<Wide>(scratch + x));
    peak = select(f <= peak, peak, f);  // NaN stays
  }
  double lanes[kWidth<Wide>], size = 0;
  store(lanes, peak);
  for (const double lane : lanes) size = lane <= size ? size : lane;
  find_series(query, scratch, scratch + shape.size(), b);
  // weights of a coefficient's values have the sum 4 at most
  const double sums = pairs * kUnit * 4 * (2 * d + 8) * size;
  const double values = (query.rounding * query.across.lebesgue + sums) * query.along.lebesgue;
  const double negligible = min(0.5 * values / query.along.lebesgue, 16 * unit * size),
               dropped = drop_degrees(b, shape, negligible);
  const double off = find_bernstein(query, b, shape), most = largest(b, shape);
  // a polynomial within [-1, 1] has a series whose terms' sizes have at most these sums, in one variable
  // and in both
  const double across = __builtin_sqrt(2.0 * shape.across + 1), both = 2 * __builtin_sqrt(shape.pairs());
  const double halving = kMostHalvings * 2 * (shape.across + 4) * across,
               cutting = (kMostHalvings + 1) * kMostCuts * (4 * d + 4);
  const double margin = 1.001 * (values + (dropped + off + (d + 4) * kUnit * most) * query.along.lebesgue) +
                        kUnit * both * (halving + cutting) * most + query.slack;
  return {shape, margin < kInfinity<double> ? margin : kInfinity<double>, negligible};
}

}  // namespace isocast::inline ISO_ISA
