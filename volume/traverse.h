// The walk of one ray through a grid: blocks, smaller blocks, cells. Grid space: samples at the integers.
// Double precision.
#pragma once

#include <isocast/math/real.h>
#include <isocast/volume/grid.h>

namespace isocast::inline ISO_ISA {

/// o + t d in grid space, and the grid's first and last sample per axis. The plane x_a = k is met at
/// plane_t(a, k): one expression everywhere, so that a cell's exit and the next cell's entry have the same
/// bits, whoever computes them. An axis with step 0 is parallel: its planes are never met.
struct GridRay {
  double o[3], d[3], inverse[3], first[3], last[3];
  std::int32_t step[3];

  ISO_HD double plane_t(int a, double k) const { return (k - o[a]) * inverse[a]; }
  /// A plane of blocks, or the grid's border where that comes before.
  ISO_HD double inside(int a, double k) const { return max(min(k, last[a]), first[a]); }
  /// The grid's first and last block of 2^shift cells.
  ISO_HD std::int32_t first_block(int a, std::int32_t shift) const { return std::int32_t(first[a]) >> shift; }
  ISO_HD std::int32_t last_block(int a, std::int32_t shift) const {
    return (std::int32_t(last[a]) - 1) >> shift;
  }
};

/// A direction component whose reciprocal is not finite counts as parallel.
ISO_HD inline GridRay make_grid_ray(const double (&o)[3], const double (&d)[3], const SampleBox& samples) {
  GridRay ray;
  for (int a = 0; a < 3; ++a) {
    ray.o[a] = o[a];
    ray.d[a] = d[a];
    ray.inverse[a] = 1 / d[a];
    ray.first[a] = double(samples.first[a]);
    ray.last[a] = double(samples.last[a]);
    const bool moves = abs(ray.inverse[a]) < __builtin_inf();
    ray.step[a] = moves ? (d[a] < 0 ? -1 : 1) : 0;
  }
  return ray;
}

/// Where the ray is on one level.
///
/// at      block (or cell) per axis; `end` is the first number outside the parent block, in the ray's
/// direction plane   the plane through which it leaves, per axis, met at t_next (+inf on parallel axes) size
/// edge of a block in cells, a power of two, and its inverse
struct LevelWalk {
  std::int32_t at[3], end[3];
  double plane[3], t_next[3], size, per_size;

