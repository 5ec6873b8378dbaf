// What rays in any order march through, as kernels see it.
#pragma once

#include <isocast/volume/bricks/brick_map.h>
#include <isocast/volume/bricks/brick_mask.h>
#include <isocast/volume/query.h>

namespace isocast {

class BrickMasks;
class IsoMasks;

/// The bricks of a grid with their masks. Grid space: samples at the integers.
///
/// pyramid      those that may hold active cells
/// low, high    planes between which there may be active cells
/// masks, made  of each iso-value, and IsoMasks::made of it
/// united, all  several iso-values: masks of the cells that hold any, and what is made of them; one: null,
///              and what is made of its own
struct MarchField {
  const VolumeQuery* query;
  BrickMap bricks;
  PyramidView pyramid;
  double low[3], high[3];
  const IsoMasks* masks[kMaxIsos];
  const BrickMask* const* made[kMaxIsos];
  const BrickMasks* united;
  const BrickMask* const* all;
};

/// The mask of a brick that is not made yet. at: the brick's place (find_brick).
[[nodiscard]] const BrickMask& new_mask(const MarchField& field, int iso, std::size_t brick,
                                        const std::int32_t (&at)[3]);
/// The same for the cells of all iso-values.
[[nodiscard]] const BrickMask& new_mask_of_all(const MarchField& field, std::size_t brick,
                                               const std::int32_t (&at)[3]);

}  // namespace isocast

namespace isocast::inline ISO_ISA {

inline const BrickMask& mask_of(const MarchField& field, int iso, std::size_t brick,
                                const std::int32_t (&at)[3]) {
  const BrickMask* mask = __atomic_load_n(field.made[iso] + brick, __ATOMIC_ACQUIRE);
  return mask ? *mask : new_mask(field, iso, brick, at);
}
inline const BrickMask& mask_of_all(const MarchField& field, std::size_t brick, const std::int32_t (&at)[3]) {
  const BrickMask* mask = __atomic_load_n(field.all + brick, __ATOMIC_ACQUIRE);
  return mask ? *mask : new_mask_of_all(field, brick, at);
}

}  // namespace isocast::inline ISO_ISA
