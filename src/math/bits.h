// Places and numbers of bits in a word.
#pragma once

#include <isocast/isa/isa.h>
#include <isocast/isa/std.h>

namespace isocast::inline ISO_ISA {

#ifdef __CUDA_ARCH__
/// Of a word that is not 0, counted from the lowest bit.
__device__ inline int lowest_bit(std::uint64_t word) { return __ffsll(static_cast<long long>(word)) - 1; }
__device__ inline int highest_bit(std::uint64_t word) { return 63 - __clzll(static_cast<long long>(word)); }
__device__ inline int count_bits(std::uint32_t word) { return __popc(word); }
#else
ISO_HD inline int lowest_bit(std::uint64_t word) { return __builtin_ctzll(word); }
ISO_HD inline int highest_bit(std::uint64_t word) { return 63 - __builtin_clzll(word); }
ISO_HD inline int count_bits(std::uint32_t word) { return __builtin_popcount(word); }
#endif

}  // namespace isocast::inline ISO_ISA
