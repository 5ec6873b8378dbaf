// Rays through cubes of bricks, bricks and blocks to the active cells that they seem to cross.
#pragma once

#include <isocast/ray/hit.h>
#include <isocast/volume/cube_bits.h>
#include <isocast/volume/stream/march_field.h>
#include <isocast/volume/stream/ray_look.h>

namespace isocast::inline ISO_ISA {

/// A ray between two blocks. The cubes that it is in are those of `at`, in cells from the bricks' origin on;
/// level l: blocks in a brick, bricks in a cube of them, cubes in a cube of these and so on.
///
/// rest  of each level: the parts that are still to be visited, nearest first (flipped, cube_bits.h)
/// mask  of the brick
struct RayVisit {
  std::uint64_t rest[PyramidView::kMaxLevels + 1];
  const BrickMask* mask;
  std::int32_t at[3];
  std::int32_t slot, level, flip;
};

/// The cells of the parts of level l, as a power of two along an edge.
inline constexpr int shift_of_part(int l) { return 2 + 2 * l; }

template <Real R>
inline void start_visit(const MarchField& field, const WalkingRays& rays, int slot, RayVisit& visit) {
  visit.slot = slot;
  visit.flip = 0;
  for (int a = 0; a < 3; ++a) {
    visit.at[a] = 0;
    visit.flip |= rays.ray[slot].d[a] < 0 ? 3 << 2 * a : 0;
  }
  visit.level = field.pyramid.levels;
  const std::uint64_t bits = cube_bits(field.bricks, field.pyramid, visit.level - 1, {0, 0, 0}) &
                             look_at_boxes<R>(rays.look[slot], visit.at, 1 << shift_of_part(visit.level));
  visit.rest[visit.level] = flipped(bits, visit.flip);
}

/// Goes to the ray's next block with active cells, and returns these; 0: there is none.
template <Real R>
inline std::uint64_t next_block(const MarchField& field, const WalkingRays& rays, RayVisit& visit,
                                std::uint32_t& tested) {
  for (;;) {
    while (visit.rest[visit.level] == 0)
      if (++visit.level > field.pyramid.levels) return 0;
    std::uint64_t& rest = visit.rest[visit.level];
    const int number = __builtin_ctzll(rest) ^ visit.flip, shift = shift_of_part(visit.level);
    rest &= rest - 1;
    each_index<3>(
        [&](auto a) { visit.at[a] = (visit.at[a] & (-4 << shift)) + (place_in_cube(number, a) << shift); });
    ++tested;
    if (visit.level == 0) return visit.mask->cells[number];
    std::uint64_t parts;
    if (visit.level == 1) {
      const std::int32_t brick[3] = {visit.at[0] >> kBrickShift, visit.at[1] >> kBrickShift,
                                     visit.at[2] >> kBrickShift};
      visit.mask = &mask_of_all(field, find_brick(field.bricks, brick), brick);
      parts = visit.mask->blocks;
    } else
      parts = cube_bits(field.bricks, field.pyramid, visit.level - 2,
                        {visit.at[0] >> shift, visit.at[1] >> shift, visit.at[2] >> shift});
    if (parts == 0) continue;
    parts &= look_at_boxes<R>(rays.look[visit.slot], visit.at, 1 << (shift - 2));
    visit.rest[--visit.level] = flipped(parts, visit.flip);
  }
}

/// Queues cells of the block that the ray is at, nearest first.
inline void queue_cells(const MarchField& field, const RayVisit& visit, std::uint64_t cells,
                        std::uint32_t& tested, CellQueue& queue) {
  for (cells = flipped(cells, visit.flip); cells; cells &= cells - 1) {
    const int number = __builtin_ctzll(cells) ^ visit.flip, n = queue.size++;
    each_index<3>(
        [&](auto a) { queue.cell[a][n] = field.bricks.origin[a] + visit.at[a] + place_in_cube(number, a); });
    queue.slot[n] = visit.slot;
    queue.tested[n] = ++tested;
  }
}

/// Marches the queued rays until each has met its root or is at its end.
template <Real R>
void march_rays(const MarchField& field, WalkingRays& rays, CellSolver& solver, TraceCounts& counts) {
  constexpr int kRays = 64;  // by turns, block by block: while the cells of one wait, others add theirs
  RayVisit visits[kRays];
  std::uint64_t cells[kRays];
  CellQueue queue;
  queue.size = 0;
  int next = 0, busy = 0;
  for (;;) {
    while (busy < kRays && next < rays.size) start_visit<R>(field, rays, rays.queue[next++], visits[busy++]);
    if (busy == 0) break;
    for (int i = 0; i < busy;) {
      RayVisit& visit = visits[i];
      std::uint32_t tested = 0;
      cells[i] = rays.ended[visit.slot] ? 0 : next_block<R>(field, rays, visit, tested);
      counts.macrocells += tested;
      rays.tested[visit.slot] += tested;
      if (cells[i] != 0) ++i;
      else visit = visits[--busy];
    }
    for (int i = 0; i < busy; ++i) cells[i] &= look_at_boxes<R>(rays.look[visits[i].slot], visits[i].at, 1);
    for (int i = 0; i < busy; ++i) {
      counts.cells += __builtin_popcountll(cells[i]);
      queue_cells(field, visits[i], cells[i], rays.tested[visits[i].slot], queue);
      while (queue.size >= kPacketSize) solver.solve(queue);
    }
  }
  while (queue.size > 0) solver.solve(queue);
}

}  // namespace isocast::inline ISO_ISA
