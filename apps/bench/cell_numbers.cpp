#include <isocast/apps/bench/cell_chords.h>
#include <isocast/apps/bench/cell_numbers.h>
#include <isocast/apps/bench/random.h>

#include <bit>
#include <cmath>

namespace isocast::bench {
namespace {

void uniform_corners(Random& random, double scale, CellChord& chord) {
  for (double& f : chord.f) f = scale * random.uniform(-1, 1);
}

}  // namespace

void plateau(Random& random, std::uint64_t, CellChord& chord) {
  if (random.below(2)) face_chord(random, chord);
  else random_chord(random, chord);
  // a face at the iso-value, the rest at it, below or above
  for (double& f : chord.f) f = random.below(3) - 1;
  const int axis = random.below(3), side = random.below(2);
  for (int i = 0; i < 8; ++i)
    if ((i >> axis & 1) == side) chord.f[i] = 0;
}

void checkerboard(Random& random, std::uint64_t, CellChord& chord) {
  random_chord(random, chord);
  for (unsigned i = 0; i < 8; ++i)
    chord.f[i] = (std::popcount(i) % 2 ? 1 : -1) * std::exp2(random.uniform(-10, 10));
}

void denormal(Random& random, std::uint64_t, CellChord& chord) {
  random_chord(random, chord);
  const double smallest = random.below(4) ? 0x1p-149 : 0x1p-1074;
  for (double& f : chord.f) f = smallest * (random.below(33) - 16);
}

void scaled(Random& random, std::uint64_t, CellChord& chord) {
  random_chord(random, chord);
  uniform_corners(random, std::pow(10, random.uniform(-30, 30)), chord);
}

void steps(Random& random, std::uint64_t, CellChord& chord) {
  random_chord(random, chord);
  const int least = random.below(4) - 2;
  for (double& f : chord.f) f = least + random.below(3);
}

void axis_aligned(Random& random, std::uint64_t, CellChord& chord) {
  axis_chord(random, chord);
  uniform_corners(random, 1, chord);
}

void in_face(Random& random, std::uint64_t, CellChord& chord) {
  face_chord(random, chord);
  uniform_corners(random, 1, chord);
}

}  // namespace isocast::bench
