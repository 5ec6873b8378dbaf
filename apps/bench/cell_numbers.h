// Families of cells that are hard for their numbers, whatever the roots are: members of cell_families().
#pragma once

#include <isocast/apps/reference/cell_reference.h>

#include <cstdint>

namespace isocast::bench {

class Random;

void plateau(Random& random, std::uint64_t, reference::CellChord& chord);
void checkerboard(Random& random, std::uint64_t, reference::CellChord& chord);
void denormal(Random& random, std::uint64_t, reference::CellChord& chord);
void scaled(Random& random, std::uint64_t, reference::CellChord& chord);
void steps(Random& random, std::uint64_t, reference::CellChord& chord);
void axis_aligned(Random& random, std::uint64_t, reference::CellChord& chord);
void in_face(Random& random, std::uint64_t, reference::CellChord& chord);

}  // namespace isocast::bench
