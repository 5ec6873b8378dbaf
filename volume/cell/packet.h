// Sixteen rays in sixteen cells, and what was found: the plain data that cell kernels read and write.
#pragma once

#include <isocast/ray/stream.h>

namespace isocast {

/// One cell and one chord of it a lane, in structure of arrays.
///
/// f       corner values minus iso, x fastest: [z][y][x]; finite (a cell with a NaN or infinite corner is no
/// cell) entry   where the ray enters, cell space [0,1]^3: the coordinate of the face it enters through is
/// exactly 0 or 1 exit    where it leaves; s in [0,1] runs from entry to exit begin   roots are sought in
/// (begin, 1]; 0 for the whole chord carry   +0 or -0 to carry a known sign of f at `begin`, NaN to evaluate
/// it slack   of methods that prove: entry and exit may truly lie so far from where they are, per axis
/// active  bit l set: lane l holds a cell
template <class T> struct alignas(64) CellPacket {
  T f[8][kPacketSize];
  T entry[3][kPacketSize], exit[3][kPacketSize];
  T begin[kPacketSize], carry[kPacketSize], slack[kPacketSize];
  std::uint32_t active;
};

/// s          first root; the bracket s_lo <= s <= s_hi holds it as far as the method can say
/// hit        bit l set: lane l has a root (else its numbers hold no meaning)
/// proved     all lanes of which it is: there is no root, or none before s_lo and one between s_lo and s_hi
/// undecided  of these, roots without a change of sign (touch=1)
/// sign       bit l set: f is negative behind the root
template <class T> struct alignas(64) RootPacket {
  T s[kPacketSize], s_lo[kPacketSize], s_hi[kPacketSize];
  std::uint32_t hit, undecided, sign, proved;
};

}  // namespace isocast
