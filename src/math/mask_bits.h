// Masks from bits.
#pragma once

#include <isocast/math/native.h>

namespace isocast::inline ISO_ISA {

/// The lanes whose bits are set, lane 0 by the lowest: bits_of's inverse. Other bits do not matter.
template <Real R> ISO_HD inline Mask<R> lanes_of(unsigned bits) {
  using M = Mask<R>;
  if constexpr (kWidth<R> == 1) return (bits & 1) != 0;
  else if constexpr (sizeof(M) < kWidth<R> * sizeof(Scalar<R>)) return M(typename M::Bits(bits));
  else {
    using Bits = typename M::Bits;
    Bits lane;
    for (int l = 0; l < kWidth<R>; ++l) lane[l] = 1 << l;
    return Bits(((Bits{} + typename M::Int(bits)) & lane) != 0);
  }
}

}  // namespace isocast::inline ISO_ISA
