// The masks of a volume's bricks, made where they are first asked for.
#pragma once

#include <isocast/volume/bricks/brick_mask.h>
#include <isocast/volume/query.h>

#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

namespace isocast {

/// Bricks that nobody asks for are never looked at.
class BrickMasks {
 public:
  explicit BrickMasks(std::size_t bricks) : masks_(bricks, nullptr) {}
  ~BrickMasks();
  BrickMasks(const BrickMasks&) = delete;
  BrickMasks& operator=(const BrickMasks&) = delete;

  /// The mask of a brick, which `make` makes if there is none; it returns null where no cell is active. From
  /// any thread.
  template <class Make> [[nodiscard]] const BrickMask& of(std::size_t brick, const Make& make) const {
    const BrickMask* const mask = std::atomic_ref(masks_[brick]).load(std::memory_order_acquire);
    return mask ? *mask : keep(brick, make());
  }
  /// The masks made so far, by number of the brick; null: not made yet, no bits: no cell is active. To be
  /// read atomically.
  [[nodiscard]] const BrickMask* const* made() const { return masks_.data(); }
  /// Bricks that may have masks, those made so far that hold active cells, and the memory of all.
  [[nodiscard]] std::size_t bricks() const { return masks_.size(); }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  // The mask, or the one that another thread was faster to make.
  const BrickMask& keep(std::size_t brick, std::unique_ptr<BrickMask> made) const;

  mutable std::vector<const BrickMask*> masks_;
  mutable std::atomic<std::size_t> count_ = 0;
};

/// The masks of one iso-value.
class IsoMasks : public BrickMasks {
 public:
  /// key  the iso-value's threshold (sample.h)
  IsoMasks(std::size_t bricks, double key) : BrickMasks(bricks), key_(key) {}

  [[nodiscard]] double key() const { return key_; }
  using BrickMasks::of;
  /// The mask of brick number `brick`, whose first cell is `first`. iso: the iso-value's place in the query.
  [[nodiscard]] const BrickMask& of(const VolumeQuery& query, int iso, std::size_t brick,
                                    const std::int32_t (&first)[3]) const;

 private:
  double key_;
};

}  // namespace isocast
