// A thread casts one beam: the cells of implicit/beams/cast_cells.h with one lane.
#pragma once

#include <isocast/cuda/beam_work.h>
#include <isocast/cuda/place.h>
#include <isocast/implicit/beams/cast_cells.h>
#include <isocast/implicit/beams/guess_roots.h>

namespace isocast::inline ISO_ISA {

static_assert(kBeamLanes == 1, "beam_body.h is for builds with ISO_ONE_RAY");

/// A thread's cell, as cast_cells has it. What is left of a level is counted by all threads together; where
/// in the lists it comes to lie depends on them, and nothing else does.
template <class T> struct ThreadCell {
  const BeamWork<T>& work;
  int number;
  bool taken = false;

  ISO_HD bool take(CellBeam<T>& beam) {
    if (taken) return false;
    taken = true;
    beam.cell = work.cells[work.level.level % 2][number];
    return true;
  }
  ISO_HD void drop(const CellBeam<T>& beam) { note_level(beam.cell, work.level, work.levels); }
  ISO_HD void put(const BeamCell<T>& cell) {
    const int next = work.level.level + 1;
    work.cells[next % 2][add_shared(work.counters->cells[next], 1)] = cell;
  }
  ISO_HD void find(const CellBeam<T>& beam) {
    const int finer = work.level.finer, last = (1 << finer) - 1, x = beam.cell.x, y = beam.cell.y;
    const int slot = pixel_slot(x >> finer, y >> finer);
    work.parts[(slot << 2 * finer) + ((y & last) << finer) + (x & last)] = beam.part();
  }
};

template <class T> ISO_HD inline void begin_beams(const BeamWork<T>& work, int i) {
  const int count = first_cell_count(work.rays, work.level);
  if (i == 0) {
    *work.counters = {};
    work.counters->cells[0] = count;
  }
  if (i < count) work.cells[0][i] = first_cell(work.rays, work.level, i);
  if (i < kBlockPixels) work.levels[i] = 0;
  work.parts[i] = {kInfinity<T>, kInfinity<T>};
}

/// The nearest part of each pixel becomes its root, guessed.
template <class T> ISO_HD inline void end_beams(const BeamWork<T>& work, int slot, void* registers) {
  PixelRoots<T>& roots = *work.roots;
  roots.lo[slot] = roots.unclear[slot] = kInfinity<T>;
  const int finest = 1 << 2 * work.level.finer;
  for (int i = 0; i < finest; ++i) {
    const DepthRange<T> part = work.parts[slot * finest + i];
    if (!(part.from < kInfinity<T>)) continue;
    paint(part, slot, roots);
    work.levels[slot] = static_cast<std::uint8_t>(work.level.level + 1);
  }
  guess_roots<T>(work.query, work.rays, slot / kStreamSize, slot % kStreamSize, roots, registers);
}

/// F: Interval<T> or AffineForm<T, 3>. `registers` has room for the tape's; a formula that is compiled in
/// needs one, for its value.
template <class F, class T>
ISO_HD inline void cast_beams(const BeamWork<T>& work, const Place& place, void* registers) {
  const std::int64_t i = place.number();
  switch (work.step) {
    case BeamStep::begin:
      if (i < kBlockPixels << 2 * work.level.finer) begin_beams(work, int(i));
      return;
    case BeamStep::cast: {
      if (i >= work.counters->cells[work.level.level]) return;
      ThreadCell<T> cell = {work, int(i)};
      add_shared(work.counters->evaluations,
                 cast_cells<F, T>(work.query, work.rays, work.level, cell, registers));
      return;
    }
    case BeamStep::end:
      if (i < kBlockPixels) end_beams(work, int(i), registers);
  }
}

// what F may be
template <class T> using IntervalBeam = Interval<T>;
template <class T> using AffineBeam = AffineForm<T, 3>;

}  // namespace isocast::inline ISO_ISA
