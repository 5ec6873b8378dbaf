// The min/max pyramid that lets the walk leap over blocks without the iso-value, whatever it is.
#pragma once

#include <isocast/volume/grid.h>
#include <isocast/volume/volume.h>

#include <cstddef>
#include <span>
#include <vector>

namespace isocast {

/// Blocks of 4^3 and 16^3 cells with the range of all samples of their cells (faces shared), in the volume's
/// sample type (f16 as float); NaN is left out. Built once, in parallel; serves every iso-value.
class MacroCells {
 public:
  explicit MacroCells(const Volume& volume);

  /// The levels as kernels see them, coarse first.
  [[nodiscard]] const MacroLevel& level(int i) const { return levels_[i]; }
  [[nodiscard]] std::size_t bytes() const;
  /// All samples are finite numbers.
  [[nodiscard]] bool finite() const { return finite_; }

  /// The box of all coarse blocks whose range some iso-value's key parts (sample.h): outside, every cell lies
  /// on one side.
  [[nodiscard]] BlockBox active_box(std::span<const double> keys) const;

 private:
  std::vector<std::byte> ranges_[kMacroLevels];
  MacroLevel levels_[kMacroLevels];
  SampleType type_;
  bool finite_ = true;
};

}  // namespace isocast
