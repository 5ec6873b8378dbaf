// Beams of whole pixels and of squares of them, thrown away as long as f can be proved not to be zero in
// them.
#pragma once

#include <isocast/implicit/beams/beam_lanes.h>
#include <isocast/implicit/beams/box_range.h>

namespace isocast::inline ISO_ISA {

/// The nearest depths of pixels and of squares of them that cannot be proved empty.
///
/// F         Interval<R>, over the box around a part of a beam, or AffineForm<R, 3>, which follows its slant
/// cast      the depths of a beam are halved, nearest half first, until a part of at most eps is not
///           rejected; where that is in the halving is one number, the path, in place of a stack
/// adaptive  a quadtree, breadth first: a square that is not empty is quartered, each quarter begins at the
///           depth that the square has reached, with four parts of eps (ours: half the evaluations or fewer),
///           and eps, which is that of a pixel times the square's side, halves; else every pixel is cast from
///           where the domain begins
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
    if (adaptive) {
      put(0, 0, 0, -rays_.before);
      for (level_ = 0, size_ = kBlockSide << finer_; size_ >= 1; size_ /= 2, ++level_) cast_level();
      return;
    }
    for (int y = 0; y < rays_.rows << finer_; ++y)
      for (int x = 0; x < rays_.columns << finer_; ++x) put(0, x, y, -rays_.before);
    cast_level();
  }

 private:
  // A beam in a lane.
  struct Beam {
    int cell, level, most;
    std::uint64_t path;
    DepthRange<T> all;
    [[nodiscard]] ISO_HD DepthRange<T> part() const {
      const std::uint64_t first = std::uint64_t(1) << level, number = path - first;
      const T width = all.length() / T(first);
      return {all.from + T(number) * width, number + 1 == first ? all.to : all.from + T(number + 1) * width};
    }
    // On to the part behind; false where there is none.
    ISO_HD bool advance() {
      while (path & 1) path >>= 1, --level;
      return path++ != 0;
    }
  };

  ISO_HD void put(int buffer, int x, int y, T from) {
    BeamCells<T>& cells = cells_.buffer[buffer];
    cells.x[cells.count] = static_cast<std::int16_t>(x), cells.y[cells.count] = static_cast<std::int16_t>(y);
    cells.from[cells.count++] = from;
  }
  // All cells of a level; what is left of them makes the next one.
  ISO_HD void cast_level() {
    BeamCells<T>&cells = cells_.buffer[level_ % 2], &next = cells_.buffer[1 - level_ % 2];
    next.count = 0;
    Beam beams[kBeamLanes];
    int in_work = 0, taken = 0;
    for (;;) {
      while (in_work < kBeamLanes && taken < cells.count)
        if (start(cells, taken++, beams[in_work])) ++in_work;
      if (in_work == 0) break;
      lanes_.count = 0;
      for (int l = 0; l < in_work; ++l) {
        const int cell = beams[l].cell;
        const T half = T(0.5) * T(size_) * scale(), side = T(kBlockSide / 2);
        lanes_.add(T(cells.x[cell]) * scale() + half - side, T(cells.y[cell]) * scale() + half - side, half,
                   beams[l].part());
      }
      lanes_.template look<F>(query_, rays_, registers_);
      roots_.evaluations += in_work;
      int left = 0;
      for (int l = 0; l < in_work; ++l)
        if (goes_on(cells, beams[l], lanes_.open >> l & 1)) beams[left++] = beams[l];
      in_work = left;
    }
    cells_.last = level_;
    if (size_ > 1) cells.count = 0;
  }
  // A cell becomes a beam; false where it misses the domain.
  ISO_HD bool start(BeamCells<T>& cells, int cell, Beam& beam) {
    const T half = T(0.5) * T(size_) * scale(), side = T(kBlockSide / 2);
    const BoxRange<T> box = box_range(rays_, T(cells.x[cell]) * scale() + half - side,
                                      T(cells.y[cell]) * scale() + half - side, half);
    beam = {cell, 0, 0, 1, {max(cells.from[cell], box.enters_from), min(rays_.most_depth, box.leaves_to)}};
    if (!(beam.all.from <= beam.all.to)) {
      drop(cells, cell);
      return false;
    }
    const T eps = rays_.eps * T(size_) * scale();
    constexpr int kMostLevels = 40;
    for (T length = beam.all.length(); length > eps && beam.most < kMostLevels; length *= T(0.5)) ++beam.most;
    // what a square was cut to begins near the surface: its quarters begin with small parts
    constexpr int kBelow = 2;
    if (level_ > 0 && beam.most > kBelow) {
      beam.level = beam.most - kBelow;
      beam.path = std::uint64_t(1) << beam.level;
    }
    return true;
  }
  ISO_HD bool goes_on(BeamCells<T>& cells, Beam& beam, bool open) {
    if (!open) {
      const bool more = beam.advance();
      if (!more) drop(cells, beam.cell);
      return more;
    }
    if (beam.level < beam.most) {
      beam.path *= 2, ++beam.level;
      return true;
    }
    const int x = cells.x[beam.cell], y = cells.y[beam.cell];
    const DepthRange<T> part = beam.part();
    if (size_ == 1) {
      paint(x >> finer_, y >> finer_, part);
      cells.from[beam.cell] = part.from;
      cells_.buffer[1 - level_ % 2].from[beam.cell] = part.to;
      return false;
    }
    const int half = size_ / 2;
    for (int q = 0; q < 4; ++q) {
      const int child_x = x + q % 2 * half, child_y = y + q / 2 * half;
      if (child_x >> finer_ < rays_.columns && child_y >> finer_ < rays_.rows)
        put(1 - level_ % 2, child_x, child_y, part.from);
    }
    return false;
  }
  ISO_HD void paint(int x, int y, DepthRange<T> part) {
    const int slot = pixel_slot(x, y);
    ++cells_.covered[slot];
    if (!(part.from < roots_.lo[slot])) return;
    roots_.lo[slot] = part.from, roots_.hi[slot] = part.to;
    roots_.t[slot] = T(0.5) * (part.from + part.to);
    cells_.level[slot] = static_cast<std::uint8_t>(level_ + 1);
  }
  // Nothing is left of a cell: notes the level at which the last beam of a pixel was thrown away.
  ISO_HD void drop(BeamCells<T>& cells, int cell) {
    cells.from[cell] = kInfinity<T>;
    const int side = size_ >> finer_ > 0 ? size_ >> finer_ : 1;
    for (int y = cells.y[cell] >> finer_, i = 0; i < side; ++i)
      for (int x = cells.x[cell] >> finer_, j = 0; j < side; ++j) {
        std::uint8_t& level = cells_.level[pixel_slot(x + j, y + i)];
        if (level < level_) level = static_cast<std::uint8_t>(level_);
      }
  }
  ISO_HD T scale() const { return T(1) / T(1 << finer_); }

  const FormulaQuery<T>& query_;
  const BlockRays<T>& rays_;
  BlockRoots<T>& roots_;
  BlockCells<T>& cells_;
  int finer_, level_ = 0, size_ = 1;
  void* registers_;
  BeamLanes<R> lanes_;
};

}  // namespace isocast::inline ISO_ISA
