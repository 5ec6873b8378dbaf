// Loops over lanes, and choices by a small number, that leave no index behind where a GPU keeps things in
// registers.
#pragma once

#include <isocast/math/bits.h>

namespace isocast::inline ISO_ISA {

/// call(l) for each lane whose bit is set, lowest first. N lanes: one lane is no loop and no index.
template <int N, class Call> ISO_HD inline void for_lanes(std::uint32_t lanes, Call call) {
  if constexpr (N == 1) {
    if (lanes & 1) call(0);
  } else {
    for (std::uint32_t rest = lanes; rest; rest &= rest - 1) call(lowest_bit(rest));
  }
}

/// A number that the compiler knows.
template <int K> struct Index {
  ISO_HD constexpr operator int() const { return K; }
};
/// call(Index<i>) for 0 <= i < N: what it then takes from arrays has a fixed place.
template <int N, int K = 0, class Call> ISO_HD constexpr auto at_index(int i, Call call) {
  if constexpr (K + 1 < N)
    if (i != K) return at_index<N, K + 1>(i, call);
  return call(Index<K>{});
}

/// call(Index<0>) ... call(Index<N - 1>).
template <int N, int K = 0, class Call> ISO_HD constexpr void each_index(Call call) {
  call(Index<K>{});
  if constexpr (K + 1 < N) each_index<N, K + 1>(call);
}

}  // namespace isocast::inline ISO_ISA
