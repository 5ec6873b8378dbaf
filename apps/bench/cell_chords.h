// Chords of a unit cell.
#pragma once

#include <isocast/apps/reference/cell_reference.h>

namespace isocast::bench {

class Random;
using reference::CellChord;

/// From a face to another one.
void random_chord(Random& random, CellChord& chord);
/// From a corner to the opposite one; `from` is the corner's index.
void diagonal_chord(int from, CellChord& chord);
/// Nearly parallel to an axis, or across an edge at a tiny distance from it.
void thin_chord(Random& random, CellChord& chord);
/// Parallel to an axis; a third of the other coordinates are 0, a third 1.
void axis_chord(Random& random, CellChord& chord);
/// In a face, from an edge to another one.
void face_chord(Random& random, CellChord& chord);

}  // namespace isocast::bench
