// The truth about one cell and one chord: every root of the cubic along it, from exact arithmetic.
#pragma once

#include <isocast/volume/cell/packet.h>

#include <optional>
#include <span>
#include <vector>

namespace isocast::reference {

/// One cell and one chord of it, every number taken as it stands (packet.h describes the members). All are
/// finite.
struct CellChord {
  double f[8];
  double entry[3], exit[3];
};

/// One lane of a packet.
template <class T> [[nodiscard]] CellChord chord_of(const CellPacket<T>& packet, int lane) {
  CellChord chord;
  for (int i = 0; i < 8; ++i) chord.f[i] = packet.f[i][lane];
  for (int i = 0; i < 3; ++i) {
    chord.entry[i] = packet.entry[i][lane];
    chord.exit[i] = packet.exit[i][lane];
  }
  return chord;
}

/// s                within 2^-60, from 0 at entry to 1 at exit
/// crossing         f < 0 on one side and f >= 0 on the other; the ends are sides of their own, with f = 0
///                  there: a root at entry is a crossing if f < 0 behind it, a root at exit if f < 0 before
///                  it. A touch inside the chord is none, from either side
/// negative_behind  f < 0 behind the root
struct CellRoot {
  long double s;
  int multiplicity;
  bool crossing, negative_behind;
};

/// f, correctly rounded or one step beside, where rounding of any kind may change the answer.
struct CriticalPoint {
  double s, value;
};

/// zero         f vanishes on the whole chord; no root is listed, none is a crossing
/// critical     entry, the extrema between, exit, in order of s
/// coefficients of f in Bernstein form, rounded
struct CellReference {
  bool zero;
  int root_count, critical_count;
  CellRoot roots[3];
  CriticalPoint critical[4];
  double coefficients[4];
};

[[nodiscard]] CellReference solve(const CellChord& chord);
/// On all cores; stops at Ctrl-C.
[[nodiscard]] std::vector<CellReference> solve(std::span<const CellChord> chords);

/// The first crossing in (begin, 1], in [0, 1] for begin = 0.
[[nodiscard]] std::optional<CellRoot> first_crossing(const CellReference& reference, double begin = 0);

/// f at s, correctly rounded or one step beside.
[[nodiscard]] double exact_value(const CellChord& chord, double s);

}  // namespace isocast::reference
