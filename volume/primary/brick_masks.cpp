#include <isocast/volume/primary/brick_masks.h>
#include <isocast/volume/primary/make_mask.h>

namespace isocast {
namespace {

constexpr BrickMask kEmpty = {};

}  // namespace

IsoMasks::IsoMasks(std::size_t bricks, double key)
    : key_(key), count_(bricks), masks_(std::make_unique<std::atomic<const BrickMask*>[]>(bricks)) {}

IsoMasks::~IsoMasks() {
  for (std::size_t i = 0; i < count_; ++i)
    if (const BrickMask* mask = masks_[i]; mask != &kEmpty) delete mask;
}

const BrickMask* IsoMasks::of(const VolumeQuery& query, int iso, std::size_t brick,
                              const std::int32_t (&first)[3]) const {
  std::atomic<const BrickMask*>& slot = masks_[brick];
  const BrickMask* mask = slot.load(std::memory_order_acquire);
  if (!mask) {
    std::unique_ptr<BrickMask> made = make_mask(query, iso, first);
    const BrickMask* const mine = made ? made.get() : &kEmpty;
    if (slot.compare_exchange_strong(mask, mine, std::memory_order_acq_rel)) {
      mask = mine;
      made_ += made != nullptr;
      (void)made.release();
    }
  }
  return mask->blocks ? mask : nullptr;
}

std::size_t IsoMasks::bytes() const { return count_ * sizeof(masks_[0]) + made_ * sizeof(BrickMask); }

}  // namespace isocast
