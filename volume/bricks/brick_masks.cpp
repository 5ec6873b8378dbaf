#include <isocast/volume/bricks/brick_masks.h>
#include <isocast/volume/bricks/make_mask.h>

namespace isocast {
namespace {

constexpr BrickMask kEmpty = {};

}  // namespace

BrickMasks::~BrickMasks() {
  for (const BrickMask* mask : masks_)
    if (mask != &kEmpty) delete mask;
}

const BrickMask& BrickMasks::keep(std::size_t brick, std::unique_ptr<BrickMask> made) const {
  const BrickMask* mask = nullptr;
  const BrickMask* const mine = made ? made.get() : &kEmpty;
  if (!std::atomic_ref(masks_[brick]).compare_exchange_strong(mask, mine, std::memory_order_acq_rel))
    return *mask;
  count_ += made != nullptr;
  (void)made.release();
  return *mine;
}

std::size_t BrickMasks::bytes() const {
  return masks_.size() * sizeof(masks_[0]) + count_ * sizeof(BrickMask);
}

const BrickMask& IsoMasks::of(const VolumeQuery& query, int iso, std::size_t brick,
                              const std::int32_t (&first)[3]) const {
  return of(brick, [&] { return make_mask(query, iso, first); });
}

}  // namespace isocast
