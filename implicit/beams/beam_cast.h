// Beams of whole pixels and of squares of them, thrown away as long as f can be proved not to be zero in
// them.
#pragma once

#include <isocast/implicit/beams/cast_cells.h>

namespace isocast::inline ISO_ISA {

/// The nearest depths of pixels and of squares of them that cannot be proved empty.
///
/// F         Interval<R> or AffineForm<R, 3> (cast_cells.h)
/// cast      the depths of a beam are halved until a part of at most eps is not rejected (CellBeam)
/// adaptive  a quadtree, breadth first: a square that is not empty is quartered, each quarter begins at the
///           depth that the square has reached, and eps, which is that of a pixel times the square's side,
///           halves; else every pixel is cast from where the domain begins
/// finer     so many levels more, below pixels
/// proves    misses
/// source    Ganacim, de Figueiredo, Nehab: Beam casting implicit surfaces on the GPU with interval
///           arithmetic, SIBGRAPI 2011; affine forms are named there as future work
template <class F, Real R> class BeamCast {
  using T = Scalar<R>;

 public:
  /// Bytes for each register of the tape.
  static constexpr std::size_t kRegisterBytes = BeamLanes<R>::kPacks * sizeof(F);

  ISO_HD BeamCast(const FormulaQuery<T>& query, const BlockRays<T>& rays, BlockRoots<T>& roots,
                  BlockCells<T>& cells, int finer, void* registers)
      : query_(query), rays_(rays), roots_(roots), cells_(cells), finer_(finer), registers_(registers) {}

  ISO_HD void run(bool adaptive) {
    roots_.evaluations = 0;
    for (int i = 0; i < kBlockPixels; ++i) {
      roots_.lo[i] = roots_.unclear[i] = kInfinity<T>;
      cells_.level[i] = cells_.covered[i] = 0;
    }
    cells_.buffer[0].count = cells_.buffer[1].count = 0;
    cells_.finer = finer_;
    CastLevel level = CastLevel::first(adaptive, finer_);
    Lists first = {level, roots_, cells_.buffer[1], cells_.buffer[0], cells_};
    for (int i = 0, count = first_cell_count(rays_, level); i < count; ++i)
      first.put(first_cell(rays_, level, i));
    for (; level.size >= 1; level = level.next()) cast(level);
  }

 private:
  // A level's cells and those of the next one, as cast_cells has them.
  struct Lists {
    const CastLevel& level;
    BlockRoots<T>& roots;
    BeamCells<T>&now, &next;
    BlockCells<T>& pixels;
    int taken = 0;

    ISO_HD bool take(CellBeam<T>& beam) {
      if (taken == now.count) return false;
      beam.number = taken++;
      beam.cell = {now.x[beam.number], now.y[beam.number], now.from[beam.number]};
      return true;
    }
    ISO_HD void drop(const CellBeam<T>& beam) {
      now.from[beam.number] = kInfinity<T>;
      note_level(beam.cell, level, pixels.level);
    }
    ISO_HD void put(const BeamCell<T>& cell) {
      next.x[next.count] = cell.x, next.y[next.count] = cell.y, next.from[next.count] = cell.from;
      ++next.count;
    }
    ISO_HD void find(const CellBeam<T>& beam) {
      const DepthRange<T> part = beam.part();
      const int slot = pixel_slot(beam.cell.x >> level.finer, beam.cell.y >> level.finer);
      ++pixels.covered[slot];
      pixels.level[slot] = static_cast<std::uint8_t>(level.level + 1);
      paint(part, slot, roots);
      now.from[beam.number] = part.from, next.from[beam.number] = part.to;
    }
  };

  ISO_HD void cast(const CastLevel& level) {
    BeamCells<T>&now = cells_.buffer[level.level % 2], &next = cells_.buffer[1 - level.level % 2];
    next.count = 0;
    Lists lists = {level, roots_, now, next, cells_};
    roots_.evaluations += cast_cells<F, R>(query_, rays_, level, lists, registers_);
    cells_.last = level.level;
    if (level.size > 1) now.count = 0;
  }

  const FormulaQuery<T>& query_;
  const BlockRays<T>& rays_;
  BlockRoots<T>& roots_;
  BlockCells<T>& cells_;
  int finer_;
  void* registers_;
};

}  // namespace isocast::inline ISO_ISA
