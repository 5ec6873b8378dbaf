// Where the rays of a stream enter a grid.
#pragma once

#include <isocast/volume/stream/crossings.h>
#include <isocast/volume/stream/lane_bits.h>
#include <isocast/volume/stream/march_field.h>
#include <isocast/volume/stream/walking_rays.h>

namespace isocast::inline ISO_ISA {

/// Rays of the world in grid space, with the bits of grid_ray (trace_stream.h).
template <Real R> void to_grid(const VolumeQuery& query, const RayStream& rays, int i, WalkingRays& to) {
  const R x = load<R>(rays.ox + i), y = load<R>(rays.oy + i), z = load<R>(rays.oz + i),
          dx = load<R>(rays.dx + i), dy = load<R>(rays.dy + i), dz = load<R>(rays.dz + i);
  for (int a = 0; a < 3; ++a) {
    const double(&m)[4] = query.grid_from_world[a];
    const R d = R(m[0]) * dx + R(m[1]) * dy + R(m[2]) * dz;
    store(to.o[a] + i, R(m[0]) * x + R(m[1]) * y + R(m[2]) * z + R(m[3]));
    store(to.d[a] + i, d);
    store(to.inverse[a] + i, R(1) / d);
  }
}

/// As enter_grid and find_block (traverse.h) have it: between the planes that enclose all active cells, in
/// the first cell of the ray. Queues the rays that enter within [t_min, t_max].
template <Real R>
void enter_rays(const MarchField& field, const RayStream& rays, const double (&t_max)[kStreamSize],
                WalkingRays& to) {
  to.size = 0;
  for (int i = 0; i < rays.size; i += kWidth<R>) {
    R t_in = load<R>(rays.t_min + i), t_end = min(load<R>(t_max + i), R(__DBL_MAX__)), axis_in = R(kStart);
    unsigned bits = bits_of(t_in <= t_end);
    if (rays.size - i < kWidth<R>) bits &= (1u << (rays.size - i)) - 1;
    if (bits == 0) continue;
    to_grid<R>(*field.query, rays, i, to);
    Mask<R> enters = mask_of_bits<R>(bits);
    for (int a = 0; a < 3; ++a) {
      const AxisOfRays<R> ray(load<R>(to.o[a] + i), load<R>(to.d[a] + i), load<R>(to.inverse[a] + i));
      const R low = R(field.low[a]), high = R(field.high[a]);
      enters = enters & (ray.moves | ((ray.o >= low) & (ray.o <= high) & (ray.d == ray.d)));
      const R near = (select(ray.back, high, low) - ray.o) * ray.inverse,
              far = (select(ray.back, low, high) - ray.o) * ray.inverse;
      const Mask<R> later = ray.moves & select(axis_in == R(kStart), near > t_in, near >= t_in);
      t_in = select(later, near, t_in);
      axis_in = select(later, R(double(a)), axis_in);
      t_end = select(ray.moves, min(t_end, far), t_end);
    }
    enters = enters & (t_in <= t_end) & (t_in < R(__builtin_inf()));
    bits = bits_of(enters);
    if (bits == 0) continue;
    for (int a = 0; a < 3; ++a) {
      const AxisOfRays<R> ray(load<R>(to.o[a] + i), load<R>(to.d[a] + i), load<R>(to.inverse[a] + i));
      const R lo = R(field.low[a]), hi = R(field.high[a] - 1);
      const R through = select(ray.back, hi, lo);  // the face that was entered through
      R cell = select(axis_in == R(double(a)), through, cell_after(ray, a, t_in, axis_in, lo, hi, enters));
      cell = select(ray.moves, cell, parallel_cell(ray, lo, hi));
      store(to.cell[a] + i, cell);
    }
    store(to.t_in + i, t_in);
    store(to.axis_in + i, axis_in);
    store(to.t_end + i, t_end);
    for (; bits; bits &= bits - 1) {
      const int slot = i + __builtin_ctz(bits);
      to.fresh[slot] = true;
      to.tested[slot] = 0;
      to.queue[to.size++] = std::uint16_t(slot);
    }
  }
}

/// Puts queued rays into cells that they are known to cross, as resume_in_cell (traverse.h) has it.
/// cells  of their slots
template <Real R>
void resume_rays(const RayStream& rays, const std::int32_t (&cells)[3][kStreamSize], WalkingRays& to) {
  for (int n = 0; n < to.size;) {
    const int i =
        to.queue[n] / kWidth<R> * kWidth<R>;  // in their order: the slots of a register lie together
    while (n < to.size && to.queue[n] < i + kWidth<R>) ++n;
    R t_in = load<R>(rays.t_min + i), axis_in = R(kStart);
    for (int a = 0; a < 3; ++a) {
      for (int l = 0; l < kWidth<R>; ++l) to.cell[a][i + l] = double(cells[a][i + l]);
      const AxisOfRays<R> ray(load<R>(to.o[a] + i), load<R>(to.d[a] + i), load<R>(to.inverse[a] + i));
      const R near = ray.plane_t(load<R>(to.cell[a] + i) + ray.near);
      const Mask<R> later = ray.moves & select(axis_in == R(kStart), near > t_in, near >= t_in);
      t_in = select(later, near, t_in);
      axis_in = select(later, R(double(a)), axis_in);
    }
    store(to.t_in + i, t_in);
    store(to.axis_in + i, axis_in);
  }
}

}  // namespace isocast::inline ISO_ISA