  /// Axis of the next crossing: the smallest (t, axis).
  ISO_HD int axis_out() const {
    const int a = t_next[1] < t_next[0] ? 1 : 0;
    return t_next[2] < t_next[a] ? 2 : a;
  }
};

/// The state of a walk. Crossings of planes are ordered by (t, axis) and taken one at a time in this order on
/// every level; the planes of a level are some of those of the next. So the cells that are visited, and their
/// crossings, do not depend on the blocks that were leapt over.
///
/// t_in, axis_in  the last crossing; axis_in is kStart where the ray starts inside the grid
/// t_end          end of the ray or of the grid
/// depth          the level the walk is on
/// finest         the finest level whose state is that of (t_in, axis_in); still finer ones hold no meaning
/// moved          false until the first crossing
template <int Levels> struct GridWalk {
  static constexpr int kCells = Levels - 1;  // the level of single cells, below those of blocks
  LevelWalk level[Levels];
  double t_in, t_end;
  int axis_in, depth, finest;
  bool moved;

  ISO_HD const std::int32_t (&cell() const)[3] { return level[kCells].at; }
  ISO_HD double t_out() const { return level[kCells].t_next[level[kCells].axis_out()]; }
};
inline constexpr int kStart = 3;

/// (t, a) comes before or at (t0, a0).
ISO_HD inline bool crossed(double t, int a, double t0, int a0) { return t < t0 || (t == t0 && a <= a0); }

ISO_HD inline void set_size(LevelWalk& level, std::int32_t shift) {
  level.size = double(1 << shift);
  level.per_size = 1 / level.size;
}

/// Puts the walk into block b of a level along axis a, whose parent spans blocks lo...hi.
ISO_HD inline void set_block(const GridRay& ray, LevelWalk& level, int a, std::int32_t b, std::int32_t lo,
                             std::int32_t hi) {
  level.at[a] = b;
  level.end[a] = ray.step[a] < 0 ? lo - 1 : hi + 1;
  level.plane[a] = ray.inside(a, double(b + (ray.step[a] > 0)) * level.size);
  level.t_next[a] = ray.step[a] ? ray.plane_t(a, level.plane[a]) : __builtin_inf();
}

/// The same for the block after all crossings up to (t_in, axis_in): searched from the rounded position,
/// which is off by one at most unless the ray comes from very far.
template <int Levels>
ISO_HD inline void find_block(const GridRay& ray, const GridWalk<Levels>& walk, LevelWalk& level, int a,
                              std::int32_t lo, std::int32_t hi) {
  const double position = (ray.o[a] + (ray.step[a] ? walk.t_in * ray.d[a] : 0.0)) * level.per_size;
  std::int32_t guess = position > double(lo) ? (position < double(hi) ? std::int32_t(position) : hi) : lo;
  guess -= double(guess) > position && guess > lo;  // towards -infinity
  set_block(ray, level, a, guess, lo, hi);
  if (ray.step[a] == 0) {
    // parallel for all that doubles can tell, but below the plane it starts on
    if (ray.d[a] < 0 && guess > lo && double(guess) * level.size >= ray.o[a]) --level.at[a];
    return;
  }
  // forwards over planes that are crossed already, back over such that are not
  const std::int32_t ahead = ray.step[a] > 0 ? hi : lo, behind = ray.step[a] > 0 ? lo : hi,
                     near = ray.step[a] < 0;
  while (level.at[a] != ahead && crossed(level.t_next[a], a, walk.t_in, walk.axis_in))
    set_block(ray, level, a, level.at[a] + ray.step[a], lo, hi);
  while (level.at[a] != behind &&
         !crossed(ray.plane_t(a, ray.inside(a, double(level.at[a] + near) * level.size)), a, walk.t_in,
                  walk.axis_in))
    set_block(ray, level, a, level.at[a] - ray.step[a], lo, hi);
}

/// Enters a box of the grid on the coarsest level, whose blocks have 2^shift cells: between the lower planes
/// of its first blocks and the upper planes of its last ones. False when [t_min, t_max] of the ray misses it,
/// or anything is NaN.
template <int Levels>
ISO_HD inline bool enter_grid(const GridRay& ray, std::int32_t shift, const BlockBox& box, double t_min,
                              double t_max, GridWalk<Levels>& walk) {
  walk.t_in = t_min;
  walk.t_end = min(t_max, __DBL_MAX__);  // planes that are never met, at +inf, lie behind the end
  walk.axis_in = kStart;
  walk.depth = walk.finest = 0;
  walk.moved = false;
  LevelWalk& level = walk.level[0];
  set_size(level, shift);
  for (int a = 0; a < 3; ++a) {
    const double low = ray.inside(a, double(box.lo[a]) * level.size),
                 high = ray.inside(a, double(box.hi[a] + 1) * level.size);
    if (ray.step[a] == 0) {
      if (!(ray.o[a] >= low && ray.o[a] <= high && ray.d[a] == ray.d[a])) return false;
      continue;
    }
    const double near = ray.plane_t(a, ray.step[a] > 0 ? low : high),
                 far = ray.plane_t(a, ray.step[a] > 0 ? high : low);
    if (walk.axis_in == kStart ? near > walk.t_in : near >= walk.t_in) {
      walk.t_in = near;
      walk.axis_in = a;
    }
    walk.t_end = min(walk.t_end, far);
  }
  if (!(walk.t_in <= walk.t_end && walk.t_in < __builtin_inf())) return false;
  for (int a = 0; a < 3; ++a) find_block(ray, walk, level, a, box.lo[a], box.hi[a]);
  return true;
}

/// Goes one level down, into the part of the current block where the ray is. Blocks of 2^shift cells become
/// 2^finer.
template <int Levels>
ISO_HD inline void descend(const GridRay& ray, std::int32_t shift, std::int32_t finer,
                           GridWalk<Levels>& walk) {
  const LevelWalk& from = walk.level[walk.depth];
  LevelWalk& to = walk.level[++walk.depth];
  const std::int32_t size = 1 << (shift - finer);
  if (walk.finest >= walk.depth) {  // come from the neighbouring block: only the border has moved
    const int a = walk.axis_in;
    const std::int32_t before = ray.first_block(a, finer) - 1, beyond = ray.last_block(a, finer) + 1,
                       end = to.end[a] + ray.step[a] * size;
    to.end[a] = end < before ? before : end < beyond ? end : beyond;
    return;
  }
  walk.finest = walk.depth;
  set_size(to, finer);
  for (int a = 0; a < 3; ++a) {
    const std::int32_t start = from.at[a] * size, first = ray.first_block(a, finer),
                       last = ray.last_block(a, finer), lo = start > first ? start : first,
                       hi = start + size - 1 < last ? start + size - 1 : last;
    if (a == walk.axis_in)
      set_block(ray, to, a, ray.step[a] > 0 ? lo : hi, lo, hi);  // entered through this face
    else find_block(ray, walk, to, a, lo, hi);
  }
}

/// Crosses the plane of axis a on one level; false when that leaves the parent.
ISO_HD inline bool cross(const GridRay& ray, LevelWalk& level, int a) {
  level.at[a] += ray.step[a];
  level.plane[a] = ray.inside(a, level.plane[a] + double(ray.step[a]) * level.size);
  level.t_next[a] = ray.plane_t(a, level.plane[a]);
  return level.at[a] != level.end[a];
}

/// Takes crossings on the current level until test(at) holds (true), or the parent is left or the ray ends
/// (false). `tested`: the current block is done with and crossed first.
template <int Levels, class Test>
ISO_HD inline bool walk_level(const GridRay& ray, GridWalk<Levels>& walk, bool tested, Test test) {
  LevelWalk& level = walk.level[walk.depth];
  bool found = !tested && test(level.at);
  bool inside = true;
  const auto take = [&](int a) {
    walk.t_in = level.t_next[a];
    walk.axis_in = a;
    walk.finest = walk.depth;
    inside = cross(ray, level, a) && walk.t_in <= walk.t_end;
  };
  while (!found && inside) {
    walk.moved = true;
    if (level.t_next[0] <= level.t_next[1]) {
      if (level.t_next[0] <= level.t_next[2]) take(0);
      else take(2);
    } else {
      if (level.t_next[1] <= level.t_next[2]) take(1);
      else take(2);
    }
    if (inside) found = test(level.at);
  }
  return found;
}

/// After walk_level has left the current level: takes the same crossing on the coarser levels, to the first
/// whose block it does not leave. False at the end of the ray or of the grid.
template <int Levels> ISO_HD inline bool ascend(const GridRay& ray, GridWalk<Levels>& walk) {
  if (!(walk.t_in <= walk.t_end)) return false;
  while (walk.depth > 0)
    if (cross(ray, walk.level[--walk.depth], walk.axis_in)) return true;
  return false;
}

/// The state inside a given cell that the ray is known to cross: what the walk from the start would have made
/// of it.
template <int Levels>
ISO_HD inline void resume_in_cell(const GridRay& ray, const std::int32_t (&shifts)[Levels],
                                  const std::int32_t (&cell)[3], double t_min, GridWalk<Levels>& walk) {
  walk.t_in = t_min;
  walk.axis_in = kStart;
  walk.depth = walk.finest = walk.kCells;
  walk.moved = false;
  for (int a = 0; a < 3; ++a) {
    for (int l = 0; l < Levels; ++l) {
      LevelWalk& level = walk.level[l];
      set_size(level, shifts[l]);
      const std::int32_t first = ray.first_block(a, shifts[l]), last = ray.last_block(a, shifts[l]),
                         up = l > 0 ? shifts[l - 1] - shifts[l] : 0, b = cell[a] >> shifts[l],
                         start = b >> up << up, end = start + (1 << up) - 1;
      set_block(ray, level, a, b, l > 0 && start > first ? start : first, l > 0 && end < last ? end : last);
    }
    if (ray.step[a] == 0) continue;
    const double t_entry = ray.plane_t(a, double(cell[a] + (ray.step[a] < 0)));
    if (walk.axis_in == kStart ? t_entry > walk.t_in : t_entry >= walk.t_in) {
      walk.t_in = t_entry;
      walk.axis_in = a;
    }
  }
}

/// The ray's point at t in the current cell's own coordinates, in [0,1]; on the face of `axis` (crossed at
/// this t, entry or exit) the coordinate is exactly 0 or 1. Both cells of a face give the same bits for the
/// other two.
template <ScalarReal T, int Levels>
ISO_HD inline void point_in_cell(const GridRay& ray, const GridWalk<Levels>& walk, double t, int axis,
                                 bool exit, T (&p)[3]) {
  for (int a = 0; a < 3; ++a) p[a] = T(clamp01((ray.o[a] - double(walk.cell()[a])) + t * ray.d[a]));
  if (axis < 3) p[axis] = T((ray.step[axis] > 0) == exit ? 1 : 0);
}

}  // namespace isocast::inline ISO_ISA
