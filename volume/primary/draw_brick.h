// The active cells of a brick, drawn into a patch: nearest blocks first, hidden ones not at all.
#pragma once

#include <isocast/volume/primary/footprints.h>
#include <isocast/volume/primary/windows.h>

namespace isocast::inline ISO_ISA {

/// Blocks in a brick or cells in a block: a cube of 4^3.
inline constexpr int kCubeBoxes = 64;

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

/// Some of a cube's boxes in the order in which they are drawn: their first cells, their numbers in the cube,
/// their pixels and nearest_t.
struct BoxList {
  std::int32_t first[kCubeBoxes][3];
  int number[kCubeBoxes];
  PixelBox pixels[kCubeBoxes];
  float nearest[kCubeBoxes];  // no ray meets the box before this t
  int size = 0;
};

/// Bits in the order of their numbers exclusive-ored with `flip`: x, y and z are either reversed or not.
inline std::uint64_t flipped(std::uint64_t bits, int flip) {
  const auto swap = [&](std::uint64_t low, int by) { bits = (bits >> by & low) | (bits & low) << by; };
  if (flip & 1) {
    swap(0x5555555555555555u, 1);
    swap(0x3333333333333333u, 2);
  }
  if (flip & 4) {
    swap(0x0f0f0f0f0f0f0f0fu, 4);
    swap(0x00ff00ff00ff00ffu, 8);
  }
  if (flip & 16) {
    swap(0x0000ffff0000ffffu, 16);
    swap(0x00000000ffffffffu, 32);
  }
  return bits;
}

/// Lists the cube's boxes of `bits`, each of `size` cells along an edge, that may meet pixels of the patch.
/// first: the cube's first cell; flip: what numbers are exclusive-ored with, so that those near the eye come
/// first.
inline void list_boxes(const DrawContext& context, std::uint64_t bits, const std::int32_t (&first)[3],
                       int size, int flip, BoxList& list) {
  using R = Native<float>;
  const PatchMap& map = context.patch_map;
  const int count = __builtin_popcountll(bits);
  float centers[3][kCubeBoxes];
  int n = 0;
  for (std::uint64_t rest = flipped(bits, flip); rest; rest &= rest - 1, ++n) {
    const int number = __builtin_ctzll(rest) ^ flip;
    list.number[n] = number;
    centers[0][n] = float(size) * (float(number & 3) + 0.5f);
    centers[1][n] = float(size) * (float(number >> 2 & 3) + 0.5f);
    centers[2][n] = float(size) * (float(number >> 4) + 0.5f);
  }
  const double corner[3] = {double(first[0]), double(first[1]), double(first[2])};
  float base[3], eye[3], spans[4][kCubeBoxes], nearest[kCubeBoxes];  // spans: x from, to; y from, to
  for (int r = 0; r < 3; ++r) {
    base[r] = float(apply(map.h[r], corner));
    eye[r] = float(apply(context.map.to_eye[r], corner));
  }
  const R radius = R(float(size * context.map.cell_radius));
  const PixelBox& clip = context.clip;
  std::uint64_t whole = 0;
  for (int i = 0; i < count; i += kWidth<R>) {
    const R x = load<R>(centers[0] + i), y = load<R>(centers[1] + i), z = load<R>(centers[2] + i);
    R at[3], from_eye[3];
    for (int r = 0; r < 3; ++r) {
      at[r] = R(base[r]) + R(map.linear[r][0]) * x + R(map.linear[r][1]) * y + R(map.linear[r][2]) * z;
      from_eye[r] = R(eye[r]) + R(map.eye[r][0]) * x + R(map.eye[r][1]) * y + R(map.eye[r][2]) * z;
    }
    store(nearest + i, nearest_t(context.map.orthographic, from_eye, radius));
    const Footprint<R> f = footprint(map.linear, at[0], at[1], at[2], float(size));
    store(spans[0] + i, first_pixel(f.u, f.du, clip.x_lo, clip.x_hi));
    store(spans[1] + i, last_pixel(f.u, f.du, clip.x_lo, clip.x_hi));
    store(spans[2] + i, first_pixel(f.v, f.dv, clip.y_lo, clip.y_hi));
    store(spans[3] + i, last_pixel(f.v, f.dv, clip.y_lo, clip.y_hi));
    whole |= std::uint64_t(bits_of(f.whole)) << i;
  }
  list.size = 0;
  for (int i = 0; i < count; ++i) {
    const int number = list.number[i];
    PixelBox pixels = {int(spans[0][i]), int(spans[1][i]), int(spans[2][i]), int(spans[3][i])};
    std::int32_t(&at)[3] = list.first[list.size];
    at[0] = first[0] + size * (number & 3);
    at[1] = first[1] + size * (number >> 2 & 3);
    at[2] = first[2] + size * (number >> 4);
    if (whole >> i & 1) {
      const double center[3] = {at[0] + 0.5 * size, at[1] + 0.5 * size, at[2] + 0.5 * size};
      if (!may_meet(map, context.patch, center, size)) continue;
      pixels = clip;
    }
    list.number[list.size] = number;
    list.pixels[list.size] = pixels;
    list.nearest[list.size] = nearest[i];
    list.size += !is_empty(pixels);
  }
}

/// Drops those whose rays have all met something nearer.
inline void drop_covered(const PatchState& patch, BoxList& list) {
  int kept = 0;
  for (int i = 0; i < list.size; ++i) {
    if (covered(patch, list.pixels[i], double(list.nearest[i]))) continue;
    for (int a = 0; a < 3; ++a) list.first[kept][a] = list.first[i][a];
    list.pixels[kept++] = list.pixels[i];
  }
  list.size = kept;
}

/// Queues all rays that cross a cell, window by window.
template <class T, bool kOrthographic>
inline void draw_cell(const DrawContext& context, const CellToDraw<T>& cell, const PixelBox& pixels) {
  using R = Native<double>;
  for (int y = pixels.y_lo; y <= pixels.y_hi; y += kRows<R>)
    for (int x = pixels.x_lo; x <= pixels.x_hi; x += kColumns<R>) {
      const int columns = pixels.x_hi - x + 1;
      unsigned lanes = columns < kColumns<R> ? (1u << columns) - 1 : (1u << kColumns<R>)-1;
      if (kRows < R >> 1 && y < pixels.y_hi) lanes |= lanes << kColumns<R>;
      queue_window<T, kOrthographic>(cell, y * kPatchPitch + x, lanes, context.patch);
      if (pairs_of(context.patch, T{}).size >= kPacketSize)
        solve_pairs<T>(context.query, context.patch, context.counts);
    }
}

template <class T, bool kOrthographic>
inline void draw_block(const DrawContext& context, std::uint64_t bits, const std::int32_t (&first)[3],
                       int flip) {
  BoxList cells;
  list_boxes(context, bits, first, 1, flip, cells);
  context.counts.cells += __builtin_popcountll(bits);
  drop_covered(context.patch, cells);
  if (cells.size == 0) return;
  T f[kCubeBoxes][8];
  FetchedCell states[kCubeBoxes];
  fetch_cells(context.query, context.iso, cells.first, cells.size, f, states);
  for (int i = 0; i < cells.size; ++i) {
    if (states[i] == FetchedCell::none) continue;
    const std::int32_t(&at)[3] = cells.first[i];
    draw_cell<T, kOrthographic>(context, {{at[0], at[1], at[2]}, context.iso, states[i], f[i]},
                                cells.pixels[i]);
  }
}

template <class T, bool kOrthographic>
inline void draw_brick(const DrawContext& context, const std::int32_t (&first)[3], const BrickMask& mask) {
  constexpr int kBlock = 4;
  int flip = 0;
  for (int a = 0; a < 3; ++a) {
    const double eye = context.map.eye[a],
                 middle = context.map.orthographic ? 0 : first[a] + 0.5 * kBrickSize;
    flip |= eye > middle ? 3 << 2 * a : 0;
  }
  BoxList blocks;
  list_boxes(context, mask.blocks, first, kBlock, flip, blocks);
  context.counts.macrocells += __builtin_popcountll(mask.blocks);
  for (int i = 0; i < blocks.size; ++i) {
    const std::int32_t(&at)[3] = blocks.first[i];
    if (i + 1 < blocks.size) prefetch_block(context.query, blocks.first[i + 1]);
    if (!hidden(context.patch, blocks.pixels[i], double(blocks.nearest[i])))
      draw_block<T, kOrthographic>(context, mask.cells[blocks.number[i]], at, flip);
  }
}

}  // namespace isocast::inline ISO_ISA
