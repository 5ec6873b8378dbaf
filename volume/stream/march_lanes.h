// Rays to their next active cells, as many at a time as a register has lanes.
#pragma once

#include <isocast/volume/stream/crossings.h>
#include <isocast/volume/stream/empty_cubes.h>
#include <isocast/volume/stream/walking_rays.h>

namespace isocast::inline ISO_ISA {

/// Some of the queued rays of a stream on the march, one a lane; a lane whose ray is done takes the next one.
/// A step leads out of an empty node (128^3 cells of a sparse grid), brick (16^3) or block (4^3), or from
/// cell to cell, by crossings in the walk's order (traverse.h): so rays visit the cells that the walk does,
/// with the same bits.
template <Real R> class MarchLanes {
 public:
  /// waiting  the number of rays that are queued; next: the first of them that no lane has taken. Those that
  /// have
  ///          found a cell are left in the queue, of the size rays.size.
  MarchLanes(const MarchField& field, WalkingRays& rays, int waiting, int& next)
      : field_(field), rays_(rays), waiting_(waiting), next_(next) {
    for (int l = 0; l < kLanes; ++l) take_ray(l);
  }

  [[nodiscard]] bool busy() const { return busy_ != 0; }

  /// Takes each ray one step on, or to the cell it has found.
  void advance(TraceCounts& counts) {
    while (ask_) look_up(counts);
    const unsigned before = busy_, on = step();
    ask_ = before & on;
    for (unsigned gone = before & ~on; gone; gone &= gone - 1) {
      const int l = __builtin_ctz(gone);
      rays_.tested[slot_[l]] += std::uint32_t(tested_[l]);
      take_ray(l);
    }
  }

 private:
  static constexpr int kLanes = kWidth<R>;

  // Puts the next waiting ray into a lane. It is asked for its cell's bits, or first steps out of its cell.
  void take_ray(int l) {
    const unsigned bit = 1u << l;
    ask_ &= ~bit;
    stepped_ &= ~bit;
    size_[l] = 1;
    if (next_ == waiting_) {
      busy_ &= ~bit;
      t_end_[l] = -__builtin_inf();
      return;
    }
    const int slot = rays_.queue[next_++];
    for (int a = 0; a < 3; ++a) {
      o_[a][l] = rays_.o[a][slot];
      d_[a][l] = rays_.d[a][slot];
      inverse_[a][l] = rays_.inverse[a][slot];
      cell_[a][l] = rays_.cell[a][slot];
    }
    t_in_[l] = rays_.t_in[slot];
    axis_in_[l] = rays_.axis_in[slot];
    t_end_[l] = rays_.t_end[slot];
    slot_[l] = slot;
    tested_[l] = 0;
    busy_ |= bit;
    if (rays_.fresh[slot]) ask_ |= bit;
  }

  void put_back(int l) {
    const int slot = slot_[l];
    for (int a = 0; a < 3; ++a) rays_.cell[a][slot] = cell_[a][l];
    rays_.t_in[slot] = t_in_[l];
    rays_.axis_in[slot] = axis_in_[l];
    rays_.tested[slot] += std::uint32_t(tested_[l]);
    if (stepped_ >> l & 1) rays_.fresh[slot] = false;
    rays_.queue[rays_.size++] = std::uint16_t(slot);
  }

  // Asks the masks about the cells of the lanes that want it.
  void look_up(TraceCounts& counts) {
    const unsigned asked = ask_;
    ask_ = 0;
    CellPlaces<R> places;
    R block = R(0), bit = R(0);
    for (int a = 2; a >= 0; --a) {
      const R at = load<R>(cell_[a]) - R(double(field_.bricks.origin[a])), blocks = whole(at * R(1 / kBlock));
      places.brick[a] = whole(at * R(1 / kBrick));
      block = block * R(4) + (blocks - R(4) * places.brick[a]);
      bit = bit * R(4) + (at - R(4) * blocks);
    }
    places.block = block;
    places.bit = bit;
    const R size = empty_cubes(field_, places, asked), before = load<R>(size_);
    const Mask<R> lanes = mask_of_bits<R>(asked), looked = lanes & (size <= R(1));
    store(size_, select(lanes, size, before));
    store(tested_, load<R>(tested_) + select(looked, R(1), R(0)));
    const int cells = __builtin_popcount(bits_of(looked));
    counts.cells += cells;
    counts.macrocells += __builtin_popcount(asked) - cells;
    for (unsigned found = bits_of(lanes & (size == R(0))); found; found &= found - 1) {
      const int l = __builtin_ctz(found);
      put_back(l);
      take_ray(l);
    }
  }

  // Takes all rays out of their cubes, and returns the lanes that have not come to their end.
  unsigned step() {
    const R size = load<R>(size_), per_size = inverse_power_of_two(size);
    const Mask<R> large = size > R(1);
    const bool leaps = any(large);
    R base[3], plane[3], t[3];
    for (int a = 0; a < 3; ++a) {
      const AxisOfRays<R> ray = axis(a);
      base[a] = whole(load<R>(cell_[a]) * per_size) * size;
      plane[a] = min(max(base[a] + size * ray.far, R(field_.first[a])), R(field_.last[a]));
      t[a] = ray.plane_t(plane[a]);
    }
    const NextCrossing<R> out = next_crossing(t[0], t[1], t[2]);
    Mask<R> on = out.t <= load<R>(t_end_);
    for (int a = 0; a < 3; ++a) {
      const AxisOfRays<R> ray = axis(a);
      const R before = load<R>(cell_[a]);
      R cell = before;
      if (leaps) {
        const R lo = max(base[a], R(field_.low[a])), hi = min(base[a] + size, R(field_.high[a])) - R(1);
        const Mask<R> leapt = large & ray.moves;
        cell = select(leapt, cell_after(ray, a, out.t, out.axis, lo, hi, leapt & on), before);
      }
      cell = select(out.axis == R(double(a)), plane[a] - ray.near, cell);
      on = on & (cell >= R(field_.low[a])) & (cell < R(field_.high[a]));
      store(cell_[a], cell);
    }
    store(t_in_, out.t);
    store(axis_in_, out.axis);
    stepped_ |= busy_;
    return bits_of(on);
  }

  AxisOfRays<R> axis(int a) const { return {load<R>(o_[a]), load<R>(d_[a]), load<R>(inverse_[a])}; }

  const MarchField& field_;
  WalkingRays& rays_;
  int waiting_;
  int& next_;
  unsigned busy_ = 0, ask_ = 0, stepped_ = 0;  // a bit for each lane
  alignas(64) double o_[3][kLanes] = {}, d_[3][kLanes] = {}, inverse_[3][kLanes] = {}, cell_[3][kLanes] = {};
  alignas(64) double t_in_[kLanes] = {}, axis_in_[kLanes] = {}, t_end_[kLanes] = {}, size_[kLanes] = {},
                     tested_[kLanes] = {};
  int slot_[kLanes] = {};
};

/// Marches the queued rays until each has found an active cell, and is left in the queue, or is at its end.
template <Real R> void march_rays(const MarchField& field, WalkingRays& rays, TraceCounts& counts) {
  const int waiting = rays.size;
  int next = 0;
  rays.size = 0;
  // two registers of rays: one works while the other waits for its masks
  MarchLanes<R> one(field, rays, waiting, next), two(field, rays, waiting, next);
  while (one.busy() || two.busy()) {
    one.advance(counts);
    two.advance(counts);
  }
}

}  // namespace isocast::inline ISO_ISA
