// Lanes of a register by number.
#pragma once

#include <isocast/math/pack.h>

namespace isocast::inline ISO_ISA {

/// The lanes of a mask from their bits.
template <Real R> inline Mask<R> mask_of_bits(unsigned bits) {
  if constexpr (kWidth<R> == 1) return (bits & 1) != 0;
  else {
    double lanes[kWidth<R>];
    for (int l = 0; l < kWidth<R>; ++l) lanes[l] = double(bits >> l & 1);
    return load<R>(lanes) != R(0);
  }
}
#ifdef __AVX512DQ__
template <> inline Mask<Pack<double, 8>> mask_of_bits<Pack<double, 8>>(unsigned bits) {
  return PackMask<double, 8>(__mmask8(bits));
}
#endif

}  // namespace isocast::inline ISO_ISA
