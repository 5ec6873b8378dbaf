// Corners of cells anywhere in a grid.
#pragma once

#include <isocast/volume/query.h>

namespace isocast {

/// What is known of a fetched cell: it exists; it does not (a corner is not finite); it does, but its corners
/// minus iso are too large for T (only told to methods that prove).
enum class FetchedCell : std::uint8_t { exists, none, doubtful };

/// Corners minus iso of cells.
void fetch_cells(const VolumeQuery& query, int iso, const std::int32_t (*cells)[3], int count, float (*f)[8],
                 FetchedCell* states);
void fetch_cells(const VolumeQuery& query, int iso, const std::int32_t (*cells)[3], int count, double (*f)[8],
                 FetchedCell* states);

/// Asks memory for the samples of the 4^3 cells of a dense grid from `first` on.
void prefetch_block(const VolumeQuery& query, const std::int32_t (&first)[3]);

}  // namespace isocast
