// The first root along each ray of a stream by bisection: parts whose inclusion leaves out every iso-value
// hold none.
#pragma once

#include <isocast/implicit/solve/enquiry.h>
#include <isocast/implicit/solve/held_open.h>

namespace isocast::inline ISO_ISA {

/// Small parts of a ray that are looked at before none is divided any more: bounds the work where f hugs an
/// iso-value or is unbounded all along a ray.
inline constexpr int kMostJudged = 1024;

/// Bisection of many rays, each as if it were alone (or with the others of its packet, where they march
/// together).
///
/// F       Interval<R> or AffineForm<R, 1>
/// parts   a part of a ray is rejected if its inclusion leaves out every iso-value; it is accepted where the
///         form proves a crossing in what trimming leaves of it, or where f is monotone and has different
///         sides at its ends, and that is no longer than `smallest`; else it is divided, near half first
/// walk    without a stack: along a path of halves from k to k + w, w a power of two and k a multiple of it;
///         a form that trims goes where its trimming leads, with a length that doubles after each rejection
/// proved  a hit, if f is continuous in its part and changes sign; a miss; both unless there was doubt
/// source  Knoll, Hijazi, Kensler, Schott, Hansen, Hagen: Fast ray tracing of arbitrary implicit surfaces
///         with interval and affine arithmetic, Computer Graphics Forum 28(1), 2009; the judgement of small
///         parts after Mitchell: Robust ray intersection with interval arithmetic, Graphics Interface 1990,
///         and the interval form of Newton's method
template <class F, Real R> class Bisection {
  using T = Scalar<R>;
  using G = Gradient<Interval<R>>;
  static constexpr int kPacks = Slots<R>::kPacks;
  static constexpr bool kPackets = kSlots >= kPacketSize;  // there is room for packets that march together

 public:
  /// Bytes for each register of the tape.
  static constexpr std::size_t kRegisterBytes = kPacks * (sizeof(G) > sizeof(F) ? sizeof(G) : sizeof(F));

  ISO_HD Bisection(const FormulaQuery<T>& query, const SegmentStream<T>& stream, SegmentRoots<T>& roots,
                   RayRange range, void* registers)
      : query_(query),
        stream_(stream),
        roots_(roots),
        range_(range),
        registers_(registers),
        rays_(query, roots) {}

  /// Fills the roots of the range's active rays. Packets that march together lie in it whole; of one ray, it
  /// marches alone.
  ISO_HD void run() {
    run_those_that_march(false);
    if constexpr (kPackets) run_those_that_march(true);
  }

 private:
  /// Whether a form's trimming leads the way.
  ISO_HD bool free() const {
    const bool newton = query_.options.derivative == Derivative::newton;
    return !together_ && ((query_.options.trim && kTrims<F>) || newton);
  }
  ISO_HD R get(Field field, int p) const { return rays_.get(field, p); }
  ISO_HD HeldOpen<R> held() { return HeldOpen<R>(rays_); }

  ISO_HD void run_those_that_march(bool together) {
    together_ = together;
    next_ = range_.first;
    for (refill(); rays_.busy != 0; refill()) round();
  }
  // Starts the next ray of the stream, or packet of rays, and tells whether it was one to start.
  ISO_HD bool start(int slot, int rays) {
    bool started = false;
    for (int l = 0; l < rays && next_ + l < range_.last; ++l) {
      const int i = next_ + l;
      if (!stream_.active[i] || (kPackets && stream_.together[i / kPacketSize] != together_)) continue;
      roots_.proved[i] = true;
      roots_.hit[i] = stream_.given[i];
      if (stream_.given[i]) {
        take_given(i);
        continue;
      }
      rays_.start(stream_, i, slot + l, isos_in(query_));
      started = true;
    }
    next_ += rays;
    return started;
  }
  ISO_HD void take_given(int i) {
    roots_.s[i] = T(0.5), roots_.s_lo[i] = T(0), roots_.s_hi[i] = T(1);
    roots_.iso[i] = stream_.given_iso[i];
    roots_.sides[i] = stream_.sides[i];
    roots_.evaluations[i] = 0;
  }
  // Puts rays into free slots: singly, or whole packets.
  ISO_HD void refill() {
    const int rays = kPackets && together_ ? kPacketSize : 1;
    const SlotBits all = (SlotBits(1) << rays) - 1;
    for (int slot = 0; slot < kSlots && next_ < range_.last; slot += rays)
      while (!(rays_.busy >> slot & all) && next_ < range_.last) start(slot, rays);
    if (!together_) rays_.close_ranks(isos_in(query_));
  }

  // One evaluation for every ray in work.
  ISO_HD void round() {
    int packs[kPacks];
    const int count = rays_.packs_in_work(packs);
    Part<R> parts[kPacks];
    for (int n = 0; n < count; ++n) propose(packs[n], parts[n]);
    const F* const f = evaluate_over<F>(packs, parts, count,
                                        [](const Part<R>& part) { return RayPart<R>(part.lo, part.hi); });
    for (int n = 0; n < count; ++n) classify(packs[n], f[n], parts[n]);
    if (query_.options.derivative == Derivative::newton) newton(packs, parts, count);
    int small[kPacks], small_count = 0;
    Part<R> small_parts[kPacks];
    for (int n = 0; n < count; ++n) {
      if (!any(parts[n].small)) continue;
      small[small_count] = packs[n];
      small_parts[small_count++] = parts[n];
    }
    if (small_count > 0) judge(small, small_parts, rays_.some_packs(small_count));
    for (int n = 0, m = 0; n < count; ++n) {
      if (m < small_count && small[m] == packs[n]) parts[n] = small_parts[m++];
      if (any(parts[n].accepted)) report(packs[n], parts[n]);
    }
    advance(packs, parts, count);
  }

  // The tape over a part of a ray for each of `count` packs.
  template <class Kind, class PartOf>
  ISO_HD const Kind* evaluate_over(const int* packs, const Part<R>* parts, int count, PartOf part_of) {
    Kind inputs[4 * kPacks];
    for (int n = 0; n < count; ++n) {
      const auto row = [this, p = packs[n]](Field first) {
        return [this, p, first](int a) { return get(Field(first + a), p); };
      };
      part_of(parts[n]).template put<kPacks>(inputs, n, query_.time, row(kEx), row(kDx), row(kWx));
    }
    return evaluate_some<kPacks>(query_.tape, inputs, static_cast<Kind*>(registers_), count);
  }

  ISO_HD R place(int p, R k) const { return clamp01(get(kOffset, p) + get(kScale, p) * k); }

  // The part to look at next.
  ISO_HD void propose(int p, Part<R>& part) const {
    const R begin = get(kBegin, p), cut = get(kCut, p), w = get(kW, p), k = get(kK, p);
    part.lo = free() ? begin : max(begin, place(p, k));
    const R end = free() ? begin + w : place(p, k + w);
    part.hi = max(min(select(part.lo < cut, min(end, cut), end), R(1)), part.lo);
    part.busy = lanes_of<R>(rays_.busy, p);
    part.reach = get(kReach, p);
  }

  // What the inclusion says of the part.
  ISO_HD void classify(int p, const F& f, Part<R>& part) {
    const Interval<R> range = interval_of(f);
    const Mask<R> nothing = part.lo >= part.hi, out = leaves_out(range, query_);
    rays_.add(kRuns, p, part.busy & !nothing, 1);
    part.empty = nothing | out;
    part.finite = (range.lo > R(-kLargest<T>)) & (range.hi < R(kLargest<T>));
    const Mask<R> behind = part.busy & out & (!nothing) & (!range.empty) & held().is_open(p);
    rays_.note_sides(p, part.busy & out & !(nothing | behind), range);
    const Mask<R> unknown = part.busy & !(part.empty | held().is_open(p) | lanes_of<R>(rays_.known, p));
    if (any(unknown)) rays_.note_sides(p, unknown, near_end_of(f));
    take(p,
         query_.options.trim ? find_levels(f, part.lo, part.hi, query_)
                             : find_levels(range, part.lo, part.hi, query_),
         part);
    if (any(behind)) held().close(p, part, behind, range, part.lo);
    const R delta = R(static_cast<T>(query_.options.delta));
    const Mask<R> flat = part.busy & (!(part.empty | part.accepted)) & (range.hi - range.lo <= delta) &
                         !rays_.at_known_start(p, part.lo);
    if (any(flat)) held().leave(p, part, flat);
  }
  // Accepts a crossing that is proved and narrow enough, and finds what is to be judged.
  ISO_HD void take(int p, const Levels<R>& levels, Part<R>& part) {
    const R smallest = rays_.smallest_part(p);
    part.empty = part.empty | (levels.near > levels.far);
    part.near = levels.near, part.far = levels.far, part.resume = levels.resume;
    const Mask<R> known = lanes_of<R>(rays_.known, p);
    const Mask<R> fits = (!known) | (rays_.is_below(p, levels.iso) == levels.rises);
    const R length = levels.first_far - levels.near;
    const Mask<R> narrow = part.busy & (!part.empty) & (length <= smallest);
    // trimmed once more where that is worth it: the bracket shrinks quadratically
    const Mask<R> final = (part.hi - part.lo <= smallest) | (length <= smallest * R(T(0x1p-8)));
    part.accepted = part.proved = narrow & final & levels.alone() & fits & !held().is_open(p);
    part.root = levels;
    // a start on the surface is no crossing: f has its side already
    const Mask<R> start = narrow & levels.crosses & (!fits) & rays_.at_known_start(p, part.lo);
    part.hi = select(start, max(levels.first_far, part.lo), part.hi);
    part.empty = part.empty | start;
    const Mask<R> rest = part.busy & !(part.empty | part.accepted);
    part.small = rest & ((part.hi - part.lo <= smallest) | held().is_open(p));
    if (query_.options.derivative == Derivative::of_all) part.small = rest;
  }
  // One step of the interval Newton method for parts that are neither empty nor small.
  ISO_HD void newton(const int* packs, Part<R>* parts, int count) {
    NewtonForm<R> forms[kPacks];
    const G* const g = evaluate_over<G>(packs, parts, count,
                                        [](const Part<R>& part) { return RayPart<R>(part.lo, part.hi); });
    for (int n = 0; n < count; ++n) {
      forms[n].range = g[n].value;
      forms[n].slope =
          slope_along<R>(g[n], [this, p = packs[n]](int row) { return get(Field(row), p); }).value;
    }
    const Interval<R>* const f = evaluate_over<Interval<R>>(packs, parts, count, [](const Part<R>& part) {
      const R middle = R(0.5) * (part.lo + part.hi);
      return RayPart<R>(middle, middle);
    });
    for (int n = 0; n < count; ++n) {
      forms[n].at_middle = f[n];
      Part<R> part = parts[n];
      const Mask<R> mine = part.busy & !(part.empty | part.small);
      if (!any(mine)) continue;
      rays_.add(kRuns, packs[n], mine, 2);
      part.busy = mine;
      take(packs[n], find_levels(forms[n], part.lo, part.hi, query_), part);
      parts[n].replace(mine, part);
    }
  }

  // Asks f's derivative about small parts, and its values at their ends.
  ISO_HD void judge(const int* packs, Part<R>* parts, int count) {
    bool ask_near = false;
    for (int n = 0; n < count; ++n) {
      parts[n].widen(rays_.smallest_part(packs[n]));
      ask_near = ask_near || any(parts[n].small & !lanes_of<R>(rays_.known, packs[n]));
    }
    const Enquiry<R> enquiry(query_, registers_, rays_, packs, parts, count, ask_near);
    for (int n = 0; n < count; ++n) {
      const int p = packs[n];
      Part<R>& part = parts[n];
      const Slope<R> slope = enquiry.slope(n);
      const Interval<R> at_end = enquiry.at_end(n);
      const Mask<R> unknown = part.small & !lanes_of<R>(rays_.known, p);
      rays_.add(kRuns, p, part.small, 2);
      rays_.add(kRuns, p, unknown, 1);
      rays_.add(kJudged, p, part.small & (part.hi - part.lo <= rays_.smallest_part(p)), 1);
      if (ask_near) rays_.note_sides(p, unknown & !held().is_open(p), enquiry.at_near(n));
      const Mask<R> enough = get(kJudged, p) > R(T(kMostJudged));
      const Mask<R> last_look = (part.hi - part.lo <= R(kLeast<T>)) | enough;
      const Mask<R> open = part.small & held().is_open(p), close_here = open & rays_.sides_known(at_end);
      part.small = part.small & !open;
      decide(part, slope, rays_.ends_of(p, at_end), last_look, rays_.smallest_part(p));
      part.stuck = part.stuck | (open & !close_here);
      if (any(close_here)) {
        put_lanes<R>(rays_.smooth, p, lanes_of<R>(rays_.smooth, p) & (slope.continuous | !close_here));
        part.hi = select(close_here, part.end, part.hi);
        held().close(p, part, close_here, at_end, part.end);
      }
      rays_.note_sides(p, part.small & part.empty & !part.doubt, at_end);
      rays_.forget_sides(p, part.doubt & !part.finite);
      part.over = part.doubt & enough;
      rays_.doubt(p, part.doubt);
      held().hold(p, part, slope.continuous, enough);
    }
  }

  // Writes the roots of the accepted lanes.
  ISO_HD void report(int p, const Part<R>& part) {
    const Levels<R>& root = part.root;
    Part<R> at_near = part;
    at_near.lo = at_near.hi = root.near;
    if (any(part.accepted & !lanes_of<R>(rays_.known, p)))
      rays_.note_sides(p, part.accepted & !lanes_of<R>(rays_.known, p),
                       *evaluate_over<Interval<R>>(
                           &p, &at_near, 1, [](const Part<R>& at) { return RayPart<R>(at.lo, at.hi); }));
    T near[kWidth<R>], far[kWidth<R>], middle[kWidth<R>], iso[kWidth<R>];
    store(near, root.near), store(far, root.first_far), store(middle, root.middle), store(iso, root.iso);
    const unsigned proved = bits_of(part.proved), rises = bits_of(root.rises);
    rays_.for_lanes(p, part.accepted, [&](int l, int ray) {
      const int level = static_cast<int>(iso[l]);
      std::uint32_t sides = 0;
      for (int i = 0; i < isos_in(query_); ++i) sides |= (rays_.below[i] >> (p * kWidth<R> + l) & 1) << i;
      if (proved >> l & 1) sides = (sides & ~(1u << level)) | (rises >> l & 1) << level;
      roots_.hit[ray] = true;
      roots_.proved[ray] = roots_.proved[ray] && (proved >> l & 1);
      roots_.s_lo[ray] = near[l], roots_.s_hi[ray] = far[l], roots_.s[ray] = middle[l];
      roots_.iso[ray] = static_cast<std::uint8_t>(level);
      roots_.sides[ray] = sides;
    });
  }

  // On to the next parts.
  ISO_HD void advance(const int* packs, Part<R>* parts, int count) {
    SlotBits divide = 0, leave = 0, again = 0;
    for (int n = 0; n < count; ++n) {
      const Part<R>& part = parts[n];
      put_lanes<R>(divide, packs[n], part.busy & !(part.empty | part.accepted | part.again));
      put_lanes<R>(leave, packs[n], part.busy & part.empty);
      put_lanes<R>(again, packs[n], part.busy & part.again);
    }
    // a packet divides if one of its rays wants to
    if (kPackets && together_)
      for (int slot = 0; slot < kSlots; slot += kPacketSize) {
        const SlotBits packet = rays_.busy & SlotBits(0xffff) << slot;
        const bool wanted = divide & packet, waits = again & packet;
        divide = wanted && !waits ? divide | packet : divide & ~packet;
        leave = wanted || waits ? leave & ~packet : leave | packet;
      }
    for (int n = 0; n < count; ++n) {
      const int p = packs[n];
      Part<R>& part = parts[n];
      shorten(p, part);
      if (!free()) follow_path(p, lanes_of<R>(divide, p), lanes_of<R>(leave, p));
      const Mask<R> end = (get(kBegin, p) >= R(1)) | (get(kK, p) >= R(1));
      const Mask<R> done = part.accepted | part.over | end;
      const Mask<R> still_open = part.busy & done & held().is_open(p) & !part.accepted;
      if (any(still_open)) {
        part.accepted = Mask<R>(false);
        held().leave(p, part, still_open);
        report(p, part);
      }
      const Mask<R> finished = part.busy & done;
      rays_.for_lanes(p, finished, [this, p](int l, int ray) {
        roots_.evaluations[ray] = static_cast<std::uint32_t>(rays_.field[kRuns][p * kWidth<R> + l]);
      });
      put_lanes<R>(rays_.busy, p, part.busy & !done);
    }
  }
  // What is left of the rays after their parts.
  ISO_HD void shorten(int p, const Part<R>& part) {
    const Mask<R> gone = part.busy & part.empty,
                  divide = part.busy & !(part.empty | part.accepted | part.again);
    const R least = R(T(0.5) * kLeast<T>), far = max(part.far, part.near + least);
    R begin = get(kBegin, p), cut = get(kCut, p), cut_end = get(kCutEnd, p), w = get(kW, p);
    begin = select(gone, max(begin, part.hi), select(divide, part.near, begin));
    const Mask<R> past = gone & (begin >= cut);
    begin = select(past, max(begin, cut_end), begin);
    const Mask<R> cuts = divide & (far < part.hi);
    const R resume = select(part.hi == cut, cut_end, part.hi);
    cut_end = select(past, R(1), select(cuts, select(part.resume < part.hi, part.resume, resume), cut_end));
    cut = select(past, R(1), select(cuts, far, cut));
    rays_.set(kBegin, p, begin), rays_.set(kCut, p, cut), rays_.set(kCutEnd, p, cut_end);
    rays_.set(kReach, p, part.reach);
    if (!free()) return;
    const R length = far - part.near, half = R(0.5) * (part.hi - part.lo);
    const R next = max(select(length <= half, length, R(0.5) * length), least);
    // where a side is hidden in small steps, so as not to leap over a dip that shows it
    const R leap = select(held().is_open(p), max(R(0.25) * (begin - get(kOpen, p)), least), w + w);
    rays_.set(kW, p, select(gone, leap, select(divide, next, w)));
  }
  // Into the near half, or to the next part and up while both halves are done.
  ISO_HD void follow_path(int p, Mask<R> divide, Mask<R> leave) {
    R k = get(kK, p), w = get(kW, p);
    w = select(divide, R(0.5) * w, w);
    k = select(leave, k + w, k);
    R number = k / w;
    for (;;) {
      const R half = R(0.5) * number;
      const Mask<R> both = leave & (w < R(1)) & (half == floor(half));
      if (!any(both)) break;
      w = select(both, w + w, w);
      number = select(both, half, number);
    }
    rays_.set(kK, p, k), rays_.set(kW, p, w);
  }

  const FormulaQuery<T>& query_;
  const SegmentStream<T>& stream_;
  SegmentRoots<T>& roots_;
  RayRange range_;
  void* registers_;
  int next_ = 0;
  bool together_ = false;
  Rays<R> rays_;
};

}  // namespace isocast::inline ISO_ISA
