// The active cells of a brick, drawn into a patch: nearest blocks first, hidden ones not at all.
#pragma once

#include <isocast/volume/primary/footprints.h>
#include <isocast/volume/primary/windows.h>

namespace isocast::inline ISO_ISA {

inline constexpr int kBlockCells = 64;

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

/// Cells in a row, in the order in which they are drawn, with their pixels.
struct CellList {
  std::int32_t at[kBlockCells][3];
  float center[3][kBlockCells];  // in the block
  PixelBox pixels[kBlockCells];
  int size = 0;
};

/// The cells of a block's bits. flip: what numbers are exclusive-ored with, so that those near the eye come
/// first.
inline void list_cells(std::uint64_t bits, const std::int32_t (&first)[3], int flip, CellList& list) {
  for (int i = 0; i < kBlockCells; ++i) {
    const int cell = i ^ flip;
    if (!(bits >> cell & 1)) continue;
    const int place[3] = {cell & 3, cell >> 2 & 3, cell >> 4};
    for (int a = 0; a < 3; ++a) {
      list.at[list.size][a] = first[a] + place[a];
      list.center[a][list.size] = float(place[a]) + 0.5f;
    }
    ++list.size;
  }
}

/// Finds the pixels of the cells and keeps only those that have some.
inline void find_pixels(const DrawContext& context, const std::int32_t (&first)[3], CellList& list) {
  using R = Native<float>;
  const PatchMap& map = context.patch_map;
  const double corner[3] = {double(first[0]), double(first[1]), double(first[2])};
  float base[3], u[kBlockCells], v[kBlockCells], du[kBlockCells], dv[kBlockCells];
  for (int r = 0; r < 3; ++r) base[r] = float(apply(map.h[r], corner));
  std::uint64_t whole = 0;
  for (int i = 0; i < list.size; i += kWidth<R>) {
    const R x = load<R>(list.center[0] + i), y = load<R>(list.center[1] + i), z = load<R>(list.center[2] + i);
    R at[3];
    for (int r = 0; r < 3; ++r)
      at[r] = R(base[r]) + R(map.linear[r][0]) * x + R(map.linear[r][1]) * y + R(map.linear[r][2]) * z;
    const Footprint<R> f = footprint(map.linear, at[0], at[1], at[2], 1.0f);
    store(u + i, f.u);
    store(v + i, f.v);
    store(du + i, f.du);
    store(dv + i, f.dv);
    whole |= std::uint64_t(bits_of(f.whole)) << i;
  }
  int kept = 0;
  for (int i = 0; i < list.size; ++i) {
    const bool any = whole >> i & 1;
    const double center[3] = {list.at[i][0] + 0.5, list.at[i][1] + 0.5, list.at[i][2] + 0.5};
    if (any && !may_meet(map, context.patch, center, 1)) continue;
    const PixelBox pixels = clip_footprint(u[i], v[i], du[i], dv[i], any, context.clip);
    if (is_empty(pixels)) continue;
    list.pixels[kept] = pixels;
    for (int a = 0; a < 3; ++a) list.at[kept][a] = list.at[i][a];
    ++kept;
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
  CellList list;
  list_cells(bits, first, flip, list);
  context.counts.cells += list.size;
  find_pixels(context, first, list);
  if (list.size == 0) return;
  T f[kBlockCells][8];
  FetchedCell states[kBlockCells];
  fetch_cells(context.query, context.iso, list.at, list.size, f, states);
  for (int i = 0; i < list.size; ++i) {
    if (states[i] == FetchedCell::none) continue;
    const CellToDraw<T> cell = {{list.at[i][0], list.at[i][1], list.at[i][2]}, context.iso, states[i], f[i]};
    draw_cell<T, kOrthographic>(context, cell, list.pixels[i]);
  }
}

template <class T, bool kOrthographic>
inline void draw_brick(const DrawContext& context, const std::int32_t (&first)[3], const BrickMask& mask) {
  constexpr int kBlock = 4, kBlocks = 64;
  int flip = 0;
  for (int a = 0; a < 3; ++a) {
    const bool upper =
        context.map.orthographic ? context.map.eye[a] > 0 : context.map.eye[a] > double(first[a]) + 8;
    flip |= upper ? 3 << 2 * a : 0;
  }
  for (int i = 0; i < kBlocks; ++i) {
    const int b = i ^ flip;
    if (!(mask.blocks >> b & 1)) continue;
    const std::int32_t at[3] = {first[0] + kBlock * (b & 3), first[1] + kBlock * (b >> 2 & 3),
                                first[2] + kBlock * (b >> 4)};
    const double center[3] = {at[0] + 2.0, at[1] + 2.0, at[2] + 2.0};
    const PixelBox pixels = box_pixels(context.patch_map, context.patch, center, kBlock, context.clip);
    ++context.counts.macrocells;
    if (is_empty(pixels) || hidden(context.patch, pixels, nearest_t(context.map, center, kBlock))) continue;
    draw_block<T, kOrthographic>(context, mask.cells[b], at, flip);
  }
}

}  // namespace isocast::inline ISO_ISA
