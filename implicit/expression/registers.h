// The registers of a tape while its instructions are laid out.
#pragma once

#include <cstdint>
#include <vector>

namespace isocast {

/// Hands out registers, those given back first.
class Registers {
 public:
  std::uint32_t take() {
    if (free_.empty()) return count_++;
    const std::uint32_t taken = free_.back();
    free_.pop_back();
    return taken;
  }
  void give_back(std::uint32_t one) { free_.push_back(one); }
  /// Starts again, with the memory of before.
  void clear() {
    free_.clear();
    count_ = 0;
  }
  [[nodiscard]] std::uint32_t count() const { return count_; }

 private:
  std::vector<std::uint32_t> free_;
  std::uint32_t count_ = 0;
};

}  // namespace isocast
