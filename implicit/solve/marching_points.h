// The first root along each ray of a stream by marching points: steps whose length follows |f| and |df/dt|.
#pragma once

#include <isocast/implicit/solve/hit_lanes.h>

namespace isocast::inline ISO_ISA {

/// Adaptive marching points: in plain arithmetic, proving nothing.
///
/// step    of the base step: a quarter where |f| <= tau[0] and |df/dt| <= tau[2] (near a silhouette), half
/// where
///         |f| <= tau[0], double where |f| > tau[1]; then `halvings` bisections of the step that holds a root
/// sign    a step holds a root if f has different signs at its ends: misses an even number of roots
/// Taylor  if zero lies in the hull of f and its first-order expansions from both ends to the middle: finds
///         most touching roots, and can invent some. From a start on the surface the first step is judged by
///         signs
/// NaN     is of neither side: a step from or to one holds no root
/// source  Singh, Narayanan: Real-time ray tracing of implicit surfaces on the GPU, IEEE Transactions on
///         Visualization and Computer Graphics 16(2), 2010
template <bool kTaylor, Real R> class MarchingPoints {
  using T = Scalar<R>;
  using G = Gradient<R>;
  static constexpr int kPacks = Slots<R>::kPacks;
  struct Sample {
    R f, slope;  // slope: df/dt, t a world length
  };

 public:
  static constexpr std::size_t kRegisterBytes = kPacks * sizeof(G);

  ISO_HD MarchingPoints(const FormulaQuery<T>& query, const SegmentStream<T>& stream, SegmentRoots<T>& roots,
                        RayRange range, void* registers)
      : query_(query),
        stream_(stream),
        roots_(roots),
        range_(range),
        registers_(registers),
        next_(range.first) {}

  ISO_HD void run() {
    for (refill(); slots_.busy != 0; refill()) round();
    HitLanes<R>::each(
        query_, stream_, roots_, range_, [](int) { return true; },
        [this](HitLanes<R>& hits) { halve(hits); });
  }

 private:
  ISO_HD R get(Field field, int p) const { return slots_.get(field, p); }

  ISO_HD void refill() {
    for (int slot = 0; slot < kSlots && next_ < range_.last; ++slot)
      while (!(slots_.busy >> slot & 1) && next_ < range_.last) {
        const int i = next_++;
        if (!stream_.active[i]) continue;
        slots_.start(stream_, i, slot, isos_in(query_));
        slots_.field[kW][slot] = T(0);
        roots_.hit[i] = false;
        roots_.proved[i] = false;
      }
    slots_.close_ranks(isos_in(query_));
  }

  // One step of every ray in work; the first one has no length and only looks.
  ISO_HD void round() {
    int packs[kPacks];
    const int count = slots_.packs_in_work(packs);
    R at[kPacks];
    Sample samples[kPacks];
    for (int n = 0; n < count; ++n) at[n] = min(get(kBegin, packs[n]) + get(kW, packs[n]), R(1));
    sample(packs, at, count, samples);
    for (int n = 0; n < count; ++n) step(packs[n], at[n], samples[n]);
  }

  // f and its slope at points of the rays.
  ISO_HD void sample(const int* packs, const R* at, int count, Sample* samples) {
    bool slopes = kTaylor;
    if constexpr (!kTaylor) {
      const R* const f = evaluate_at<R>(packs, at, count);
      for (int n = 0; n < count; ++n) {
        samples[n] = {f[n], R(0)};
        slopes = slopes ||
                 any(lanes_of<R>(slots_.busy, packs[n]) & (distance(f[n]) <= R(T(query_.options.tau[0]))));
      }
    }
    if (!slopes) return;
    const G* const g = evaluate_at<G>(packs, at, count);
    for (int n = 0; n < count; ++n) {
      const int p = packs[n];
      const R along = g[n].dx * get(kDx, p) + g[n].dy * get(kDy, p) + g[n].dz * get(kDz, p);
      samples[n] = {g[n].value, along * get(kSmallestPart, p) * R(T(1 / query_.options.step))};
    }
  }
  template <class Kind> ISO_HD const Kind* evaluate_at(const int* packs, const R* at, int count) {
    Kind inputs[4 * kPacks];
    for (int n = 0; n < count; ++n) {
      const auto row = [this, p = packs[n]](Field first) {
        return [this, p, first](int a) { return get(Field(first + a), p); };
      };
      RayPart<R>(at[n], at[n]).template put<kPacks>(inputs, n, query_.time, row(kEx), row(kDx), [](int) {
        return R(0);
      });
      slots_.add(kRuns, packs[n], lanes_of<R>(slots_.busy, packs[n]), 1);
    }
    return evaluate_some<kPacks>(query_.tape, static_cast<const Kind*>(inputs),
                                 static_cast<Kind*>(registers_), count);
  }
  // |f - iso| for the nearest iso-value.
  ISO_HD R distance(R f) const {
    R least = abs(f - R(query_.iso_lo[0]));
    for (int i = 1; i < isos_in(query_); ++i) least = min(abs(f - R(query_.iso_lo[i])), least);
    return least;
  }

  // Looks for a root between where the ray is and `at`, and goes there.
  ISO_HD void step(int p, R at, const Sample& there) {
    const Mask<R> busy = lanes_of<R>(slots_.busy, p), first = get(kW, p) == R(0);
    const R from = get(kBegin, p);
    const Sample here = {get(kValue, p), get(kSlope, p)};
    const Mask<R> number = (here.f == here.f) & (there.f == there.f);
    // a start on the surface has the side that it was given
    const Mask<R> at_start = lanes_of<R>(slots_.carried, p) & (from == get(kStart, p));
    const R half = R(0.5) * (at - from) / get(kSmallestPart, p) * R(T(query_.options.step));
    Mask<R> found = Mask<R>(false);
    R level = R(0), nearest = R(0);
    for (int i = 0; i < isos_in(query_); ++i) {
      const R iso = R(query_.iso_lo[i]);
      const Mask<R> changes = lanes_of<R>(slots_.below[i], p) != (there.f < iso);
      const Mask<R> taylor = kTaylor ? touches(here, there, half, iso) & !at_start : Mask<R>(false);
      const Mask<R> root = busy & (!first) & number & (changes | taylor);
      const Mask<R> nearer = root & ((!found) | (abs(iso - here.f) < nearest));
      level = select(nearer, R(T(i)), level);
      nearest = select(nearer, abs(iso - here.f), nearest);
      found = found | root;
    }
    if (any(found)) report(p, found, from, at, level);
    for (int i = 0; i < isos_in(query_); ++i) {
      const Mask<R> keep = first & lanes_of<R>(slots_.known, p), mine = lanes_of<R>(slots_.below[i], p);
      put_lanes<R>(slots_.below[i], p, select(keep, mine, there.f < R(query_.iso_lo[i])));
    }
    const Mask<R> done = busy & (found | (at >= R(1)));
    slots_.set(kBegin, p, at), slots_.set(kValue, p, there.f), slots_.set(kSlope, p, there.slope);
    slots_.set(kW, p, length_from(there) * get(kSmallestPart, p));
    slots_.for_lanes(p, done, [&](int l, int ray) {
      roots_.evaluations[ray] = static_cast<std::uint32_t>(slots_.field[kRuns][p * kWidth<R> + l]);
    });
    put_lanes<R>(slots_.busy, p, busy & !done);
  }
  // In base steps.
  ISO_HD R length_from(const Sample& s) const {
    const R f = distance(s.f), slope = abs(s.slope);
    const auto& tau = query_.options.tau;
    const Mask<R> near = f <= R(T(tau[0]));
    return select(near & (slope <= R(T(tau[2]))), R(T(0.25)),
                  select(near, R(T(0.5)), select(f > R(T(tau[1])), R(T(2)), R(T(1)))));
  }
  ISO_HD static Mask<R> touches(const Sample& a, const Sample& b, R half, R iso) {
    const R p = a.f - iso, q = p + a.slope * half, s = b.f - iso, r = s - b.slope * half;
    return (min(min(p, q), min(r, s)) <= R(0)) & (max(max(p, q), max(r, s)) >= R(0));
  }

  // The step of some lanes as a bracket, with the sides in front of it.
  ISO_HD void report(int p, Mask<R> lanes, R from, R to, R level) {
    T lo[kWidth<R>], hi[kWidth<R>], iso[kWidth<R>];
    store(lo, from), store(hi, to), store(iso, level);
    slots_.for_lanes(p, lanes, [&](int l, int ray) {
      std::uint32_t sides = 0;
      for (int i = 0; i < isos_in(query_); ++i) sides |= (slots_.below[i] >> (p * kWidth<R> + l) & 1) << i;
      roots_.hit[ray] = true;
      roots_.s_lo[ray] = roots_.s[ray] = lo[l];
      roots_.s_hi[ray] = hi[l];
      roots_.iso[ray] = static_cast<std::uint8_t>(iso[l]);
      roots_.sides[ray] = sides;
    });
  }

  // Bisects brackets, keeping the half that holds a root by the test of the march, and leaves its middle.
  ISO_HD void halve(HitLanes<R>& hits) {
    Sample ends[2][kPacks], middle[kPacks];
    const auto sample_hits = [&](Sample* out) {
      if constexpr (kTaylor) {
        const G* const g = hits.template evaluate<G>(query_, registers_);
        for (int p = 0; p < hits.packs(); ++p)
          out[p] = {g[p].value, g[p].dx * hits.d[0][p] + g[p].dy * hits.d[1][p] + g[p].dz * hits.d[2][p]};
      } else {
        const R* const f = hits.template evaluate<R>(query_, registers_);
        for (int p = 0; p < hits.packs(); ++p) out[p] = {f[p], R(0)};
      }
    };
    for (int p = 0; p < hits.packs(); ++p) hits.s[p] = hits.lo[p];
    sample_hits(ends[0]);
    for (int p = 0; p < hits.packs(); ++p) hits.s[p] = hits.hi[p];
    sample_hits(ends[1]);
    for (int n = 0;; ++n) {
      for (int p = 0; p < hits.packs(); ++p) hits.s[p] = R(0.5) * (hits.lo[p] + hits.hi[p]);
      if (n >= query_.options.halvings) break;
      sample_hits(middle);
      for (int p = 0; p < hits.packs(); ++p) {
        // the far end alone tells the side in front of a start on the surface: it lies behind the root
        const Mask<R> below_far = ends[1][p].f < hits.iso[p], below = middle[p].f < hits.iso[p];
        const Mask<R> crosses = kTaylor ? (ends[0][p].f < hits.iso[p]) != below_far : Mask<R>(true);
        const Mask<R> touching =
            kTaylor ? touches(ends[0][p], middle[p], R(0.5) * (hits.s[p] - hits.lo[p]), hits.iso[p])
                    : Mask<R>(false);
        const Mask<R> left = select(crosses, below == below_far, touching);
        hits.hi[p] = select(left, hits.s[p], hits.hi[p]);
        hits.lo[p] = select(left, hits.lo[p], hits.s[p]);
        for (int end = 0; end < 2; ++end) {
          const Mask<R> mine = end == 1 ? left : !left;
          ends[end][p] = {select(mine, middle[p].f, ends[end][p].f),
                          select(mine, middle[p].slope, ends[end][p].slope)};
        }
      }
    }
  }

  const FormulaQuery<T>& query_;
  const SegmentStream<T>& stream_;
  SegmentRoots<T>& roots_;
  RayRange range_;
  void* registers_;
  int next_;
  Slots<R> slots_;
};

}  // namespace isocast::inline ISO_ISA
