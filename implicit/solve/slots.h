// Rays in work: as many as an operation of the tape is run on at once, a finished one replaced by the next.
#pragma once

#include <isocast/implicit/solve/segment.h>
#include <isocast/math/lanes.h>
#include <isocast/math/rounding.h>

namespace isocast::inline ISO_ISA {

#ifdef ISO_ONE_RAY
/// A thread of a GPU has one ray in work.
inline constexpr int kSlots = 1;
#else
inline constexpr int kSlots = 64;
#endif
/// One bit a slot.
using SlotBits = std::uint64_t;

/// The lanes of pack p of a SlotBits.
template <Real R> ISO_HD inline Mask<R> lanes_of(SlotBits bits, int p) {
  const auto mine = static_cast<std::uint32_t>(bits >> (p * kWidth<R>));
  if constexpr (kWidth<R> == 1) return mine & 1;
  else if constexpr (sizeof(Mask<R>) <= 2) return Mask<R>(typename Mask<R>::Bits(mine));
  else {
    typename Mask<R>::Bits lane;
    for (int l = 0; l < kWidth<R>; ++l) lane[l] = 1 << l;
    const typename Mask<R>::Bits all = lane - lane + static_cast<typename Mask<R>::Int>(mine);
    return Mask<R>((all & lane) != 0);
  }
}
/// Puts the lanes of pack p into a SlotBits.
template <Real R> ISO_HD inline void put_lanes(SlotBits& bits, int p, Mask<R> mask) {
  const SlotBits all = ((SlotBits(1) << (kWidth<R> - 1) << 1) - 1) << (p * kWidth<R>);
  bits = (bits & ~all) | (SlotBits(bits_of(mask)) << (p * kWidth<R>)&all);
}

/// What is kept of a ray in a slot.
///
/// ex ... wz            its segment: e, d and slack of three axes
/// start                where it began, in s
/// begin                before it no root, proved
/// cut, cut_end         from cut to cut_end none either; nothing is known behind cut_end
/// offset, scale, k, w  the part in turn on a path of halves: from k to k + w, s = offset + scale k
/// reach                how far behind a part f is looked at for its side: as far as roundings hide it
/// open, open_iso       where f came so close to that iso-value that its side is hidden; 2: nowhere
/// value, slope         f and df/dt at begin, of marching points
/// judged, runs         small parts looked at, evaluations
enum Field {
  // clang-format off
  kEx, kEy, kEz, kDx, kDy, kDz, kWx, kWy, kWz, kStart, kSmallestPart, kOffset, kScale, kBegin, kCut, kCutEnd, kK, kW,
  kReach, kOpen, kOpenIso, kValue, kSlope, kJudged, kRuns, kFields
  // clang-format on
};

/// Slots of rays in structure of arrays.
///
/// busy     a ray is here and not finished
/// carried  its sides were known at its start
/// known    its sides are known: below[i] of each iso-value, at begin or, if that is nearer, at open
/// smooth   f is continuous from open to begin
template <Real R> struct Slots {
  using T = Scalar<R>;
  static constexpr int kPacks = kSlots / kWidth<R>;

  alignas(64) T field[kFields][kSlots];
  int ray[kSlots];
  SlotBits busy = 0, carried = 0, known = 0, smooth = 0, below[kMostIsos] = {};

  ISO_HD R get(Field f, int p) const { return load<R>(field[f] + p * kWidth<R>); }
  ISO_HD void set(Field f, int p, R value) { store(field[f] + p * kWidth<R>, value); }
  /// Adds to a counter in these lanes.
  ISO_HD void add(Field f, int p, Mask<R> where, int more) {
    set(f, p, get(f, p) + select(where, R(T(more)), R(0)));
  }

  /// A number of packs that is not 0: the compiler knows it where there is but one.
  ISO_HD static constexpr int some_packs(int count) { return kPacks == 1 ? 1 : count; }

  /// The packs that hold a busy lane, one at least.
  ISO_HD int packs_in_work(int (&packs)[kPacks]) const {
    packs[0] = 0;
    int count = 0;
    if constexpr (kPacks > 1)
      for (int p = 0; p < kPacks; ++p)
        if (any(lanes_of<R>(busy, p))) packs[count++] = p;
    return some_packs(count);
  }

  /// call(lane, ray) for some lanes of a pack.
  template <class Call> ISO_HD void for_lanes(int p, Mask<R> lanes, Call call) const {
    isocast::for_lanes<kWidth<R>>(bits_of(lanes), [&](int l) { call(l, ray[p * kWidth<R> + l]); });
  }

  /// Puts ray i of the stream into a slot.
  ISO_HD void start(const SegmentStream<T>& stream, int i, int slot, int iso_count) {
    const SlotBits bit = SlotBits(1) << slot;
    for (int a = 0; a < 3; ++a) {
      field[kEx + a][slot] = stream.e[a][i];
      field[kDx + a][slot] = stream.d[a][i];
      field[kWx + a][slot] = stream.slack[a][i];
    }
    field[kStart][slot] = field[kBegin][slot] = stream.begin[i];
    field[kSmallestPart][slot] = stream.smallest[i];
    field[kOffset][slot] = stream.k_offset[i];
    field[kScale][slot] = stream.k_scale[i];
    field[kCut][slot] = field[kCutEnd][slot] = field[kW][slot] = T(1);
    field[kOpen][slot] = T(2);
    field[kOpenIso][slot] = T(0);
    field[kK][slot] = field[kReach][slot] = field[kValue][slot] = field[kSlope][slot] = field[kJudged][slot] =
        field[kRuns][slot] = T(0);
    ray[slot] = i;
    const auto put = [bit](SlotBits& bits, bool on) { bits = on ? bits | bit : bits & ~bit; };
    put(busy, true);
    put(carried, stream.carried[i]);
    put(known, stream.carried[i]);
    put(smooth, true);
    for (int n = 0; n < iso_count; ++n) put(below[n], stream.sides[i] >> n & 1);
  }

  /// Moves the ray of a slot to a free one.
  ISO_HD void move(int from, int to, int iso_count) {
    for (int f = 0; f < kFields; ++f) field[f][to] = field[f][from];
    ray[to] = ray[from];
    const auto move_bit = [from, to](SlotBits& bits) {
      bits = (bits & ~(SlotBits(1) << to)) | ((bits >> from & 1) << to);
    };
    move_bit(busy), move_bit(carried), move_bit(known), move_bit(smooth);
    for (int n = 0; n < iso_count; ++n) move_bit(below[n]);
    busy &= ~(SlotBits(1) << from);
  }

  /// Fills the holes among the busy slots from their end.
  ISO_HD void close_ranks(int iso_count) {
    for (; kSlots > 1;) {
      if (busy == 0 || ~busy == 0) return;
      const int hole = lowest_bit(~busy), last = highest_bit(busy);
      if (last / kWidth<R> == hole / kWidth<R> || hole > last) return;
      move(last, hole, iso_count);
    }
  }
};

}  // namespace isocast::inline ISO_ISA
