// Where the rays of a stream enter a grid.
#pragma once

#include <isocast/volume/columns.h>
#include <isocast/volume/int_lanes.h>
#include <isocast/volume/stream/crossings.h>
#include <isocast/volume/stream/lane_bits.h>
#include <isocast/volume/stream/march_field.h>
#include <isocast/volume/stream/walking_rays.h>

namespace isocast::inline ISO_ISA {

/// Where rays are in their first cells.
template <Real R> struct Entry {
  R t_in, axis_in, end, cell[3];
  Mask<R> enters;
};

/// Rays of the world in grid space, with the bits of grid_ray (trace_stream.h).
template <Real R> struct GridRays {
  AxisOfRays<R> axis[3];

  GridRays(const VolumeQuery& query, const RayStream& rays, int i)
      : axis{along(query.grid_from_world[0], rays, i), along(query.grid_from_world[1], rays, i),
             along(query.grid_from_world[2], rays, i)} {}

 private:
  static AxisOfRays<R> along(const double (&m)[4], const RayStream& rays, int i) {
    const R d =
        R(m[0]) * load<R>(rays.dx + i) + R(m[1]) * load<R>(rays.dy + i) + R(m[2]) * load<R>(rays.dz + i);
    return {R(m[0]) * load<R>(rays.ox + i) + R(m[1]) * load<R>(rays.oy + i) + R(m[2]) * load<R>(rays.oz + i) +
                R(m[3]),
            d, R(1) / d};
  }
};

/// As enter_grid and find_block (traverse.h) have it: between the planes that enclose all active cells.
template <Real R>
Entry<R> enter_cells(const MarchField& field, const GridRays<R>& rays, R begin, R end, Mask<R> asked) {
  Entry<R> entry = {begin, R(kStart), end, {}, asked};
  for (int a = 0; a < 3; ++a) {
    const AxisOfRays<R>& ray = rays.axis[a];
    const R low = R(field.low[a]), high = R(field.high[a]);
    entry.enters = entry.enters & (ray.moves | ((ray.o >= low) & (ray.o <= high) & (ray.d == ray.d)));
    const R near = (select(ray.back, high, low) - ray.o) * ray.inverse,
            far = (select(ray.back, low, high) - ray.o) * ray.inverse;
    const Mask<R> later =
        ray.moves & select(entry.axis_in == R(kStart), near > entry.t_in, near >= entry.t_in);
    entry.t_in = select(later, near, entry.t_in);
    entry.axis_in = select(later, R(double(a)), entry.axis_in);
    entry.end = select(ray.moves, min(entry.end, far), entry.end);
  }
  entry.enters = entry.enters & (entry.t_in <= entry.end) & (entry.t_in < R(__builtin_inf()));
  if (!any(entry.enters)) return entry;
  for (int a = 0; a < 3; ++a) {
    const AxisOfRays<R>& ray = rays.axis[a];
    const R lo = R(field.low[a]), hi = R(field.high[a] - 1);
    const R through = select(ray.back, hi, lo);  // the face that was entered through
    const R cell = select(entry.axis_in == R(double(a)), through,
                          cell_after(ray, a, entry.t_in, entry.axis_in, lo, hi, entry.enters));
    entry.cell[a] = select(ray.moves, cell, parallel_cell(ray, lo, hi));
  }
  return entry;
}

/// Puts rays into cells that they are known to cross, as resume_in_cell (traverse.h) has it.
template <Real R> void resume_in_cells(const GridRays<R>& rays, R begin, Entry<R>& entry) {
  entry.t_in = begin;
  entry.axis_in = R(kStart);
  for (int a = 0; a < 3; ++a) {
    const AxisOfRays<R>& ray = rays.axis[a];
    const R near = ray.plane_t(entry.cell[a] + ray.near);
    const Mask<R> later =
        ray.moves & select(entry.axis_in == R(kStart), near > entry.t_in, near >= entry.t_in);
    entry.t_in = select(later, near, entry.t_in);
    entry.axis_in = select(later, R(double(a)), entry.axis_in);
  }
}

/// What a first look needs of rays. It starts where they enter their first cells, so that it does not matter
/// from how far they come.
template <Real R>
void store_looks(const MarchField& field, const GridRays<R>& rays, const Entry<R>& entry, RayLook* looks) {
  constexpr double kSteepest = 0x1p126, kParallel = 0x1p60;
  R unit = R(0), low[3], high[3], inverse[3];
  for (const AxisOfRays<R>& ray : rays.axis) unit = max(unit, select(ray.moves, abs(ray.d), R(0)));
  for (int a = 0; a < 3; ++a) {
    const AxisOfRays<R>& ray = rays.axis[a];
    const R origin = R(double(field.bricks.origin[a])), along = entry.t_in * ray.d,
            at = (ray.o + along) - origin, middle = (entry.cell[a] - origin) + R(0.5),
            off = R(0x1p-49) * (abs(ray.o) + abs(along) + abs(origin)) + R(0x1p-60);
    low[a] = select(ray.moves, at + off, middle);
    high[a] = select(ray.moves, at - off, middle);
    inverse[a] = select(ray.moves, min(max(ray.inverse * unit, R(-kSteepest)), R(kSteepest)), R(kParallel));
  }
  const R end = (entry.end - entry.t_in) * unit * R(1 + 0x1p-20) + R(0x1p-60);
  double lanes[10][kWidth<R>];
  for (int a = 0; a < 3; ++a) {
    store(lanes[a], low[a]);
    store(lanes[3 + a], high[a]);
    store(lanes[6 + a], inverse[a]);
  }
  store(lanes[9], min(end, R(0x1p126)));
  for (int l = 0; l < kWidth<R>; ++l)
    for (int a = 0; a < 3; ++a) {
      looks[l].low[a] = lanes[a][l];
      looks[l].high[a] = lanes[3 + a][l];
      looks[l].inverse[a] = float(lanes[6 + a][l]);
      looks[l].end = float(lanes[9][l]);
    }
}

template <Real R> void store_rays(const GridRays<R>& rays, R begin, const Entry<R>& entry, WalkingRay* to) {
  const AxisOfRays<R>(&axis)[3] = rays.axis;
  const auto row = [&](int l) { return reinterpret_cast<double*>(to + l); };
  store_columns<R>({{axis[0].o, axis[1].o, axis[2].o, axis[0].d, axis[1].d, axis[2].d, begin, entry.end}},
                   row);
  store_columns<R>({{axis[0].inverse, axis[1].inverse, axis[2].inverse, entry.cell[0], entry.cell[1],
                     entry.cell[2], entry.t_in, entry.axis_in}},
                   [&](int l) { return row(l) + 8; });
}

/// Queues the rays that enter within [t_min, t_max]. cells: where they are known to be, by their slots; null:
/// where they enter.
template <Real R>
void enter_rays(const MarchField& field, const RayStream& rays, const double (&t_max)[kStreamSize],
                const std::int32_t (*cells)[kStreamSize], WalkingRays& to) {
  to.size = 0;
  for (int i = 0; i < rays.size; i += kWidth<R>) {
    const R begin = load<R>(rays.t_min + i), end = min(load<R>(t_max + i), R(__DBL_MAX__));
    unsigned bits = bits_of(begin <= end);
    if (rays.size - i < kWidth<R>) bits &= (1u << (rays.size - i)) - 1;
    if (bits == 0) continue;
    const GridRays<R> grid_rays(*field.query, rays, i);
    Entry<R> entry = enter_cells(field, grid_rays, begin, end, mask_of_bits<R>(bits));
    bits = bits_of(entry.enters);
    if (bits == 0) continue;
    if (cells) {
      for (int a = 0; a < 3; ++a) entry.cell[a] = load_as<R>(cells[a] + i);
      resume_in_cells(grid_rays, begin, entry);
    }
    store_rays(grid_rays, begin, entry, to.ray + i);
    store_looks(field, grid_rays, entry, to.look + i);
    for (; bits; bits &= bits - 1) {
      const int slot = i + __builtin_ctz(bits);
      to.ended[slot] = false;
      to.tested[slot] = 0;
      to.queue[to.size++] = std::uint16_t(slot);
    }
  }
}

}  // namespace isocast::inline ISO_ISA
