// f over a part of the view's frustum, as a polynomial in Bernstein form.
#pragma once

#include <isocast/implicit/frustum/block_query.h>
#include <isocast/implicit/solve/inclusion.h>
#include <isocast/math/native.h>

namespace isocast::inline ISO_ISA {

/// The shape of b[j][k][i]: j counts v, k depth, i u; rows of i are filled up to whole registers.
struct PatchShape {
  int across, along;
  int row() const { return (across + 8) / 8 * 8; }
  int sheet() const { return (along + 1) * row(); }
  int size() const { return (across + 1) * sheet(); }
};

/// out[a][x] = sum over b of matrix[a][b] in[b][x], x < length, a multiple of 8.
inline void combine(double* out, const double* in, const double* matrix, int rows, int columns, int length) {
  for (int a = 0; a < rows; ++a) {
    double* const to = out + a * length;
    for (int x = 0; x < length; x += kWidth<Wide>) {
      Wide sum = Wide(matrix[a * columns]) * load<Wide>(in + x);
      for (int b = 1; b < columns; ++b)
        sum = sum + Wide(matrix[a * columns + b]) * load<Wide>(in + b * length + x);
      store(to + x, sum);
    }
  }
}

/// The same for the numbers in each of `count` rows: out[n][a] = sum over b of matrix[a][b] in[n][b]; what
/// fills up the rows of `out` becomes 0.
inline void combine_in_rows(double* out, int out_row, const double* in, int in_row, const double* matrix,
                            int rows, int columns, int count) {
  constexpr int kMostRow = (kMostFormDegree + 8) / 8 * 8;
  double turned[(kMostFormDegree + 1) * kMostRow];
  for (int b = 0; b < columns; ++b)
    for (int a = 0; a < kMostRow; ++a) turned[b * kMostRow + a] = a < rows ? matrix[a * columns + b] : 0;
  for (int n = 0; n < count; ++n)
    for (int x = 0; x < out_row; x += kWidth<Wide>) {
      Wide sum = Wide(in[n * in_row]) * load<Wide>(turned + x);
      for (int b = 1; b < columns; ++b)
        sum = sum + Wide(in[n * in_row + b]) * load<Wide>(turned + b * kMostRow + x);
      store(out + n * out_row + x, sum);
    }
}

/// f at the points (u, v, depth) of a grid of the block, rows of i filled up with the last point:
/// values[j][k][i], rows of `row`; put takes packs of them.
template <class Put>
inline void evaluate_grid(const FrustumQuery& query, const double* across, int n_across, const double* along,
                          int n_along, int row, void* registers, Put put) {
  constexpr int kPacks = 16;
  const PixelLines& lines = query.lines;
  const double pixels = 16 * query.tiles;
  Wide inputs[4 * kPacks];
  int waiting = 0, first = 0;
  const int packs_in_row = row / kWidth<Wide>, packs = n_across * n_along * packs_in_row;
  const auto flush = [&] {
    const Wide* const f = evaluate_some<kPacks>(query.tape, static_cast<const Wide*>(inputs),
                                                static_cast<Wide*>(registers), waiting);
    for (int p = 0; p < waiting; ++p) put((first + p) * kWidth<Wide>, f[p]);
    first += waiting;
    waiting = 0;
  };
  for (int pack = 0; pack < packs; ++pack) {
    const int j = pack / packs_in_row / n_along, k = pack / packs_in_row % n_along;
    double u[kWidth<Wide>];
    for (int l = 0; l < kWidth<Wide>; ++l) {
      const int i = pack % packs_in_row * kWidth<Wide> + l;
      u[l] = query.u0 + pixels * across[i < n_across ? i : n_across - 1];
    }
    const double v = query.v0 + pixels * across[j];
    const Wide s = Wide(query.s0 + (query.s1 - query.s0) * along[k]), pixel = load<Wide>(u);
    for (int a = 0; a < 3; ++a) {
      const Wide o = Wide(lines.o[a] + v * lines.o_v[a]) + pixel * Wide(lines.o_u[a]),
                 d = Wide(lines.d[a] + v * lines.d_v[a]) + pixel * Wide(lines.d_u[a]);
      inputs[a * kPacks + waiting] = o + s * d;
    }
    inputs[3 * kPacks + waiting] = Wide(query.time);
    if (++waiting == kPacks) flush();
  }
  if (waiting) flush();
}

/// The form of f over the whole block. `scratch` has room for two patches.
inline void interpolate(const FrustumQuery& query, double* b, double* scratch, void* registers) {
  const DegreeTables &uv = query.across, &w = query.along;
  const PatchShape shape{uv.degree, w.degree};
  double* const other = scratch + shape.size();
  const int n = uv.degree + 1, m = w.degree + 1, row = shape.row(), sheet = shape.sheet();
  evaluate_grid(query, uv.points, n, w.points, m, row, registers,
                [scratch](int at, Wide f) { store(scratch + at, f); });
  combine_in_rows(other, row, scratch, row, uv.from_values, n, n, n * m);
  for (int j = 0; j < n; ++j) combine(scratch + j * sheet, other + j * sheet, w.from_values, m, m, row);
  combine(b, scratch, uv.from_values, n, n, sheet);
}

inline double largest(const double* b, int size) {
  Wide most = Wide(0);
  for (int x = 0; x < size; x += kWidth<Wide>) most = max(abs(load<Wide>(b + x)), most);
  double lanes[kWidth<Wide>], result = 0;
  store(lanes, most);
  for (const double lane : lanes) result = max(lane, result);
  return result;
}

/// How far f can be from its form anywhere in the block: a polynomial of f's degree in each direction, of
/// which its values at Chebyshev's points are known. Infinite where they are not. `scratch` has room for two
/// grids of checks.
inline double form_error(const FrustumQuery& query, const double* b, double* scratch, void* registers) {
  const DegreeTables &uv = query.across, &w = query.along;
  const PatchShape shape{uv.degree, w.degree}, checks{query.degree, query.degree};
  const int n = query.degree + 1, row = checks.row();
  double* const other = scratch + checks.size();
  combine_in_rows(scratch, row, b, shape.row(), uv.at_checks, n, uv.degree + 1,
                  (uv.degree + 1) * (w.degree + 1));
  for (int j = 0; j <= uv.degree; ++j)
    combine(other + j * checks.sheet(), scratch + j * (w.degree + 1) * row, w.at_checks, n, w.degree + 1,
            row);
  combine(scratch, other, uv.at_checks, n, uv.degree + 1, checks.sheet());

  Wide off = Wide(0);
  evaluate_grid(query, query.check_points, n, query.check_points, n, row, registers, [&](int at, Wide f) {
    const Wide far = abs(load<Wide>(scratch + at) - f);
    double lanes[kWidth<Wide>];
    store(lanes, select(far < Wide(kInfinity<double>), far, Wide(kInfinity<double>)));
    // not what fills up the rows
    for (int l = 0; l < kWidth<Wide>; ++l)
      if ((at + l) % row >= n) lanes[l] = 0;
    off = max(off, load<Wide>(lanes));
  });
  double lanes[kWidth<Wide>], most = 0;
  store(lanes, off);
  for (const double lane : lanes) most = max(lane, most);
  const double roundings = 0x1p-50 * (2 * uv.degree + w.degree + 8) * largest(b, shape.size());
  return (most + query.rounding + roundings) * query.lebesgue * query.lebesgue * query.lebesgue * 1.001;
}

}  // namespace isocast::inline ISO_ISA
