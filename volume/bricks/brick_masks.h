// The masks of one iso-value's bricks, made where they are first asked for.
#pragma once

#include <isocast/volume/bricks/brick_mask.h>
#include <isocast/volume/query.h>

#include <atomic>
#include <cstddef>
#include <vector>

namespace isocast {

/// Bricks that nobody asks for are never looked at.
class IsoMasks {
 public:
  /// key  the iso-value's threshold (sample.h)
  IsoMasks(std::size_t bricks, double key);
  ~IsoMasks();
  IsoMasks(const IsoMasks&) = delete;
  IsoMasks& operator=(const IsoMasks&) = delete;

  [[nodiscard]] double key() const { return key_; }
  /// The mask of brick number `brick`, whose first cell is `first`. iso: the iso-value's place in the query.
  /// From any thread.
  [[nodiscard]] const BrickMask& of(const VolumeQuery& query, int iso, std::size_t brick,
                                    const std::int32_t (&first)[3]) const;
  /// The masks made so far, by number of the brick; null: not made yet, no bits: no cell is active. To be
  /// read atomically.
  [[nodiscard]] const BrickMask* const* made() const { return masks_.data(); }
  /// Bricks that may have masks, those made so far that hold active cells, and the memory of all.
  [[nodiscard]] std::size_t bricks() const { return masks_.size(); }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  double key_;
  mutable std::vector<const BrickMask*> masks_;
  mutable std::atomic<std::size_t> count_ = 0;
};

}  // namespace isocast
