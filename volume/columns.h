// Rows of eight numbers in memory, a row for each lane, as columns in registers.
#pragma once

#include <isocast/math/pack.h>

namespace isocast::inline ISO_ISA {

/// v[k]: number k of as many rows as a register has lanes.
template <Real R> struct Columns { R v[8]; };

#ifdef __AVX512DQ__

/// Rows of eight numbers become columns.
inline void transpose(__m512d (&v)[8]) {
  __m512d pairs[8], halves[8];
  for (int i = 0; i < 8; i += 2) {
    pairs[i] = __builtin_shufflevector(v[i], v[i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
    pairs[i + 1] = __builtin_shufflevector(v[i], v[i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
  }
  // each pair of numbers is one now: columns k, k + 2, k + 4 and k + 6 of two rows
  const auto split = [](__m512d a, __m512d b, __m512d& even, __m512d& odd) {
    even = __builtin_shufflevector(a, b, 0, 1, 4, 5, 8, 9, 12, 13);
    odd = __builtin_shufflevector(a, b, 2, 3, 6, 7, 10, 11, 14, 15);
  };
  for (int k = 0; k < 2; ++k) {
    split(pairs[k], pairs[k + 2], halves[k], halves[k + 2]);
    split(pairs[k + 4], pairs[k + 6], halves[k + 4], halves[k + 6]);
  }
  for (int k = 0; k < 4; ++k) split(halves[k], halves[k + 4], v[k], v[k + 4]);
}

/// row(l): the row of lane l, aligned to 64 bytes.
template <Real R, class Row> inline Columns<R> load_columns(const Row& row) {
  __m512d v[8];
  for (int l = 0; l < 8; ++l) v[l] = _mm512_load_pd(row(l));
  transpose(v);
  return {{R(v[0]), R(v[1]), R(v[2]), R(v[3]), R(v[4]), R(v[5]), R(v[6]), R(v[7])}};
}
template <Real R, class Row> inline void store_columns(const Columns<R>& c, const Row& row) {
  __m512d v[8] = {c.v[0].v, c.v[1].v, c.v[2].v, c.v[3].v, c.v[4].v, c.v[5].v, c.v[6].v, c.v[7].v};
  transpose(v);
  for (int l = 0; l < 8; ++l) _mm512_store_pd(row(l), v[l]);
}

#else

template <Real R, class Row> inline Columns<R> load_columns(const Row& row) {
  double lanes[8][kWidth<R>];
  for (int l = 0; l < kWidth<R>; ++l)
    for (int k = 0; k < 8; ++k) lanes[k][l] = row(l)[k];
  Columns<R> c;
  for (int k = 0; k < 8; ++k) c.v[k] = load<R>(lanes[k]);
  return c;
}
template <Real R, class Row> inline void store_columns(const Columns<R>& c, const Row& row) {
  double lanes[kWidth<R>];
  for (int k = 0; k < 8; ++k) {
    store(lanes, c.v[k]);
    for (int l = 0; l < kWidth<R>; ++l) row(l)[k] = lanes[l];
  }
}

#endif

}  // namespace isocast::inline ISO_ISA
