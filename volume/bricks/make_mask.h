// The bits of a brick from the samples of its cells.
#pragma once

#include <isocast/volume/bricks/brick_mask.h>
#include <isocast/volume/query.h>

#include <memory>

namespace isocast {

/// The active cells of the brick whose first cell is `first`, for one of the query's iso-values; null where
/// there are none.
[[nodiscard]] std::unique_ptr<BrickMask> make_mask(const VolumeQuery& query, int iso,
                                                   const std::int32_t (&first)[3]);

}  // namespace isocast
