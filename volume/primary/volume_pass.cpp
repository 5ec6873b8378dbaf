#include <isocast/isa/cpu.h>
#include <isocast/ray/tile_slot.h>
#include <isocast/volume/cell_root.h>
#include <isocast/volume/primary/volume_pass.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace isocast {
namespace {

constexpr int kTilesPerPatch = kPatchSize / kTileSize, kPatchesPerBlock = kBlockTiles / kTilesPerPatch;

// The place of a patch's tile in its block.
int block_tile(int pixel) { return pixel / kTileSize % kBlockTiles; }

PixelBox in_patch(const PixelBox& picture, const PatchState& patch) {
  return {std::max(picture.x_lo - patch.x, 0), std::min(picture.x_hi - patch.x, patch.columns - 1),
          std::max(picture.y_lo - patch.y, 0), std::min(picture.y_hi - patch.y, patch.rows - 1)};
}

}  // namespace

VolumePass::VolumePass(const VolumeQuery& query, std::vector<std::shared_ptr<const IsoMasks>> masks,
                       const View& view, BricksInView bricks, Isa isa)
    : query_(query),
      masks_(std::move(masks)),
      view_(view),
      bricks_(std::move(bricks)),
      kernels_(primary_kernels(isa)),
      scratch_([] { return std::make_unique_for_overwrite<PatchState>(); }) {}

void VolumePass::first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                            TraceCounts& counts) const {
  const DefaultFloatEnvironment environment;
  PatchState& patch = *scratch_.local();
  patch.frame = view_.ray_frame();
  patch.unit = bricks_.map.unit;
  patch.offset_u = offset_u;
  patch.offset_v = offset_v;
  for (int y = by * kPatchesPerBlock; y < std::min((by + 1) * kPatchesPerBlock, bricks_.rows); ++y)
    for (int x = bx * kPatchesPerBlock; x < std::min((bx + 1) * kPatchesPerBlock, bricks_.columns); ++x) {
      if (hits.unwanted()) return;
      trace_patch(x, y, hits, patch, counts);
    }
}

void VolumePass::trace_patch(int px, int py, BlockHits& hits, PatchState& patch, TraceCounts& counts) const {
  const std::vector<std::uint32_t>& bricks = bricks_.patches[std::size_t(py) * bricks_.columns + px];
  if (bricks.empty()) return;
  patch.x = px * kPatchSize;
  patch.y = py * kPatchSize;
  patch.columns = std::min(kPatchSize, view_.width() - patch.x);
  patch.rows = std::min(kPatchSize, view_.height() - patch.y);
  kernels_.start_patch(query_, patch);
  unsigned filled = 0;  // a bit for each tile
  for (const std::uint32_t number : bricks) {
    const SeenBrick& brick = bricks_.bricks[number];
    const PixelBox pixels = in_patch(brick.pixels, patch);
    filled = fill_tiles(pixels, filled, hits, patch);
    if (kernels_.hidden(patch, pixels, brick.nearest)) continue;
    for (int iso = 0; iso < query_.iso_count; ++iso)
      if (const BrickMask& mask =
              masks_[static_cast<std::size_t>(iso)]->of(query_, iso, brick.index, brick.first);
          mask.blocks != 0)
        kernels_.trace_brick(query_, bricks_.map, iso, brick.first, mask, pixels, patch, counts);
  }
  kernels_.finish_patch(query_, patch, counts);
  for (int tile = 0; tile < kTilesPerPatch * kTilesPerPatch; ++tile)
    if (filled >> tile & 1)
      write_tile(tile % kTilesPerPatch * kTileSize, tile / kTilesPerPatch * kTileSize, patch, hits, counts);
}

// Fills those tiles of the pixels that are not filled yet; what other objects have hit is as far as rays go.
unsigned VolumePass::fill_tiles(const PixelBox& pixels, unsigned filled, BlockHits& hits,
                                PatchState& patch) const {
  for (int ty = pixels.y_lo / kTileSize; ty <= pixels.y_hi / kTileSize; ++ty)
    for (int tx = pixels.x_lo / kTileSize; tx <= pixels.x_hi / kTileSize; ++tx) {
      const unsigned bit = 1u << (ty * kTilesPerPatch + tx);
      if (filled & bit) continue;
      filled |= bit;
      const int x0 = tx * kTileSize, y0 = ty * kTileSize, bx = block_tile(patch.x + x0),
                by = block_tile(patch.y + y0);
      kernels_.fill_tile(query_, x0, y0, patch);
      if (!hits.is_open(bx, by)) continue;
      const HitStream& others = hits.tile(bx, by);
      for (int y = 0; y < kTileSize; ++y)
        for (int x = 0; x < kTileSize; ++x) {
          const int ray = (y0 + y) * kPatchPitch + x0 + x;
          set_depth(patch, ray, std::min(patch.rays[ray].depth, others.t[tile_slot(x, y)]));
        }
    }
  return filled;
}

void VolumePass::write_tile(int x0, int y0, const PatchState& patch, BlockHits& hits,
                            TraceCounts& counts) const {
  const int columns = std::min(kTileSize, patch.columns - x0), rows = std::min(kTileSize, patch.rows - y0);
  const auto row = [&](const std::uint64_t(&bits)[kPatchSize], int y) {
    return static_cast<unsigned>(bits[y0 + y] >> x0 & ((1u << columns) - 1));
  };
  unsigned any = 0, walk = 0;
  for (int y = 0; y < rows; ++y) {
    any |= row(patch.met, y);
    walk |= row(patch.walk, y);
  }
  if (!any && !walk) return;
  const int tx = (patch.x + x0) / kTileSize, ty = (patch.y + y0) / kTileSize;
  HitStream& tile = hits.tile(tx % kBlockTiles, ty % kBlockTiles);
  RayStream rays;
  const bool several = query_.iso_count > 1;
  if (walk || several) view_.fill(tx, ty, patch.offset_u, patch.offset_v, rays);
  for (int y = 0; y < rows; ++y)
    for (unsigned rest = row(patch.met, y) & ~row(patch.walk, y); rest; rest &= rest - 1) {
      const int x = std::countr_zero(rest), slot = tile_slot(x, y);
      const PatchHit& hit = patch.hits[(y0 + y) * kPatchPitch + x0 + x];
      const CellRoot root = {hit.t_in, hit.t_out,    hit.s,
                             hit.s_lo, hit.s_hi,     {hit.cell[0], hit.cell[1], hit.cell[2]},
                             hit.iso,  hit.undecided};
      if (!(root_t(root) < tile.t[slot])) continue;
      const std::uint32_t sides =
          several ? sides_of_root(query_, rays, slot, root.cell, hit.iso, hit.behind, hit.undecided)
                  : hit.behind == hit.undecided;
      write_hit(query_, root, sides, tile, slot);
    }
  if (!walk) return;
  for (int y = 0; y < kTileSize; ++y)
    for (int x = 0; x < kTileSize; ++x) {
      const bool asked = y < rows && row(patch.walk, y) >> x & 1;
      if (!asked) rays.t_max[tile_slot(x, y)] = -1;
    }
  trace_first_hits(query_, rays, tile, counts);
}

}  // namespace isocast
