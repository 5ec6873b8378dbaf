// The chords of rays in the cells that they have come to.
#pragma once

#include <isocast/volume/cell_planes.h>
#include <isocast/volume/columns.h>
#include <isocast/volume/int_lanes.h>
#include <isocast/volume/stream/crossings.h>
#include <isocast/volume/stream/walking_rays.h>

namespace isocast::inline ISO_ISA {

/// Those of the first `count` cells of the queue, 1 to 16 of them. A cell is crossed if it is the ray's
/// first one, or lies behind that and is entered before it is left, by (t, axis).
template <Real R, class T>
void find_chords(const WalkingRays& rays, const CellQueue& queue, int count, CellChords<T>& chords) {
  chords.crossed = chords.first = 0;
  for (int i = 0; i < count; i += kWidth<R>) {
    const auto row = [&](int l) {
      return reinterpret_cast<const double*>(rays.ray + queue.slot[i + l < count ? i + l : i]);
    };
    const Columns<R> one = load_columns<R>(row), two = load_columns<R>([&](int l) { return row(l) + 8; });
    const R begin = one.v[6], end = one.v[7];
    const AxisOfRays<R> axes[3] = {
        {one.v[0], one.v[3], two.v[0]}, {one.v[1], one.v[4], two.v[1]}, {one.v[2], one.v[5], two.v[2]}};
    R cell[3];
    CellPlanes<R> p;
    Mask<R> first = Mask<R>(true), ahead = Mask<R>(true);
    for (int a = 0; a < 3; ++a) {
      const AxisOfRays<R>& ray = axes[a];
      cell[a] = load_as<R>(queue.cell[a] + i);
      const R start = two.v[3 + a], low = (cell[a] - ray.o) * ray.inverse,
              high = (cell[a] + R(1) - ray.o) * ray.inverse, infinite = R(__builtin_inf());
      const Mask<R> same = cell[a] == start;
      p.near[a] = select(ray.moves, min(low, high), select(same, -infinite, infinite));
      p.far[a] = select(ray.moves, max(low, high), infinite);
      first = first & same;
      ahead = ahead & (same | (ray.back != (cell[a] > start)));
    }
    order_planes(begin, p);
    const CrossingAxes<R> axis = crossing_axes(p);
    const Mask<R> crossed = ahead & !p.start & (p.t_in <= end) &
                            ((p.t_in < p.t_out) | ((p.t_in == p.t_out) & (axis.in <= axis.out)));
    const R t_in = select(first, two.v[6], p.t_in), axis_in = select(first, two.v[7], axis.in);
    for (int a = 0; a < 3; ++a) {
      const AxisOfRays<R>& ray = axes[a];
      const R base = ray.o - cell[a], number = R(double(a));
      store_as(chords.entry[a] + i, select(axis_in == number, ray.near, clamp01(base + t_in * ray.d)));
      store_as(chords.exit[a] + i, select(axis.out == number, ray.far, clamp01(base + p.t_out * ray.d)));
    }
    store(chords.t_in + i, t_in);
    store(chords.t_out + i, p.t_out);
    store(chords.axis_in + i, axis_in);
    chords.first |= bits_of(first) << i;
    chords.crossed |= bits_of(first | crossed) << i;
  }
  chords.first &= (1u << count) - 1;
  chords.crossed &= (1u << count) - 1;
}

}  // namespace isocast::inline ISO_ISA
