// What is proved of single rays of a block: crossings go to the rays, nearest first.
#pragma once

#include <isocast/implicit/beams/box_range.h>
#include <isocast/implicit/solve/slots.h>

namespace isocast::inline ISO_ISA {

/// All rays of a beam cross f = iso once, near the plane at + u along_u + v along_v, within `radius` of it in
/// depth, u and v counted from the beam's middle; `inside` the domain.
template <class T> struct BeamCrossing {
  int x, y, size;
  T at, along_u, along_v, radius, slope;
  std::uint8_t iso;
  bool rises, inside;
};

/// The packets that a square of pixels touches, and which lanes of them: all of them, if it is that large.
struct PacketSquare {
  int x0, y0, x1, y1;
  std::uint32_t lanes = 0xffff;
  ISO_HD PacketSquare(int x, int y, int size)
      : x0(x / kPacketSide),
        y0(y / kPacketSide),
        x1((x + size - 1) / kPacketSide),
        y1((y + size - 1) / kPacketSide) {
    if (size >= kPacketSide) return;
    const std::uint32_t row = ((1u << size) - 1) << x % kPacketSide;
    lanes = 0;
    for (int i = 0; i < size; ++i) lanes |= row << kPacketSide * (y % kPacketSide + i);
  }
  /// call(slot of the packet's first pixel, its x, its y).
  template <class Call> ISO_HD void each(Call call) const {
    for (int py = y0; py <= y1; ++py)
      for (int px = x0; px <= x1; ++px)
        call(pixel_slot(px * kPacketSide, py * kPacketSide), px * kPacketSide, py * kPacketSide);
  }
};

/// The rays of a block, and what was found on them so far.
///
/// nearest  of several crossings of a ray the one whose bracket begins first is kept: it holds the first
///          root, if every part of the ray before it was looked at
template <Real R> class BlockLeaves {
  using T = Scalar<R>;
  static constexpr int kPacketLanes = 16, kPacks = kPacketLanes / kWidth<R>;

 public:
  ISO_HD BlockLeaves(const BlockRays<T>& rays, BlockRoots<T>& roots) : rays_(rays), roots_(roots) {
    for (int l = 0; l < kPacketLanes; ++l) lane_x_[l] = T(l % kPacketSide), lane_y_[l] = T(l / kPacketSide);
  }

  /// Begins a block: nothing is found.
  ISO_HD void clear() {
    roots_.evaluations = 0;
    PacketSquare(0, 0, kBlockSide).each([this](int slot, int x, int y) {
      for (int p = 0; p < kPacks; ++p) {
        const Mask<R> outside = (column(x, p) >= R(T(rays_.columns))) | (row(y, p) >= R(T(rays_.rows)));
        const R infinite = R(kInfinity<T>);
        store(roots_.lo + slot + p * kWidth<R>, select(outside, -infinite, infinite));
        store(roots_.unclear + slot + p * kWidth<R>, infinite);
      }
    });
  }

  /// Whether every ray of a square has a root before `depth`.
  ISO_HD bool hides(int x, int y, int size, T depth) const {
    const PacketSquare square(x, y, size);
    for (int py = square.y0; py <= square.y1; ++py)
      for (int px = square.x0; px <= square.x1; ++px) {
        const T* const lo = roots_.lo + pixel_slot(px * kPacketSide, py * kPacketSide);
        for (int p = 0; p < kPacks; ++p)
          if (any(lanes_of<R>(SlotBits(square.lanes), p) & (load<R>(lo + p * kWidth<R>) > R(depth))))
            return false;
      }
    return true;
  }

  /// Roots of rays from `depth` on are not known: of one, of a square of them.
  ISO_HD void leave(int slot, T depth) { roots_.unclear[slot] = min(roots_.unclear[slot], depth); }
  ISO_HD void leave(int x, int y, int size, T depth) {
    for (int j = y; j < y + size && j < rays_.rows; ++j)
      for (int i = x; i < x + size && i < rays_.columns; ++i) leave(pixel_slot(i, j), depth);
  }

  /// Gives the crossing to all rays of the beam that are in the domain there.
  ISO_HD void cross(const BeamCrossing<T>& beam) {
    const PacketSquare square(beam.x, beam.y, beam.size);
    const R middle_x = R(T(beam.x) + T(0.5) * T(beam.size - 1)),
            middle_y = R(T(beam.y) + T(0.5) * T(beam.size - 1));
    square.each([&](int slot, int x, int y) {
      for (int p = 0; p < kPacks; ++p) {
        const R u = column(x, p), v = row(y, p);
        const R t = R(beam.at) + (u - middle_x) * R(beam.along_u) + (v - middle_y) * R(beam.along_v);
        const Mask<R> here = lanes_of<R>(SlotBits(square.lanes), p);
        const int first = slot + p * kWidth<R>;
        int slots[kWidth<R>];
        for (int l = 0; l < kWidth<R>; ++l) slots[l] = first + l;
        give(beam, first, t,
             beam.inside ? here
                         : here & in_domain(u - side(), v - side(), t - R(beam.radius), t + R(beam.radius),
                                            here, slots));
      }
    });
  }

  /// Which rays (u, v) have a bracket in the domain; those of which a face of it cuts the bracket are left.
  ISO_HD Mask<R> in_domain(R u, R v, R lo, R hi, Mask<R> here, const int* slots) {
    const BoxRange<R> box = box_range(rays_, u, v, R(T(0)));
    const Mask<R> inside = (lo >= box.enters_to) & (hi <= box.leaves_from),
                  outside = (hi < box.enters_from) | (lo > box.leaves_to);
    const Mask<R> cut = here & !(inside | outside);
    T depth[kWidth<R>];
    store(depth, lo);
    for (unsigned rest = bits_of(cut); rest; rest &= rest - 1) {
      const int l = __builtin_ctz(rest);
      leave(slots[l], depth[l]);
    }
    return inside;
  }

 private:
  ISO_HD static R side() { return R(T(0.5) * T(kBlockSide - 1)); }
  ISO_HD void give(const BeamCrossing<T>& beam, int slot, R t, Mask<R> where) {
    const R lo = t - R(beam.radius);
    const Mask<R> nearer = where & (lo < load<R>(roots_.lo + slot));
    if (!any(nearer)) return;
    put(roots_.lo + slot, nearer, lo), put(roots_.hi + slot, nearer, t + R(beam.radius));
    put(roots_.t + slot, nearer, t), put(roots_.slope + slot, nearer, R(beam.slope));
    put(roots_.side + slot, nearer, R(T(beam.rises ? beam.iso + 1 : -beam.iso - 1)));
  }
  ISO_HD static void put(T* values, Mask<R> where, R value) {
    store(values, select(where, value, load<R>(values)));
  }
  ISO_HD R column(int x, int p) const { return R(T(x)) + load<R>(lane_x_ + p * kWidth<R>); }
  ISO_HD R row(int y, int p) const { return R(T(y)) + load<R>(lane_y_ + p * kWidth<R>); }

  const BlockRays<T>& rays_;
  BlockRoots<T>& roots_;
  alignas(64) T lane_x_[kPacketLanes], lane_y_[kPacketLanes];
};

}  // namespace isocast::inline ISO_ISA
