// A level of a quadtree of beams, wherever its cells are kept: in a block's lists, or one to a thread of a
// GPU.
#pragma once

#include <isocast/implicit/beams/beam_lanes.h>
#include <isocast/implicit/beams/cell_beam.h>

namespace isocast::inline ISO_ISA {

/// Casts all cells of a level, kBeamLanes of them at a time, a finished one replaced by the next; what is
/// left of them makes the next level. Returns the evaluations that it took.
///
/// F      Interval<R>, over the box around a part of a beam, or AffineForm<R, 3>, which follows its slant
/// cells  take(beam): gives the next cell and its number, false where there is none; drop(beam): nothing is
///        left of it; put(cell): one of the next level; find(beam): one of the finest level, whose part() may
///        hold roots
template <class F, Real R, class Cells>
ISO_HD inline std::int64_t cast_cells(const FormulaQuery<Scalar<R>>& query, const BlockRays<Scalar<R>>& rays,
                                      const CastLevel& level, Cells& cells, void* registers) {
  using T = Scalar<R>;
  BeamLanes<R> lanes;
  CellBeam<T> beams[kBeamLanes];
  // one lane has a place that a GPU's compiler knows
  constexpr auto place = [](int l) { return kBeamLanes == 1 ? 0 : l; };
  std::int64_t evaluations = 0;
  int in_work = 0;
  for (;;) {
    while (in_work < kBeamLanes && cells.take(beams[place(in_work)]))
      if (beams[place(in_work)].start(rays, level)) ++in_work;
      else cells.drop(beams[place(in_work)]);
    if (in_work == 0) return evaluations;
    if constexpr (kBeamLanes == 1) in_work = 1;
    lanes.count = 0;
    for (int l = 0; l < in_work; ++l) lanes.add(beams[l].u, beams[l].v, beams[l].half, beams[l].part());
    lanes.template look<F>(query, rays, registers);
    evaluations += in_work;
    int left = 0;
    for (int l = 0; l < in_work; ++l) {
      const CastNext next = beams[l].advance(lanes.open >> l & 1);
      if (next == CastNext::part) beams[place(left++)] = beams[l];
      else if (next == CastNext::gone) cells.drop(beams[l]);
      else if (level.size == 1) cells.find(beams[l]);
      else quarter(beams[l], rays, level, cells);
    }
    in_work = left;
  }
}

/// Puts those quarters of a cell that hold pixels of the picture, to begin where the cell's part does.
template <class T, class Cells>
ISO_HD inline void quarter(const CellBeam<T>& beam, const BlockRays<T>& rays, const CastLevel& level,
                           Cells& cells) {
  const int half = level.size / 2;
  for (int q = 0; q < 4; ++q) {
    const int x = beam.cell.x + q % 2 * half, y = beam.cell.y + q / 2 * half;
    if (x >> level.finer < rays.columns && y >> level.finer < rays.rows)
      cells.put({static_cast<std::int16_t>(x), static_cast<std::int16_t>(y), beam.part().from});
  }
}

/// Cells that casting begins with, and the i-th of them.
template <class T> ISO_HD inline int first_cell_count(const BlockRays<T>& rays, const CastLevel& level) {
  return level.across(rays.columns) * level.across(rays.rows);
}
template <class T>
ISO_HD inline BeamCell<T> first_cell(const BlockRays<T>& rays, const CastLevel& level, int i) {
  const int across = level.across(rays.columns);
  return {static_cast<std::int16_t>(i % across * level.size),
          static_cast<std::int16_t>(i / across * level.size), -rays.before};
}

/// Nothing is left of a cell: `levels` of its pixels become the level at which the last of their beams was
/// thrown away.
template <class T>
ISO_HD inline void note_level(const BeamCell<T>& cell, const CastLevel& level, std::uint8_t* levels) {
  const int side = level.size >> level.finer > 0 ? level.size >> level.finer : 1;
  for (int y = cell.y >> level.finer, i = 0; i < side; ++i)
    for (int x = cell.x >> level.finer, j = 0; j < side; ++j) {
      std::uint8_t& noted = levels[pixel_slot(x + j, y + i)];
      if (noted < level.level) noted = static_cast<std::uint8_t>(level.level);
    }
}

/// A part of a beam of a pixel may hold roots: the nearest one is painted, in any order.
template <class T> ISO_HD inline void paint(DepthRange<T> part, int slot, PixelRoots<T>& roots) {
  if (part.from > roots.lo[slot] || (part.from == roots.lo[slot] && part.to >= roots.hi[slot])) return;
  roots.lo[slot] = part.from, roots.hi[slot] = part.to;
  roots.t[slot] = T(0.5) * (part.from + part.to);
}

}  // namespace isocast::inline ISO_ISA
