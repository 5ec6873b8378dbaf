// A cell of a quadtree as a beam, and which part of its depth is looked at.
#pragma once

#include <isocast/implicit/beams/box_range.h>

namespace isocast::inline ISO_ISA {

/// What follows when a part has been looked at: another part; nothing is left of the beam; the part is as
/// small as it gets and may hold roots.
enum class CastNext : std::uint8_t { part, gone, found };

/// Looks for the nearest part of a cell's depth that cannot be thrown away: halves, nearest first, of at most
/// eps. Where that is in the halving is one number, the path, in place of a stack.
///
/// number  of the cell in its level's list
/// eps     that of a pixel times the cell's side
/// start   a cell of the first level begins with all of its depth; others, which begin near what their square
///         was cut to, with four parts of eps (ours: half the evaluations or fewer)
/// source  Ganacim, de Figueiredo, Nehab: Beam casting implicit surfaces on the GPU with interval arithmetic,
///         SIBGRAPI 2011
template <class T> struct CellBeam {
  int number = 0;
  BeamCell<T> cell = {};
  T u = 0, v = 0, half = 0;  // pixels within `half` of (u, v), counted from the block's middle

  /// False where the beam misses the domain.
  ISO_HD bool start(const BlockRays<T>& rays, const CastLevel& level) {
    const T scale = T(1) / T(1 << level.finer), middle = T(kBlockSide / 2);
    half = T(0.5) * T(level.size) * scale;
    u = T(cell.x) * scale + half - middle, v = T(cell.y) * scale + half - middle;
    const BoxRange<T> box = box_range(rays, u, v, half);
    all_ = {max(cell.from, box.enters_from), min(rays.most_depth, box.leaves_to)};
    if (!(all_.from <= all_.to)) return false;
    level_ = most_ = 0, path_ = 1;
    const T eps = rays.eps * T(level.size) * scale;
    constexpr int kMostLevels = 40;
    for (T length = all_.length(); length > eps && most_ < kMostLevels; length *= T(0.5)) ++most_;
    constexpr int kBelow = 2;
    if (level.level > 0 && most_ > kBelow) {
      level_ = most_ - kBelow;
      path_ = std::uint64_t(1) << level_;
    }
    return true;
  }

  /// The part in turn.
  [[nodiscard]] ISO_HD DepthRange<T> part() const {
    const std::uint64_t first = std::uint64_t(1) << level_, place = path_ - first;
    const T width = all_.length() / T(first);
    return {all_.from + T(place) * width, place + 1 == first ? all_.to : all_.from + T(place + 1) * width};
  }

  /// On to the next part. open: this one may hold roots
  ISO_HD CastNext advance(bool open) {
    if (open && level_ == most_) return CastNext::found;
    if (open) {
      path_ *= 2, ++level_;
      return CastNext::part;
    }
    while (path_ & 1) path_ >>= 1, --level_;
    return path_++ != 0 ? CastNext::part : CastNext::gone;
  }

 private:
  int level_ = 0, most_ = 0;
  std::uint64_t path_ = 1;
  DepthRange<T> all_ = {};
};

}  // namespace isocast::inline ISO_ISA
