// Rays that beams cannot tell, each for itself: sixty-four at a time, a finished one replaced by the next.
#pragma once

#include <isocast/implicit/beams/block_leaves.h>
#include <isocast/implicit/solve/levels.h>
#include <isocast/implicit/solve/slots.h>

namespace isocast::inline ISO_ISA {

/// The first root of each piece, by forms that follow the ray.
///
/// walk     what trimming leaves of a part is the next one, or half of it where trimming does not halve it;
///          behind a part without roots comes one twice as long
/// seams    forms reach a little over the ends of their part, so that a root at an end lies inside
/// unclear  a ray is left open from a part on that is too short to be divided, or trimmed to nothing
template <Real R> class RaySearch {
  using T = Scalar<R>;
  using F = AffineForm<R, 1>;
  static constexpr int kPacks = kSlots / kWidth<R>;

 public:
  /// Bytes for each register of the tape.
  static constexpr std::size_t kRegisterBytes = kPacks * sizeof(F);

  ISO_HD RaySearch(const FormulaQuery<T>& query, const BlockRays<T>& rays, BlockRoots<T>& roots,
                   BlockLeaves<R>& leaves, void* registers)
      : query_(query), rays_(rays), roots_(roots), leaves_(leaves), registers_(registers) {}

  /// Whether pieces are to be run before more of them come.
  [[nodiscard]] ISO_HD bool is_full() const { return waiting_ + kSlots > kMostPieces; }
  ISO_HD void add(const RayPiece<T>& piece) {
    if (piece.from <= piece.to) roots_.pieces[waiting_++] = piece;
  }

  /// Until no piece is left, or the block is unwanted.
  ISO_HD void run() {
    next_ = 0;
    for (refill(); busy_ != 0 && !roots_.is_unwanted(); refill()) round();
    waiting_ = 0, busy_ = 0;
  }

 private:
  ISO_HD void refill() {
    for (SlotBits free = ~busy_; free != 0 && next_ < waiting_; free &= free - 1) {
      const int i = __builtin_ctzll(free);
      while (next_ < waiting_ && !start(i, roots_.pieces[next_++])) {}
    }
  }
  ISO_HD bool start(int i, const RayPiece<T>& piece) {
    const int slot = pixel_slot(piece.x, piece.y);
    if (!(piece.from < min(roots_.lo[slot], roots_.unclear[slot]))) return false;
    T from = piece.from, to = piece.to;
    if (!piece.inside) {
      const BoxRange<T> box = box_range(rays_, T(piece.x) - side(), T(piece.y) - side(), T(0));
      from = max(from, box.enters_from), to = min(to, box.leaves_to);
      if (!(from <= to)) return false;
    }
    x_[i] = T(piece.x), y_[i] = T(piece.y);
    from_[i] = from, to_[i] = to, step_[i] = to - from, start_[i] = from;
    slot_[i] = slot;
    const SlotBits bit = SlotBits(1) << i;
    busy_ |= bit;
    inside_ = piece.inside ? inside_ | bit : inside_ & ~bit;
    return true;
  }
  ISO_HD static T side() { return T(0.5) * T(kBlockSide - 1); }
  ISO_HD static R get(const T (&values)[kSlots], int p) { return load<R>(values + p * kWidth<R>); }

  // One evaluation for every ray in work.
  ISO_HD void round() {
    int packs[kPacks], count = 0;
    for (int p = 0; p < kPacks; ++p)
      if (any(lanes_of<R>(busy_, p))) packs[count++] = p;
    F inputs[4 * kPacks];
    R begin[kPacks], length[kPacks];
    for (int n = 0; n < count; ++n) {
      const int p = packs[n];
      const R a = get(from_, p), b = min(a + get(step_, p), get(to_, p));
      const R over = R(T(1) / T(16)) * (b - a) + R(T(0.125) * rays_.eps);
      begin[n] = a - over, length[n] = (b + over) - begin[n];
      put_inputs(begin[n], length[n], p, n, inputs);
    }
    const F* const f =
        evaluate_some<kPacks>(query_.tape, static_cast<const F*>(inputs), static_cast<F*>(registers_), count);
    for (int n = 0; n < count; ++n) judge(f[n], begin[n], length[n], packs[n]);
  }
  ISO_HD void put_inputs(R begin, R length, int p, int n, F* inputs) const {
    const R u = get(x_, p) - R(side()), v = get(y_, p) - R(side());
    const R half = R(T(0.5)) * length, t = begin + half;
    // a little more than half of it, for the roundings of its ends
    const R deep = half + R(T(4) * kSpacing<T>) * (abs(begin) + half), size = abs(t) + deep;
    for (int a = 0; a < 3; ++a) {
      const R d = R(rays_.span[a]) + u * R(rays_.span_u[a]) + v * R(rays_.span_v[a]);
      F& x = inputs[a * kPacks + n];
      x.c = R(rays_.start[a]) + u * R(rays_.start_u[a]) + v * R(rays_.start_v[a]) + t * d;
      x.e[0] = deep * d;
      x.r = raised(R(rays_.slack[a]) + size * R(rays_.spread[a]));
      x.defined = x.continuous = Mask<R>(true);
      x.empty = Mask<R>(false);
    }
    inputs[3 * kPacks + n] = constant_as({query_.time, true}, F{});
  }

  ISO_HD void judge(const F& f, R begin, R length, int p) {
    const R a = get(from_, p), step = get(step_, p), to = get(to_, p), b = min(a + step, to);
    const Levels<R> found = find_levels(f, R(T(0)), R(T(1)), query_);
    const R rounding = R(T(8) * kSpacing<T>) * (abs(begin) + length);
    const R near = begin + found.near * length - rounding, far = begin + found.far * length + rounding,
            first_far = begin + found.first_far * length + rounding;
    const Mask<R> here = lanes_of<R>(busy_, p);
    const Mask<R> out = leaves_out(interval_of(f), query_) | (near > b) | (far < a);
    const Mask<R> hit = here & (!out) & found.alone() & (first_far - near <= R(rays_.eps)) & (first_far >= a);
    const R next = max(a, near), rest = min(b, far) - next;
    // trimmed to its beginning, where forms may not agree: the ray would go on from there for ever
    const Mask<R> shortest = (b - a <= R(max(T(0.25) * rays_.eps, rays_.least))) | (rest <= R(T(0)));
    const Mask<R> unclear = here & (!(out | hit)) & shortest;
    const Mask<R> over = here & out & (b >= to);
    store(from_ + p * kWidth<R>, select(out, b, next));
    store(step_ + p * kWidth<R>, select(out, max(step + step, R(rays_.least)),
                                        select(rest < R(T(0.5)) * (b - a), rest, R(T(0.5)) * rest)));
    roots_.evaluations += __builtin_popcount(bits_of(here));
    if (any(unclear)) for_lanes(p, unclear, [&](int, int i) { leaves_.leave(slot_[i], from_[i]); });
    if (any(hit)) report(p, hit, found, near, first_far, begin + found.middle * length, f.e[0] / length);
    busy_ &= ~(SlotBits(bits_of(hit | unclear | over)) << (p * kWidth<R>));
  }
  ISO_HD void report(int p, Mask<R> hit, const Levels<R>& found, R near, R far, R middle, R half_slope) {
    // a piece in the domain may have been left at its ends
    const Mask<R> inside = lanes_of<R>(inside_, p) & (near >= get(start_, p)) & (far <= get(to_, p));
    const Mask<R> open = hit & !inside;
    if (any(open))
      hit = hit & (inside | leaves_.in_domain(get(x_, p) - R(side()), get(y_, p) - R(side()), near, far, open,
                                              slot_ + p * kWidth<R>));
    T lo[kWidth<R>], hi[kWidth<R>], t[kWidth<R>], slope[kWidth<R>], iso[kWidth<R>];
    store(lo, near), store(hi, far), store(t, middle), store(slope, half_slope + half_slope);
    store(iso, found.iso);
    for_lanes(p, hit, [&](int l, int i) {
      if (!(lo[l] < roots_.lo[slot_[i]])) return;
      const int s = slot_[i];
      roots_.lo[s] = lo[l], roots_.hi[s] = hi[l], roots_.t[s] = t[l], roots_.slope[s] = slope[l];
      roots_.side[s] = slope[l] > T(0) ? iso[l] + T(1) : -iso[l] - T(1);
    });
  }
  template <class Call> ISO_HD static void for_lanes(int p, Mask<R> lanes, Call call) {
    for (unsigned rest = bits_of(lanes); rest; rest &= rest - 1) {
      const int l = __builtin_ctz(rest);
      call(l, p * kWidth<R> + l);
    }
  }

  const FormulaQuery<T>& query_;
  const BlockRays<T>& rays_;
  BlockRoots<T>& roots_;
  BlockLeaves<R>& leaves_;
  void* registers_;
  alignas(64) T x_[kSlots] = {}, y_[kSlots] = {}, from_[kSlots] = {}, to_[kSlots] = {}, step_[kSlots] = {},
                start_[kSlots] = {};
  int slot_[kSlots] = {};
  SlotBits busy_ = 0, inside_ = 0;
  int waiting_ = 0, next_ = 0;
};

}  // namespace isocast::inline ISO_ISA
