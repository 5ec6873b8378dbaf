// The walk of one ray through a grid: blocks, smaller blocks, cells. Grid space: samples at the integers.
// Double precision.
#pragma once

#include <isocast/math/lanes.h>
#include <isocast/math/real.h>
#include <isocast/volume/grid.h>

namespace isocast::inline ISO_ISA {

/// o + t d in grid space, and the grid's first and last sample per axis. The plane x_a = k is met at
/// plane_t(a, k): one expression everywhere, so that a cell's exit and the next cell's entry have the same
/// bits, whoever computes them. An axis with step 0 is parallel: its planes are never met.
struct GridRay {
  double o[3], d[3], inverse[3];
  std::int32_t first[3], last[3], step[3];

  ISO_HD double plane_t(int a, double k) const { return (k - o[a]) * inverse[a]; }
  /// The lower plane of block b of 2^shift cells, or the grid's border where that comes before.
  ISO_HD std::int32_t plane(int a, std::int32_t b, std::int32_t shift) const {
    const std::int32_t k = b * (1 << shift);
    return k < first[a] ? first[a] : k < last[a] ? k : last[a];
  }
  /// Where the ray leaves block b: +inf on parallel axes.
  ISO_HD double leaves(int a, std::int32_t b, std::int32_t shift) const {
    return step[a] ? plane_t(a, double(plane(a, b + (step[a] > 0), shift))) : __builtin_inf();
  }
  /// Where it has come into it.
  ISO_HD double enters(int a, std::int32_t b, std::int32_t shift) const {
    return plane_t(a, double(plane(a, b + (step[a] < 0), shift)));
  }
  /// The grid's first and last block of 2^shift cells.
  ISO_HD std::int32_t first_block(int a, std::int32_t shift) const { return first[a] >> shift; }
  ISO_HD std::int32_t last_block(int a, std::int32_t shift) const { return (last[a] - 1) >> shift; }
};

/// A direction component whose reciprocal is not finite counts as parallel.
ISO_HD inline GridRay make_grid_ray(const double (&o)[3], const double (&d)[3], const SampleBox& samples) {
  GridRay ray;
  for (int a = 0; a < 3; ++a) {
    ray.o[a] = o[a];
    ray.d[a] = d[a];
    ray.inverse[a] = 1 / d[a];
    ray.first[a] = samples.first[a];
    ray.last[a] = samples.last[a];
    const bool moves = abs(ray.inverse[a]) < __builtin_inf();
    ray.step[a] = moves ? (d[a] < 0 ? -1 : 1) : 0;
  }
  return ray;
}

/// The block (or cell) of a level that the ray is in, and per axis the first number outside its parent in the
/// ray's direction.
struct LevelPlace {
  std::int32_t at[3], end[3];
};

/// The state of a walk. Crossings of planes are ordered by (t, axis) and taken one at a time in this order on
/// every level; the planes of a level are some of those of the next. So the cells that are visited, and their
/// crossings, do not depend on the blocks that were leapt over.
///
/// t_in, axis_in  the last crossing; axis_in is kStart where the ray starts inside the grid
/// t_next         the next crossing of each axis on the level the walk is on, +inf on parallel ones
/// t_end          end of the ray or of the grid
/// depth          the level the walk is on
/// finest         the finest level whose place is that of (t_in, axis_in); still finer ones hold no meaning
/// moved          false until the first crossing
///
/// Functions that are given `shifts` want log2 of each level's blocks in cells, coarse first; those of a
/// Level want the walk to be there. Levels and axes are known to the compiler wherever they pick something,
/// so that a GPU can keep the walk in registers.
template <int Levels> struct GridWalk {
  static constexpr int kCells = Levels - 1;  // the level of single cells, below those of blocks
  LevelPlace level[Levels];
  double t_in, t_end, t_next[3];
  int axis_in, depth, finest;
  bool moved;

  ISO_HD const std::int32_t (&cell() const)[3] { return level[kCells].at; }
  /// The next crossing: the smallest (t, axis).
  ISO_HD int axis_out() const {
    const bool y = t_next[1] < t_next[0];
    return t_next[2] < (y ? t_next[1] : t_next[0]) ? 2 : y;
  }
  ISO_HD double t_out() const {
    const double t = t_next[1] < t_next[0] ? t_next[1] : t_next[0];
    return t_next[2] < t ? t_next[2] : t;
  }
};
inline constexpr int kStart = 3;

/// (t, a) comes before or at (t0, a0).
ISO_HD inline bool crossed(double t, int a, double t0, int a0) { return t < t0 || (t == t0 && a <= a0); }

/// Puts the walk into block b of a level along axis a, whose parent spans blocks lo...hi.
ISO_HD inline void set_block(const GridRay& ray, LevelPlace& place, int a, std::int32_t b, std::int32_t lo,
                             std::int32_t hi) {
  place.at[a] = b;
  place.end[a] = ray.step[a] < 0 ? lo - 1 : hi + 1;
}

/// The same for the block after all crossings up to (t_in, axis_in): searched from the rounded position,
/// which is off by one at most unless the ray comes from very far.
template <int Levels>
ISO_HD inline void find_block(const GridRay& ray, const GridWalk<Levels>& walk, LevelPlace& place,
                              std::int32_t shift, int a, std::int32_t lo, std::int32_t hi) {
  const double size = double(1 << shift),
               per_size = __builtin_bit_cast(double, std::int64_t(1023 - shift) << 52);
  const double position = (ray.o[a] + (ray.step[a] ? walk.t_in * ray.d[a] : 0.0)) * per_size;
  std::int32_t b = position > double(lo) ? (position < double(hi) ? std::int32_t(position) : hi) : lo;
  b -= double(b) > position && b > lo;  // towards -infinity
  if (ray.step[a] == 0) {
    // parallel for all that doubles can tell, but below the plane it starts on
    b -= ray.d[a] < 0 && b > lo && double(b) * size >= ray.o[a];
  } else {
    // forwards over planes that are crossed already, back over such that are not
    const std::int32_t ahead = ray.step[a] > 0 ? hi : lo, behind = ray.step[a] > 0 ? lo : hi;
    while (b != ahead && crossed(ray.leaves(a, b, shift), a, walk.t_in, walk.axis_in)) b += ray.step[a];
    while (b != behind && !crossed(ray.enters(a, b, shift), a, walk.t_in, walk.axis_in)) b -= ray.step[a];
  }
  set_block(ray, place, a, b, lo, hi);
}

/// Goes to a level whose place is known.
template <int Level, int Levels>
ISO_HD inline void go_to(const GridRay& ray, const std::int32_t (&shifts)[Levels], GridWalk<Levels>& walk) {
  walk.depth = Level;
  for (int a = 0; a < 3; ++a) walk.t_next[a] = ray.leaves(a, walk.level[Level].at[a], shifts[Level]);
}

/// Enters a box of the grid on the coarsest level: between the lower planes of its first blocks and the upper
/// planes of its last ones. False when [t_min, t_max] of the ray misses it, or anything is NaN.
template <int Levels>
ISO_HD inline bool enter_grid(const GridRay& ray, const std::int32_t (&shifts)[Levels], const BlockBox& box,
                              double t_min, double t_max, GridWalk<Levels>& walk) {
  walk.t_in = t_min;
  walk.t_end = min(t_max, __DBL_MAX__);  // planes that are never met, at +inf, lie behind the end
  walk.axis_in = kStart;
  walk.finest = 0;
  walk.moved = false;
  bool meets = true;
  each_index<3>([&](auto a) {
    const double low = double(ray.plane(a, box.lo[a], shifts[0])),
                 high = double(ray.plane(a, box.hi[a] + 1, shifts[0]));
    if (ray.step[a] == 0) {
      meets = meets && ray.o[a] >= low && ray.o[a] <= high && ray.d[a] == ray.d[a];
      return;
    }
    const double near = ray.plane_t(a, ray.step[a] > 0 ? low : high),
                 far = ray.plane_t(a, ray.step[a] > 0 ? high : low);
    if (walk.axis_in == kStart ? near > walk.t_in : near >= walk.t_in) {
      walk.t_in = near;
      walk.axis_in = a;
    }
    walk.t_end = min(walk.t_end, far);
  });
  if (!(meets && walk.t_in <= walk.t_end && walk.t_in < __builtin_inf())) return false;
  for (int a = 0; a < 3; ++a) find_block(ray, walk, walk.level[0], shifts[0], a, box.lo[a], box.hi[a]);
  go_to<0>(ray, shifts, walk);
  return true;
}

/// Goes one level down, into the part of the current block where the ray is.
template <int Level, int Levels>
ISO_HD inline void descend(const GridRay& ray, const std::int32_t (&shifts)[Levels], GridWalk<Levels>& walk) {
  const LevelPlace& from = walk.level[Level];
  LevelPlace& to = walk.level[Level + 1];
  const std::int32_t finer = shifts[Level + 1], size = 1 << (shifts[Level] - finer);
  const bool comes_from_neighbour = walk.finest > Level;  // only the border has moved
  walk.finest = comes_from_neighbour ? walk.finest : Level + 1;
  each_index<3>([&](auto a) {
    const std::int32_t start = from.at[a] * size, first = ray.first_block(a, finer),
                       last = ray.last_block(a, finer), lo = start > first ? start : first,
                       hi = start + size - 1 < last ? start + size - 1 : last;
    if (comes_from_neighbour) to.end[a] = ray.step[a] < 0 ? lo - 1 : hi + 1;
    else if (a == walk.axis_in)
      set_block(ray, to, a, ray.step[a] > 0 ? lo : hi, lo, hi);  // entered through this face
    else find_block(ray, walk, to, finer, a, lo, hi);
  });
  go_to<Level + 1>(ray, shifts, walk);
}

/// Crosses the next plane of axis a on one level; false when that leaves the parent.
ISO_HD inline bool cross(const GridRay& ray, LevelPlace& place, int a) {
  place.at[a] += ray.step[a];
  return place.at[a] != place.end[a];
}

/// Takes crossings until test(at) holds (true), or the parent is left or the ray ends (false). `tested`: the
/// current block is done with and crossed first.
template <int Level, int Levels, class Test>
ISO_HD inline bool walk_level(const GridRay& ray, const std::int32_t (&shifts)[Levels],
                              GridWalk<Levels>& walk, bool tested, Test test) {
  LevelPlace& place = walk.level[Level];
  bool found = !tested && test(place.at);
  bool inside = true;
  const auto take = [&](int a) {
    walk.t_in = walk.t_next[a];
    walk.axis_in = a;
    walk.finest = Level;
    inside = cross(ray, place, a) && walk.t_in <= walk.t_end;
    walk.t_next[a] = ray.leaves(a, place.at[a], shifts[Level]);
  };
  while (!found && inside) {
    walk.moved = true;
    if (walk.t_next[0] <= walk.t_next[1]) {
      if (walk.t_next[0] <= walk.t_next[2]) take(0);
      else take(2);
    } else {
      if (walk.t_next[1] <= walk.t_next[2]) take(1);
      else take(2);
    }
    if (inside) found = test(place.at);
  }
  return found;
}

/// The crossing of axis a on the levels above `Level`, to the first whose block it does not leave; false if
/// it leaves them all.
template <int Level, int Levels>
ISO_HD inline bool cross_above(const GridRay& ray, const std::int32_t (&shifts)[Levels], int a,
                               GridWalk<Levels>& walk) {
  if constexpr (Level == 0) return false;
  else {
    if (!cross(ray, walk.level[Level - 1], a)) return cross_above<Level - 1>(ray, shifts, a, walk);
    go_to<Level - 1>(ray, shifts, walk);
    return true;
  }
}
/// After walk_level has left `Level`: takes the same crossing on the coarser levels. False at the end of the
/// ray or of the grid.
template <int Level, int Levels>
ISO_HD inline bool ascend(const GridRay& ray, const std::int32_t (&shifts)[Levels], GridWalk<Levels>& walk) {
  if (!(walk.t_in <= walk.t_end)) return false;
  return at_index<3>(walk.axis_in, [&](auto a) { return cross_above<Level>(ray, shifts, a, walk); });
}

/// The state inside a given cell that the ray is known to cross: what the walk from the start would have made
/// of it.
template <int Levels>
ISO_HD inline void resume_in_cell(const GridRay& ray, const std::int32_t (&shifts)[Levels],
                                  const std::int32_t (&cell)[3], double t_min, GridWalk<Levels>& walk) {
  walk.t_in = t_min;
  walk.axis_in = kStart;
  walk.finest = walk.kCells;
  walk.moved = false;
  each_index<3>([&](auto a) {
    each_index<Levels>([&](auto l) {
      const std::int32_t first = ray.first_block(a, shifts[l]), last = ray.last_block(a, shifts[l]),
                         up = l > 0 ? shifts[l > 0 ? l - 1 : 0] - shifts[l] : 0, b = cell[a] >> shifts[l],
                         start = b >> up << up, end = start + (1 << up) - 1;
      set_block(ray, walk.level[l], a, b, l > 0 && start > first ? start : first,
                l > 0 && end < last ? end : last);
    });
    if (ray.step[a] == 0) return;
    const double t_entry = ray.enters(a, cell[a], 0);
    if (walk.axis_in == kStart ? t_entry > walk.t_in : t_entry >= walk.t_in) {
      walk.t_in = t_entry;
      walk.axis_in = a;
    }
  });
  go_to<Levels - 1>(ray, shifts, walk);
}

/// The ray's point at t in the current cell's own coordinates, in [0,1]; on the face of `axis` (crossed at
/// this t, entry or exit) the coordinate is exactly 0 or 1. Both cells of a face give the same bits for the
/// other two.
template <ScalarReal T, int Levels>
ISO_HD inline void point_in_cell(const GridRay& ray, const GridWalk<Levels>& walk, double t, int axis,
                                 bool exit, T (&p)[3]) {
  each_index<3>([&](auto a) {
    const T along = T(clamp01((ray.o[a] - double(walk.cell()[a])) + t * ray.d[a]));
    p[a] = a == axis ? T((ray.step[a] > 0) == exit ? 1 : 0) : along;
  });
}

}  // namespace isocast::inline ISO_ISA
