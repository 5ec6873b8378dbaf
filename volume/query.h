// Everything that tracing a volume needs, as plain data, and the two entries of the tracer.
#pragma once

#include <isocast/ray/hit.h>
#include <isocast/volume/cell/kernels.h>
#include <isocast/volume/cell/options.h>
#include <isocast/volume/grid.h>
#include <isocast/volume/sparse_view.h>

namespace isocast {

inline constexpr int kMaxIsos = 16;

/// A volume surface for the tracer.
///
/// grid, tree       one of them holds the samples: a dense grid, or with `sparse` a tree
/// samples          the cells lie between these
/// grid_from_world  rows {A | b}: world to grid space
/// iso, key         iso-values in stored units, and their thresholds (sample.h), in any order
/// active           blocks of the walk's coarsest level outside hold no iso-value
/// cells            the intersectors of the instruction set that was chosen
/// proves           so does the method
/// object           written into hits
struct VolumeQuery {
  GridView grid;
  SparseView tree;
  SparseRanges tree_ranges;
  bool sparse;
  SampleBox samples;
  double grid_from_world[3][4];
  double iso[kMaxIsos], key[kMaxIsos];
  std::int32_t iso_count;
  BlockBox active;
  const CellKernels* cells;
  CellMethod method;
  CellOptions options;
  bool double_precision, proves;
  std::uint16_t object;
};

/// Surface::first_hit and Surface::next_hit. The walk is scalar code, compiled once: built for AVX-512 it was
/// no faster. The cells it finds are solved sixteen at a time in the widest registers. The bits do not depend
/// on the instruction set.
void trace_first_hits(const VolumeQuery& query, const RayStream& rays, HitStream& hits, TraceCounts& counts);
void trace_next_hits(const VolumeQuery& query, const RayStream& rays, HitStream& hits, TraceCounts& counts);

/// HitStream::sides of a root of iso-value `iso` that a ray with t_min = 0 has in a cell.
/// behind: f is negative behind it; touched: so it is in front.
[[nodiscard]] std::uint32_t sides_of_root(const VolumeQuery& query, const RayStream& rays, int slot,
                                          const std::int32_t (&cell)[3], int iso, bool behind, bool touched);

}  // namespace isocast
