// The rays of small windows of a patch that cross one cell.
#pragma once

#include <isocast/volume/fetch_cells.h>
#include <isocast/volume/primary/pairs.h>

namespace isocast::inline ISO_ISA {

/// A window is as large as a register of doubles: kColumns x kRows pixels.
template <Real R> inline constexpr int kColumns = kWidth<R> < 4 ? kWidth<R> : 4;
template <Real R> inline constexpr int kRows = kWidth<R> / kColumns<R>;

/// The lanes of the window at (x, y) that lie in a box of pixels.
template <Real R> inline unsigned window_lanes(const PixelBox& pixels, int x, int y) {
  const int columns = pixels.x_hi - x + 1;
  const unsigned row = columns < kColumns<R> ? (1u << columns) - 1 : (1u << kColumns<R>)-1;
  return kRows<R> > 1 && y < pixels.y_hi ? row | row << kColumns<R> : row;
}

/// Values of the rays of the window whose first ray is number `at`.
template <Real R> inline R load_window(const double* rays, int at) {
#ifdef __AVX512DQ__
  const __m256d first = _mm256_loadu_pd(rays + at), second = _mm256_loadu_pd(rays + at + kPatchPitch);
  return R(_mm512_maskz_insertf64x4(0xff, _mm512_castpd256_pd512(first), second, 1));
#else
  return load<R>(rays + at);
#endif
}

/// Writes the lanes of `bits` one behind the other; up to kWidth<R> numbers behind `to` are overwritten.
template <Real R> inline void compress(double* to, R v, unsigned bits) {
#ifdef __AVX512DQ__
  _mm512_storeu_pd(to, _mm512_maskz_compress_pd(__mmask8(bits), v.v));
#else
  double lanes[kWidth<R>];
  store(lanes, v);
  for (; bits; bits &= bits - 1) *to++ = lanes[__builtin_ctz(bits)];
#endif
}
template <Real R> inline void compress(float* to, R v, unsigned bits) {
#ifdef __AVX512DQ__
  _mm256_storeu_ps(to, _mm256_maskz_compress_ps(__mmask8(bits), _mm512_maskz_cvtpd_ps(0xff, v.v)));
#else
  double lanes[kWidth<R>];
  store(lanes, v);
  for (; bits; bits &= bits - 1) *to++ = float(lanes[__builtin_ctz(bits)]);
#endif
}

/// Writes a value as often as a window has lanes.
template <class V> inline void spread(V* to, V value) {
  for (int l = 0; l < kWidth<Native<double>>; ++l) to[l] = value;
}

/// A cell on its way into the queue. f: corners minus iso.
template <class T> struct CellToDraw {
  std::int32_t at[3];
  int iso;
  FetchedCell state;
  const T* f;
};

/// Where a window's rays meet the planes of a cell. They cross it if they meet all near ones before all far
/// ones: those that do surely do not have t_out < t_in.
template <Real R> struct CellPlanes {
  R near[3], far[3];
  Mask<R> start;  // the ray starts in the cell, or behind it
  R t_in, t_out;
};

/// The same expression as in traverse.h: planes are met at (k - o) * inverse.
template <Real R, bool kOrthographic>
inline CellPlanes<R> meet_planes(const PatchRays& rays, const std::int32_t (&cell)[3], int at) {
  CellPlanes<R> p;
  for (int a = 0; a < 3; ++a) {
    const double k = double(cell[a]);
    R low, high;
    if constexpr (kOrthographic) {
      if (rays.parallel[a]) {
        const Mask<R> inside = load_window<R>(rays.cell[a], at) == R(k);
        p.near[a] = select(inside, R(-__builtin_inf()), R(__builtin_inf()));
        p.far[a] = R(__builtin_inf());
        continue;
      }
      const R o = load_window<R>(rays.own[a], at), inverse = R(rays.shared_inverse[a]);
      low = (R(k) - o) * inverse;
      high = (R(k + 1) - o) * inverse;
    } else {
      const R inverse = load_window<R>(rays.inverse[a], at);
      low = R(k - rays.shared[a]) * inverse;
      high = R(k + 1 - rays.shared[a]) * inverse;
    }
    p.near[a] = min(low, high);
    p.far[a] = max(low, high);
  }
  const R entered = max(max(p.near[0], p.near[1]), p.near[2]);
  p.start = entered <= R(0);
  p.t_in = max(entered, R(0));
  p.t_out = min(min(p.far[0], p.far[1]), p.far[2]);
  return p;
}

/// The axes of the last near and the first far plane by (t, axis), or kStart.
template <Real R> struct CrossingAxes { R in, out; };
template <Real R> inline CrossingAxes<R> crossing_axes(const CellPlanes<R>& p) {
  const R in = select(p.near[2] >= max(p.near[0], p.near[1]), R(2),
                      select(p.near[1] >= p.near[0], R(1), R(0))),
          out = select(p.far[2] < min(p.far[0], p.far[1]), R(2), select(p.far[1] < p.far[0], R(1), R(0)));
  return {select(p.start, R(kStart), in), out};
}

/// Entry and exit of the cell along one axis in its own coordinates (point_in_cell).
template <Real R> struct ChordEnds { R entry, exit; };
template <Real R, bool kOrthographic>
inline ChordEnds<R> chord_ends(const PatchRays& rays, const std::int32_t (&cell)[3], int a, int at,
                               const CellPlanes<R>& p, const CrossingAxes<R>& axis) {
  R base, d;
  if constexpr (kOrthographic) {
    base = load_window<R>(rays.own[a], at) - R(double(cell[a]));
    d = R(rays.shared[a]);
  } else {
    base = R(rays.shared[a] - double(cell[a]));
    d = load_window<R>(rays.own[a], at);
  }
  const R entry = clamp01(base + p.t_in * d), exit = clamp01(base + p.t_out * d);
  const R upper = select(d < R(0), R(1), R(0));  // the face it enters through, if it is one of this axis
  return {select(axis.in == R(a), upper, entry), select(axis.out == R(a), R(1) - upper, exit)};
}

/// Queues the rays of a window, those of `lanes`, that cross the cell before their nearest root.
template <class T, bool kOrthographic>
inline void queue_window(const CellToDraw<T>& cell, int at, unsigned lanes, PatchState& patch) {
  using R = Native<double>;
  constexpr double kOffsets[8] = {0, 1, 2, 3, kPatchPitch, kPatchPitch + 1, kPatchPitch + 2, kPatchPitch + 3};
  const PatchRays& rays = patch.rays;
  const CellPlanes<R> planes = meet_planes<R, kOrthographic>(rays, cell.at, at);
  const R depth = load_window<R>(patch.depth, at);
  unsigned bits = bits_of((planes.t_in <= planes.t_out) & (planes.t_in <= depth)) & lanes;
  if (bits == 0) return;
  const CrossingAxes<R> axis = crossing_axes(planes);
  const auto leave_to_walk = [&](unsigned rest) {
    for (; rest; rest &= rest - 1) patch.walk[at + int(kOffsets[__builtin_ctz(rest)])] = 1;
  };
  // a ray that starts on a plane is in the cell in front, or, on the border of the active blocks, behind
  leave_to_walk(bits & bits_of(planes.start & (planes.t_out == R(0))));
  bits &= bits_of((planes.t_in < planes.t_out) | (axis.in <= axis.out));
  if (bits == 0) return;
  if (cell.state == FetchedCell::doubtful) return leave_to_walk(bits);
  PairQueue<T>& queue = pairs_of(patch, T{});
  const int n = queue.size, count = __builtin_popcount(bits);
  for (int a = 0; a < 3; ++a) {
    const ChordEnds<R> ends = chord_ends<R, kOrthographic>(rays, cell.at, a, at, planes, axis);
    compress(queue.entry[a] + n, ends.entry, bits);
    compress(queue.exit[a] + n, ends.exit, bits);
  }
  compress(queue.t_in + n, planes.t_in, bits);
  compress(queue.t_out + n, planes.t_out, bits);
  compress(queue.axis + n, axis.in, bits);
  compress(queue.ray + n, R(double(at)) + load<R>(kOffsets), bits);
  queue.any_start = queue.any_start || any(planes.start);
  for (int k = 0; k < 8; ++k) spread(queue.f[k] + n, cell.f[k]);
  for (int a = 0; a < 3; ++a) spread(queue.cell[a] + n, cell.at[a]);
  spread(queue.iso + n, cell.iso);
  queue.size = n + count;
}

}  // namespace isocast::inline ISO_ISA
