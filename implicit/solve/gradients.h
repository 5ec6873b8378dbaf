// A formula and its gradient at many points.
#pragma once

#include <isocast/implicit/solve/inclusion.h>
#include <isocast/implicit/solve/kernels.h>
#include <isocast/implicit/solve/slots.h>

namespace isocast::inline ISO_ISA {

/// Points that are worked on at once; a register of the tape holds so many Gradient<R>.
template <Real R> inline constexpr int kGradientPacks = kSlots / kWidth<R>;

/// Fills value, gradient and normal of `points`.
template <Real R>
ISO_HD inline void find_gradients(const TapeView& tape, double time, GradientStream& points,
                                  void* registers) {
  using F = Gradient<R>;
  constexpr int kPacks = kGradientPacks<R>;
  for (int first = 0; first < points.size; first += kSlots) {
    const int left = points.size - first, lanes = left < kSlots ? left : kSlots,
              packs = (lanes + kWidth<R> - 1) / kWidth<R>;
    F inputs[4 * kPacks];
    for (int p = 0; p < packs; ++p) {
      const int at = first + p * kWidth<R>;
      for (int a = 0; a < 3; ++a)
        inputs[a * kPacks + p] = F(load<R>(points.position[a] + at), R(a == 0), R(a == 1), R(a == 2));
      inputs[3 * kPacks + p] = constant_as({time, true}, F{});
    }
    const F* const f =
        evaluate_some<kPacks>(tape, static_cast<const F*>(inputs), static_cast<F*>(registers), packs);
    for (int p = 0; p < packs; ++p) {
      const int at = first + p * kWidth<R>;
      store(points.value + at, f[p].value);
      const R g[3] = {f[p].dx, f[p].dy, f[p].dz}, size = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
      for (int a = 0; a < 3; ++a) {
        store(points.gradient[a] + at, g[a]);
        store(points.normal[a] + at, select(size > R(0), g[a] / size, g[a]));
      }
    }
  }
}

}  // namespace isocast::inline ISO_ISA
