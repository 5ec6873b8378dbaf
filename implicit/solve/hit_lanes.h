// Hits of a stream side by side, to work on their brackets.
#pragma once

#include <isocast/implicit/solve/inclusion.h>
#include <isocast/implicit/solve/segment.h>
#include <isocast/implicit/solve/slots.h>

namespace isocast::inline ISO_ISA {

/// Up to kSlots rays as lanes; the last pack is filled up with the last ray.
template <Real R> struct HitLanes {
  using T = Scalar<R>;
  static constexpr int kPacks = kSlots / kWidth<R>;

  int rays[kSlots], count = 0;
  R e[3][kPacks], d[3][kPacks], s[kPacks], lo[kPacks], hi[kPacks], iso[kPacks];

  ISO_HD int packs() const { return Slots<R>::some_packs((count + kWidth<R> - 1) / kWidth<R>); }

  /// Takes those of the hits in a range that are wanted, kSlots at a time, and calls work(lanes), which may
  /// change s, lo and hi.
  template <class Wanted, class Work>
  ISO_HD static void each(const FormulaQuery<T>& query, const SegmentStream<T>& stream,
                          SegmentRoots<T>& roots, RayRange range, Wanted wanted, Work work) {
    HitLanes lanes;
    const auto work_on = [&](int count) {
      lanes.count = count;
      lanes.gather(query, stream, roots);
      work(lanes);
      lanes.scatter(roots);
    };
    const auto is_wanted = [&](int i) { return stream.active[i] && roots.hit[i] && wanted(i); };
    if constexpr (kSlots == 1) {
      lanes.rays[0] = range.first;
      if (is_wanted(range.first)) work_on(1);
      return;
    }
    int count = 0;
    for (int i = range.first; i < range.last; ++i) {
      if (is_wanted(i)) lanes.rays[count++] = i;
      if (count == 0 || (count < kSlots && i + 1 < range.last)) continue;
      work_on(count);
      count = 0;
    }
  }

  /// The tape at the points s of all lanes.
  template <class Kind> ISO_HD const Kind* evaluate(const FormulaQuery<T>& query, void* registers) const {
    Kind inputs[4 * kPacks];
    for (int p = 0; p < packs(); ++p) {
      RayPart<R>(s[p], s[p])
          .template put<kPacks>(
              inputs, p, query.time, [&](int a) { return e[a][p]; }, [&](int a) { return d[a][p]; },
              [](int) { return R(0); });
    }
    return evaluate_some<kPacks>(query.tape, static_cast<const Kind*>(inputs), static_cast<Kind*>(registers),
                                 packs());
  }

 private:
  ISO_HD void gather(const FormulaQuery<T>& query, const SegmentStream<T>& stream,
                     const SegmentRoots<T>& roots) {
    const auto fill = [this](R* out, auto value_of) {
      T values[kSlots];
      for (int l = 0; l < packs() * kWidth<R>; ++l) values[l] = value_of(rays[l < count ? l : count - 1]);
      for (int p = 0; p < packs(); ++p) out[p] = load<R>(values + p * kWidth<R>);
    };
    for (int a = 0; a < 3; ++a) {
      fill(e[a], [&](int i) { return stream.e[a][i]; });
      fill(d[a], [&](int i) { return stream.d[a][i]; });
    }
    fill(s, [&](int i) { return roots.s[i]; });
    fill(lo, [&](int i) { return roots.s_lo[i]; });
    fill(hi, [&](int i) { return roots.s_hi[i]; });
    fill(iso, [&](int i) { return query.iso_lo[roots.iso[i]]; });
  }
  ISO_HD void scatter(SegmentRoots<T>& roots) const {
    for (int l = 0; l < count; ++l) {
      T values[3][kWidth<R>];
      store(values[0], s[l / kWidth<R>]), store(values[1], lo[l / kWidth<R>]),
          store(values[2], hi[l / kWidth<R>]);
      roots.s[rays[l]] = values[0][l % kWidth<R>];
      roots.s_lo[rays[l]] = values[1][l % kWidth<R>];
      roots.s_hi[rays[l]] = values[2][l % kWidth<R>];
    }
  }
};

}  // namespace isocast::inline ISO_ISA
