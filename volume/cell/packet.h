// Sixteen rays in sixteen cells (or one in one), and what was found: the plain data that cell kernels read
// and write.
#pragma once

#include <isocast/ray/stream.h>

namespace isocast {

/// Packets are aligned for registers; one lane is numbers.
template <class T, int N> inline constexpr std::size_t kPacketAlignment = N == 1 ? alignof(T) : 64;

/// One cell and one chord of it a lane, in structure of arrays.
///
/// f       corner values minus iso, x fastest: [z][y][x]; finite (a cell with a NaN or infinite corner is no
/// cell) entry   where the ray enters, cell space [0,1]^3: the coordinate of the face it enters through is
/// exactly 0 or 1 exit    where it leaves; s in [0,1] runs from entry to exit begin   roots are sought in
/// (begin, 1]; 0 for the whole chord carry   +0 or -0 to carry a known sign of f at `begin`, NaN to evaluate
/// it slack   of methods that prove: entry and exit may truly lie so far from where they are, per axis
/// active  bit l set: lane l holds a cell
template <class T, int N = kPacketSize> struct alignas(kPacketAlignment<T, N>) CellPacket {
  T f[8][N];
  T entry[3][N], exit[3][N];
  T begin[N], carry[N], slack[N];
  std::uint32_t active;
};

/// s          first root; the bracket s_lo <= s <= s_hi holds it as far as the method can say
/// hit        bit l set: lane l has a root (else its numbers hold no meaning)
/// proved     all lanes of which it is: there is no root, or none before s_lo and one between s_lo and s_hi
/// undecided  of these, roots without a change of sign (touch=1)
/// sign       bit l set: f is negative behind the root
template <class T, int N = kPacketSize> struct alignas(kPacketAlignment<T, N>) RootPacket {
  T s[N], s_lo[N], s_hi[N];
  std::uint32_t hit, undecided, sign, proved;
};

}  // namespace isocast
