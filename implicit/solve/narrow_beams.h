// Beams are cut to where f may be an iso-value for any of their rays, or crosses one on all of them.
#pragma once

#include <isocast/implicit/solve/beam.h>
#include <isocast/implicit/solve/levels.h>
#include <isocast/implicit/solve/slots.h>

namespace isocast::inline ISO_ISA {

/// One slab of a beam, from k0 to k1, axis by axis: the inputs of the tape.
template <Real R> struct BeamPart {
  R middle, half, k1;
  ISO_HD BeamPart(R from, R to) : middle(R(0.5) * (from + to)), half(R(0.5) * (to - from)), k1(to) {}

  /// Coefficients of 1 and k, of the middle ray and of u and v.
  struct Axis {
    R e, d, eu, du, ev, dv, slack, spread;
  };

  /// The symbols are k, u and v; their products are bounded.
  ISO_HD void coordinate(const Axis& x, AffineForm<R, 3>& y) const {
    const Mask<R> yes = Mask<R>(true);
    y.c = x.e + middle * x.d;
    y.e[0] = half * x.d;
    y.e[1] = x.eu + middle * x.du;
    y.e[2] = x.ev + middle * x.dv;
    y.r = raised(x.slack + max(k1, R(0)) * x.spread + half * (abs(x.du) + abs(x.dv)));
    y.defined = y.continuous = yes;
    y.empty = !yes;
  }
  ISO_HD void coordinate(const Axis& x, Interval<R>& y) const {
    AffineForm<R, 3> form;
    coordinate(x, form);
    y = interval_of(form);
  }
};

/// What an inclusion over a slab says of its beam: an affine form's plane of crossings, else nothing.
template <Real R> struct BeamLevels {
  Levels<R> levels;
  R at = R(0), along_u = R(0), along_v = R(0), radius = R(0);
};
template <Real R>
ISO_HD inline BeamLevels<R> find_beam_levels(const Interval<R>& f, R lo, R hi,
                                             const FormulaQuery<Scalar<R>>& query) {
  return {find_levels(f, lo, hi, query)};
}
template <Real R>
ISO_HD inline BeamLevels<R> find_beam_levels(const AffineForm<R, 3>& f, R lo, R hi,
                                             const FormulaQuery<Scalar<R>>& query) {
  using T = Scalar<R>;
  AffineForm<R, 1> along;
  const R across = abs(f.e[1]) + abs(f.e[2]);
  along.c = f.c, along.e[0] = f.e[0], along.r = with_roundings(f.r + across, across + f.r, 2);
  along.defined = f.defined, along.continuous = f.continuous, along.empty = f.empty;
  BeamLevels<R> y{find_levels(along, lo, hi, query)};
  R low = R(query.iso_lo[0]), high = R(query.iso_hi[0]);
  for (int i = 1; i < isos_in(query); ++i) {
    const Mask<R> mine = y.levels.iso == R(T(i));
    low = select(mine, R(query.iso_lo[i]), low), high = select(mine, R(query.iso_hi[i]), high);
  }
  const R half = R(0.5) * (hi - lo), per_k = half / f.e[0], c = low - f.c;
  y.at = (lo + half) + c * per_k;
  y.along_u = -(f.e[1] * per_k);
  y.along_v = -(f.e[2] * per_k);
  const R size = (abs(f.c) + abs(low) + across) * abs(per_k) + abs(lo) + abs(hi);
  y.radius = with_roundings(raised((f.r + (high - low)) * abs(per_k)), size, 8);
  return y;
}

/// Looks at the slabs of all beams at once. What the inclusions, and their trimming, prove empty at both ends
/// is cut off.
///
/// F          Interval<R>, which finds no crossings, or AffineForm<R, 3>
/// registers  room for Slots<R>::kPacks of F a register
/// source     Ganacim, de Figueiredo, Nehab: Beam casting implicit surfaces on the GPU with interval
///            arithmetic, SIBGRAPI 2011, for the beams; that forms follow their slant is ours
template <class F, Real R>
ISO_HD inline void narrow_beams(const FormulaQuery<Scalar<R>>& query, BeamStream<Scalar<R>>& beams,
                                void* registers) {
  using T = Scalar<R>;
  constexpr int kPacks = Slots<R>::kPacks;
  const int slabs = beams.slabs, lanes = beams.count * slabs, packs = (lanes + kWidth<R> - 1) / kWidth<R>;
  int beam_of[kSlots];
  T lo[kSlots], hi[kSlots];
  for (int l = 0; l < packs * kWidth<R>; ++l) {
    const int b = beam_of[l] = (l < lanes ? l : lanes - 1) / slabs, slab = l % slabs;
    const T from = beams.from[b], to = beams.to[b], length = to - from, share = T(1) / T(slabs);
    lo[l] = slab == 0 ? from : from + length * (T(slab) * share);
    hi[l] = slab == slabs - 1 ? to : from + length * (T(slab + 1) * share);
  }
  F inputs[4 * kPacks];
  for (int p = 0; p < packs; ++p) {
    const int first = p * kWidth<R>;
    const auto spread_out = [&](const T(&of_beams)[kMostBeams]) {
      T values[kWidth<R>];
      for (int l = 0; l < kWidth<R>; ++l) values[l] = of_beams[beam_of[first + l]];
      return load<R>(values);
    };
    const BeamPart<R> part(load<R>(lo + first), load<R>(hi + first));
    for (int a = 0; a < 3; ++a)
      part.coordinate({spread_out(beams.e[a]), spread_out(beams.d[a]), spread_out(beams.eu[a]),
                       spread_out(beams.du[a]), spread_out(beams.ev[a]), spread_out(beams.dv[a]),
                       spread_out(beams.slack[a]), spread_out(beams.spread[a])},
                      inputs[a * kPacks + p]);
    inputs[3 * kPacks + p] = constant_as({query.time, true}, F{});
  }
  const F* const f =
      evaluate_some<kPacks>(query.tape, static_cast<const F*>(inputs), static_cast<F*>(registers), packs);
  T near[kSlots], far[kSlots], at[kSlots], along_u[kSlots], along_v[kSlots], radius[kSlots], iso[kSlots];
  SlotBits crosses = 0, rises = 0;
  for (int p = 0; p < packs; ++p) {
    const int first = p * kWidth<R>;
    const R k0 = load<R>(lo + first), k1 = load<R>(hi + first);
    const BeamLevels<R> found = find_beam_levels(f[p], k0, k1, query);
    const Mask<R> out = leaves_out(interval_of(f[p]), query) | (k0 > k1);
    store(near + first, select(out, R(2), found.levels.near));
    store(far + first, select(out, R(-1), found.levels.far));
    store(at + first, found.at), store(along_u + first, found.along_u);
    store(along_v + first, found.along_v), store(radius + first, found.radius);
    store(iso + first, found.levels.iso);
    put_lanes<R>(crosses, p, found.levels.alone());
    put_lanes<R>(rises, p, found.levels.rises);
  }
  beams.evaluations += lanes;
  for (int b = 0; b < beams.count; ++b) {
    T from = T(2), to = T(-1), run_to = T(-1);
    bool running = true;
    beams.crosses[b] = false;
    for (int l = b * slabs; l < (b + 1) * slabs; ++l) {
      if (!(near[l] <= far[l])) {
        running = from > to;
        continue;
      }
      if (from > to && (crosses >> l & 1)) {
        beams.crosses[b] = true;
        beams.rises[b] = rises >> l & 1;
        beams.iso[b] = static_cast<std::uint8_t>(iso[l]);
        beams.at[b] = at[l], beams.along_u[b] = along_u[l], beams.along_v[b] = along_v[l];
        beams.radius[b] = radius[l];
      }
      from = min(from, near[l]), to = max(to, far[l]);
      if (running) run_to = to;
    }
    beams.from[b] = from, beams.to[b] = to, beams.run_to[b] = run_to;
  }
}

}  // namespace isocast::inline ISO_ISA
