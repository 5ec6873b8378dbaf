#include <isocast/volume/bricks/brick_masks.h>
#include <isocast/volume/bricks/make_mask.h>

namespace isocast {
namespace {

constexpr BrickMask kEmpty = {};

}  // namespace

IsoMasks::IsoMasks(std::size_t bricks, double key) : key_(key), masks_(bricks, nullptr) {}

IsoMasks::~IsoMasks() {
  for (const BrickMask* mask : masks_)
    if (mask != &kEmpty) delete mask;
}

const BrickMask& IsoMasks::of(const VolumeQuery& query, int iso, std::size_t brick,
                              const std::int32_t (&first)[3]) const {
  const std::atomic_ref slot(masks_[brick]);
  const BrickMask* mask = slot.load(std::memory_order_acquire);
  if (mask) return *mask;
  std::unique_ptr<BrickMask> made = make_mask(query, iso, first);
  const BrickMask* const mine = made ? made.get() : &kEmpty;
  if (!slot.compare_exchange_strong(mask, mine, std::memory_order_acq_rel)) return *mask;
  count_ += made != nullptr;
  (void)made.release();
  return *mine;
}

std::size_t IsoMasks::bytes() const { return masks_.size() * sizeof(masks_[0]) + count_ * sizeof(BrickMask); }

}  // namespace isocast
