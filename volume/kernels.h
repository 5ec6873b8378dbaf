// The table of volume kernels, one per instruction set: a stream of rays through a grid of samples.
#pragma once

#include <isocast/isa/cpu.h>
#include <isocast/ray/hit.h>
#include <isocast/volume/cell/options.h>
#include <isocast/volume/grid.h>

namespace isocast {

inline constexpr int kMaxIsos = 16;

/// Everything a kernel needs to know of a volume surface.
///
/// grid_from_world  rows {A | b}: world to grid space
/// iso, key         iso-values in stored units, and their thresholds (sample.h), ascending in no particular order
/// object           written into hits
struct VolumeQuery {
  GridView grid;
  double grid_from_world[3][4];
  double iso[kMaxIsos], key[kMaxIsos];
  std::int32_t iso_count;
  CellMethod method;
  CellOptions options;
  bool double_precision;
  std::uint16_t object;
};

struct VolumeKernels {
  /// Surface::first_hit and Surface::next_hit.
  void (*first_hit)(const VolumeQuery&, const RayStream&, HitStream&, TraceCounts&);
  void (*next_hit)(const VolumeQuery&, const RayStream&, HitStream&, TraceCounts&);
};

/// The table of an instruction set that runs here. The same query gives the same bits in all of them.
[[nodiscard]] const VolumeKernels& volume_kernels(Isa isa);

}  // namespace isocast
