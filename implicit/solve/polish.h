// The best guess at roots that are isolated already.
#pragma once

#include <isocast/implicit/solve/inclusion.h>
#include <isocast/implicit/solve/segment.h>
#include <isocast/implicit/solve/slots.h>

namespace isocast::inline ISO_ISA {

/// Newton's steps in plain arithmetic from `s` of every proved hit, kept between s_lo and s_hi: each doubles
/// the digits, from the few that isolation leaves to those of T. Proves nothing and changes no proof.
template <Real R> class Polish {
  using T = Scalar<R>;
  using G = Gradient<R>;
  static constexpr int kPacks = kSlots / kWidth<R>, kSteps = sizeof(T) == 4 ? 2 : 3;

 public:
  static constexpr std::size_t kRegisterBytes = kPacks * sizeof(G);

  ISO_HD Polish(const FormulaQuery<T>& query, const SegmentStream<T>& stream, SegmentRoots<T>& roots,
                void* registers)
      : query_(query), stream_(stream), roots_(roots), registers_(registers) {}

  ISO_HD void run() {
    int rays[kSlots], count = 0;
    for (int i = 0; i < stream_.size; ++i) {
      if (stream_.active[i] && roots_.hit[i] && roots_.proved[i]) rays[count++] = i;
      if (count < kSlots && (i + 1 < stream_.size || count == 0)) continue;
      polish(rays, count);
      count = 0;
    }
  }

 private:
  ISO_HD void polish(const int* rays, int count) {
    // rays as lanes; the last pack is filled up with the last ray
    alignas(64) T e[3][kSlots], d[3][kSlots], s[kSlots], lo[kSlots], hi[kSlots], iso[kSlots];
    const int packs = (count + kWidth<R> - 1) / kWidth<R>;
    for (int l = 0; l < packs * kWidth<R>; ++l) {
      const int i = rays[l < count ? l : count - 1];
      for (int a = 0; a < 3; ++a) e[a][l] = stream_.e[a][i], d[a][l] = stream_.d[a][i];
      s[l] = roots_.s[i], lo[l] = roots_.s_lo[i], hi[l] = roots_.s_hi[i];
      iso[l] = query_.iso_lo[roots_.iso[i]];
    }
    for (int step = 0; step < kSteps; ++step) {
      G inputs[4 * kPacks];
      for (int p = 0; p < packs; ++p) {
        const R at = load<R>(s + p * kWidth<R>);
        const RayPart<R> point(at, at);
        for (int a = 0; a < 3; ++a)
          point.coordinate(load<R>(e[a] + p * kWidth<R>), load<R>(d[a] + p * kWidth<R>), R(0), a,
                           inputs[a * kPacks + p]);
        inputs[3 * kPacks + p] = G(R(static_cast<T>(query_.time)));
      }
      const G* const g = evaluate_some<kPacks>(query_.tape, static_cast<const G*>(inputs),
                                               static_cast<G*>(registers_), packs);
      for (int p = 0; p < packs; ++p) {
        const int l = p * kWidth<R>;
        const R slope =
            g[p].dx * load<R>(d[0] + l) + g[p].dy * load<R>(d[1] + l) + g[p].dz * load<R>(d[2] + l);
        const R before = load<R>(s + l), next = before - (g[p].value - load<R>(iso + l)) / slope;
        const R inside = min(max(next, load<R>(lo + l)), load<R>(hi + l));
        store(s + l, select(next == next, inside, before));
      }
    }
    for (int l = 0; l < count; ++l) roots_.s[rays[l]] = s[l];
  }

  const FormulaQuery<T>& query_;
  const SegmentStream<T>& stream_;
  SegmentRoots<T>& roots_;
  void* registers_;
};

}  // namespace isocast::inline ISO_ISA
