// The table of what object order does for many rays or cells at once, one per instruction set.
#pragma once

#include <isocast/volume/bricks/brick_mask.h>
#include <isocast/volume/primary/patch.h>
#include <isocast/volume/primary/screen_map.h>
#include <isocast/volume/query.h>

namespace isocast {

enum class Isa : std::uint8_t;  // isa/cpu.h

/// start_patch   makes a patch ready (its frame, pixels and offsets are set): no tile is filled
/// fill_tile     the rays of the 16x16 pixels at (x, y) of the patch, with nothing hit
/// hidden        all rays of these pixels, whose tiles are filled, have met something before t
/// trace_brick   draws the cells of one iso-value of a brick (`first`: its first cell) into the patch. It
/// meets
///               no pixels but those of `clip`, whose tiles are filled
/// finish_patch  solves what is still queued
struct PrimaryKernels {
  void (*start_patch)(const VolumeQuery& query, PatchState& patch);
  void (*fill_tile)(const VolumeQuery& query, int x, int y, PatchState& patch);
  bool (*hidden)(PatchState& patch, const PixelBox& pixels, double t);
  void (*trace_brick)(const VolumeQuery& query, const ScreenMap& map, int iso, const std::int32_t (&first)[3],
                      const BrickMask& mask, const PixelBox& clip, PatchState& patch, TraceCounts& counts);
  void (*finish_patch)(const VolumeQuery& query, PatchState& patch, TraceCounts& counts);
};

/// The table of an instruction set that runs here. All give the same bits.
[[nodiscard]] const PrimaryKernels& primary_kernels(Isa isa);

}  // namespace isocast
