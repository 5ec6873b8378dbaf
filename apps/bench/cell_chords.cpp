#include <isocast/apps/bench/cell_chords.h>
#include <isocast/apps/bench/random.h>

#include <algorithm>
#include <cmath>

namespace isocast::bench {
namespace {

void point_on_face(Random& random, int face, double (&p)[3]) {
  for (double& x : p) x = random.uniform();
  p[face / 2] = face % 2;
}

}  // namespace

void random_chord(Random& random, CellChord& chord) {
  const int from = random.below(6), to = (from + 1 + random.below(5)) % 6;
  point_on_face(random, from, chord.entry);
  point_on_face(random, to, chord.exit);
}

void diagonal_chord(int from, CellChord& chord) {
  for (int i = 0; i < 3; ++i) {
    chord.entry[i] = from >> i & 1;
    chord.exit[i] = 1 - chord.entry[i];
  }
}

void thin_chord(Random& random, CellChord& chord) {
  const double tiny = std::pow(10, random.uniform(-8, -1));
  const int axis = random.below(3), side = random.below(2);
  point_on_face(random, 2 * axis + side, chord.entry);
  std::copy(chord.entry, chord.entry + 3, chord.exit);
  const int other = (axis + 1) % 3;
  if (random.below(2)) {
    chord.exit[axis] = 1 - side;
    chord.exit[other] = std::clamp(chord.exit[other] + random.sign() * tiny, 0.0, 1.0);
  } else {
    const int edge = random.below(2);
    chord.entry[other] = edge ? 1 - tiny : tiny;
    chord.exit[other] = edge;
    chord.exit[axis] = side ? 1 - tiny : tiny;
  }
}

void axis_chord(Random& random, CellChord& chord) {
  const int axis = random.below(3), side = random.below(2);
  for (int i = 0; i < 3; ++i) {
    const double places[] = {0, 1, random.uniform()};
    chord.entry[i] = chord.exit[i] = places[random.below(3)];
  }
  chord.entry[axis] = side;
  chord.exit[axis] = 1 - side;
}

void face_chord(Random& random, CellChord& chord) {
  const int face = random.below(6), first = (face / 2 + 1) % 3, second = (face / 2 + 2) % 3;
  point_on_face(random, face, chord.entry);
  point_on_face(random, face, chord.exit);
  chord.entry[first] = random.below(2);
  if (random.below(2)) chord.exit[first] = 1 - chord.entry[first];
  else chord.exit[second] = random.below(2);
}

}  // namespace isocast::bench
