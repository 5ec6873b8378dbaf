// Whether two answers have the same bits.
#pragma once

#include <isocast/ray/hit.h>

#include <cstring>

namespace isocast::test {

template <class T> bool same(const T& a, const T& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// The first slot whose answers differ, or -1. Slots without a hit have a certificate only.
inline int first_difference(const HitStream& a, const HitStream& b) {
  for (int i = 0; i < kStreamSize; ++i) {
    if (is_hit(a, i) != is_hit(b, i) || a.certificate[i] != b.certificate[i]) return i;
    if (a.object[i] != b.object[i]) return i;
    if (!is_hit(a, i) || a.object[i] != 0) continue;
    const bool equal = same(a.t[i], b.t[i]) && same(a.t_lo[i], b.t_lo[i]) && same(a.t_hi[i], b.t_hi[i]) &&
                       same(a.s[i], b.s[i]) && same(a.s_hi[i], b.s_hi[i]) && a.cell[0][i] == b.cell[0][i] &&
                       a.cell[1][i] == b.cell[1][i] && a.cell[2][i] == b.cell[2][i] &&
                       a.sides[i] == b.sides[i] && a.iso[i] == b.iso[i];
    if (!equal) return i;
  }
  return -1;
}

}  // namespace isocast::test
