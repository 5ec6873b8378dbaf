// Which cells of a dense grid hold an iso-value: bits, brick by brick, made where they are first asked for.
#pragma once

#include <isocast/volume/grid.h>
#include <isocast/volume/primary/brick_mask.h>

#include <atomic>
#include <cstddef>
#include <memory>

namespace isocast {

/// The masks of one iso-value. Bricks that nobody asks for are never looked at.
class IsoMasks {
 public:
  /// key  the iso-value's threshold (sample.h)
  IsoMasks(const GridView& grid, double key);
  ~IsoMasks();
  IsoMasks(const IsoMasks&) = delete;
  IsoMasks& operator=(const IsoMasks&) = delete;

  [[nodiscard]] double key() const { return key_; }
  /// The mask of brick b, x fastest, or null where its samples do not enclose the iso-value. From any thread.
  [[nodiscard]] const BrickMask* of(std::size_t brick) const;
  /// Memory of the masks made so far.
  [[nodiscard]] std::size_t bytes() const;

 private:
  GridView grid_;
  double key_;
  std::size_t count_;
  std::unique_ptr<std::atomic<const BrickMask*>[]> masks_;
  mutable std::atomic<std::size_t> made_ = 0;
};

}  // namespace isocast
