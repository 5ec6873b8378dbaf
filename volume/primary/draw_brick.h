// The active cells of a brick, drawn into a patch: nearest blocks first, hidden ones not at all.
#pragma once

#include <isocast/volume/cube_bits.h>
#include <isocast/volume/primary/footprints.h>
#include <isocast/volume/primary/pairs.h>

namespace isocast::inline ISO_ISA {

/// All that drawing needs of its surroundings. clip: the brick's pixels.
struct DrawContext {
  const VolumeQuery& query;
  const ScreenMap& map;
  PatchMap patch_map;
  PatchState& patch;
  TraceCounts& counts;
  int iso;
  PixelBox clip;
};

/// Some of a cube's boxes in the order in which they are drawn: their numbers in the cube, their pixels and
/// nearest_t. Room for a register behind the last.
struct BoxList {
  static constexpr int kRoom = kCubeBoxes + kWidth<Native<float>>;
  std::int32_t number[kRoom], x_lo[kRoom], x_hi[kRoom], y_lo[kRoom], y_hi[kRoom];
  float nearest[kRoom];  // no ray meets the box before this t
  int size = 0;
};
inline PixelBox pixels_of(const BoxList& list, int i) {
  return {list.x_lo[i], list.x_hi[i], list.y_lo[i], list.y_hi[i]};
}

/// Lists the cube's boxes of `bits`, each of `size` cells along an edge, that may meet pixels of the patch.
/// first: the cube's first cell; flip: what numbers are exclusive-ored with, so that those near the eye come
/// first.
inline void list_boxes(const DrawContext& context, std::uint64_t bits, const std::int32_t (&first)[3],
                       int size, int flip, BoxList& list) {
  using R = Native<float>;
  const PatchMap& map = context.patch_map;
  const PixelBox& clip = context.clip;
  std::int32_t numbers[BoxList::kRoom];
  const int count = put_numbers(numbers, flipped(bits, flip), flip);
  const double corner[3] = {double(first[0]), double(first[1]), double(first[2])};
  float base[3], eye[3];
  for (int r = 0; r < 3; ++r) {
    base[r] = float(apply(map.h[r], corner));
    eye[r] = float(apply(map.to_eye[r], corner));
  }
  const R radius = R(float(size) * map.radius);
  int n = 0;
  for (int i = 0; i < count; i += kWidth<R>) {
    const Ints<R> number = load_ints<R>(numbers + i);
    R center[3], at[3], from_eye[3];
    for (int a = 0; a < 3; ++a) center[a] = R(float(size)) * (to_real<R>(place_in_cube(number, a)) + R(0.5f));
    for (int r = 0; r < 3; ++r) {
      at[r] = R(base[r]);
      from_eye[r] = R(eye[r]);
      for (int a = 0; a < 3; ++a) {
        at[r] = at[r] + R(map.linear[r][a]) * center[a];
        from_eye[r] = from_eye[r] + R(map.eye[r][a]) * center[a];
      }
    }
    const Footprint<R> f = footprint(map.linear, at[0], at[1], at[2], float(size));
    const R x_lo = select(f.whole, R(float(clip.x_lo)), first_pixel(f.u, f.du, clip.x_lo, clip.x_hi)),
            x_hi = select(f.whole, R(float(clip.x_hi)), last_pixel(f.u, f.du, clip.x_lo, clip.x_hi)),
            y_lo = select(f.whole, R(float(clip.y_lo)), first_pixel(f.v, f.dv, clip.y_lo, clip.y_hi)),
            y_hi = select(f.whole, R(float(clip.y_hi)), last_pixel(f.v, f.dv, clip.y_lo, clip.y_hi));
    unsigned kept = bits_of((x_lo <= x_hi) & (y_lo <= y_hi));
    if (count - i < kWidth<R>) kept &= (1u << (count - i)) - 1;
    for (unsigned rest = bits_of(f.whole) & kept; rest; rest &= rest - 1) {
      const int l = __builtin_ctz(rest);
      double middle[3];
      for (int a = 0; a < 3; ++a) middle[a] = first[a] + size * (place_in_cube(numbers[i + l], a) + 0.5);
      if (!may_meet(map, context.patch, middle, size)) kept &= ~(1u << l);
    }
    put_ints(list.number + n, number, kept);
    put_ints(list.x_lo + n, to_ints(x_lo), kept);
    put_ints(list.x_hi + n, to_ints(x_hi), kept);
    put_ints(list.y_lo + n, to_ints(y_lo), kept);
    put_ints(list.y_hi + n, to_ints(y_hi), kept);
    put_reals(list.nearest + n, nearest_t(context.map.orthographic, from_eye, radius), kept);
    n += __builtin_popcount(kept);
  }
  list.size = n;
}

/// Queues the rays of a box of pixels that may cross cell number `number` of a block, window by window. The
/// cell is fetched when the first is found.
template <class T, bool kOrthographic>
inline void draw_cell(const DrawContext& context, const std::int32_t (&first)[3], const QuickBlock& block,
                      int number, const PixelBox& pixels) {
  using R = Native<float>;
  PatchState& patch = context.patch;
  PairQueue& queue = patch.queue;
  const int place[3] = {place_in_cube(number, 0), place_in_cube(number, 1), place_in_cube(number, 2)};
  int slot = -1;
  for (int y = pixels.y_lo; y <= pixels.y_hi; y += kRows<R>)
    for (int x = pixels.x_lo; x <= pixels.x_hi; x += kColumns<R>) {
      const int ray = y * kPatchPitch + x;
      const unsigned bits =
          rays_across<kOrthographic>(patch, block, place, ray) & window_lanes<R>(pixels, x, y);
      if (bits == 0) continue;
      if (slot < 0) {
        const std::int32_t at[3] = {first[0] + place[0], first[1] + place[1], first[2] + place[2]};
        slot = keep_cell(context.query, at, context.iso, cells_of(patch, T{}));
        if (slot < 0) return;
      }
      put_ints(queue.ray + queue.size, rays_from<R>(ray), bits);
      for (int l = 0; l < kWidth<R>; ++l) queue.cell[queue.size + l] = slot;
      queue.size += __builtin_popcount(bits);
      if (queue.size >= kPacketSize) solve_pairs<T, kOrthographic>(context.query, patch, context.counts);
    }
}

template <class T, bool kOrthographic>
inline void draw_block(const DrawContext& context, std::uint64_t bits, const std::int32_t (&first)[3],
                       int flip) {
  BoxList cells;
  list_boxes(context, bits, first, 1, flip, cells);
  context.counts.cells += __builtin_popcountll(bits);
  const QuickBlock block = quick_block<kOrthographic>(context.patch.look, first);
  for (int i = 0; i < cells.size; ++i)
    draw_cell<T, kOrthographic>(context, first, block, cells.number[i], pixels_of(cells, i));
}

template <class T, bool kOrthographic>
inline void draw_brick(const DrawContext& context, const std::int32_t (&first)[3], const BrickMask& mask) {
  int flip = 0;
  for (int a = 0; a < 3; ++a) {
    const double eye = context.map.eye[a],
                 middle = context.map.orthographic ? 0 : first[a] + 0.5 * kBrickSize;
    flip |= eye > middle ? 3 << 2 * a : 0;
  }
  BoxList blocks;
  list_boxes(context, mask.blocks, first, kBlockCells, flip, blocks);
  context.counts.macrocells += __builtin_popcountll(mask.blocks);
  for (int i = 0; i < blocks.size; ++i) {
    if (hidden(context.patch, pixels_of(blocks, i), blocks.nearest[i])) continue;
    std::int32_t at[3];
    for (int a = 0; a < 3; ++a) at[a] = first[a] + kBlockCells * place_in_cube(blocks.number[i], a);
    prefetch_block(context.query, at);
    draw_block<T, kOrthographic>(context, mask.cells[blocks.number[i]], at, flip);
  }
}

}  // namespace isocast::inline ISO_ISA
