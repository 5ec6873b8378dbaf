// Corners of cells anywhere in a grid.
#pragma once

#include <isocast/volume/query.h>

namespace isocast {

/// What is known of the cells of lanes that were fetched, as bits. exists: all corners are finite. doubtful:
/// so they are, but minus iso they are too large for T (only told to methods that prove).
struct FetchedLanes {
  std::uint32_t exists = 0, doubtful = 0;
};

/// f[k][l]: corner k of the cell of lane l, minus iso. cells: first corners, axis by axis, one a lane.
FetchedLanes fetch_cells(const VolumeQuery& query, int iso, const std::int32_t* const (&cells)[3],
                         std::uint32_t lanes, float (*f)[kPacketSize]);
FetchedLanes fetch_cells(const VolumeQuery& query, int iso, const std::int32_t* const (&cells)[3],
                         std::uint32_t lanes, double (*f)[kPacketSize]);

/// Asks memory for the samples of the 4^3 cells of a dense grid from `first` on.
void prefetch_block(const VolumeQuery& query, const std::int32_t (&first)[3]);

}  // namespace isocast
