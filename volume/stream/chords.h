// The chords of rays in the cells that they have found.
#pragma once

#include <isocast/volume/stream/crossings.h>
#include <isocast/volume/stream/walking_rays.h>

namespace isocast::inline ISO_ISA {

/// Those of the rays of `slots`, 1 to 16 of them.
template <Real R>
void find_chords(const WalkingRays& rays, const std::uint16_t* slots, int count, CellChords& chords) {
  alignas(64) double o[3][kPacketSize] = {}, d[3][kPacketSize] = {}, inverse[3][kPacketSize] = {},
                     cell[3][kPacketSize] = {}, axis_in[kPacketSize] = {};
  for (int l = 0; l < count; ++l) {
    const int slot = slots[l];
    for (int a = 0; a < 3; ++a) {
      o[a][l] = rays.o[a][slot];
      d[a][l] = rays.d[a][slot];
      inverse[a][l] = rays.inverse[a][slot];
      cell[a][l] = rays.cell[a][slot];
      chords.cell[l][a] = std::int32_t(cell[a][l]);
    }
    chords.t_in[l] = rays.t_in[slot];
    axis_in[l] = rays.axis_in[slot];
    chords.axis_in[l] = int(axis_in[l]);
  }
  for (int i = 0; i < count; i += kWidth<R>) {
    R t[3];
    for (int a = 0; a < 3; ++a) {
      const AxisOfRays<R> ray(load<R>(o[a] + i), load<R>(d[a] + i), load<R>(inverse[a] + i));
      t[a] = ray.plane_t(load<R>(cell[a] + i) + ray.far);
    }
    const NextCrossing<R> out = next_crossing(t[0], t[1], t[2]);
    const R t_in = load<R>(chords.t_in + i), in = load<R>(axis_in + i);
    for (int a = 0; a < 3; ++a) {
      const AxisOfRays<R> ray(load<R>(o[a] + i), load<R>(d[a] + i), load<R>(inverse[a] + i));
      const R base = ray.o - load<R>(cell[a] + i);
      store(chords.entry[a] + i, select(in == R(double(a)), ray.near, clamp01(base + t_in * ray.d)));
      store(chords.exit[a] + i, select(out.axis == R(double(a)), ray.far, clamp01(base + out.t * ray.d)));
    }
    store(chords.t_out + i, out.t);
  }
}

}  // namespace isocast::inline ISO_ISA
