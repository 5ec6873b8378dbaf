// A fingerprint of 128 bits; not for adversaries.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace isocast {

/// Of all that was added, in order.
class Hash {
 public:
  void add_bytes(std::span<const std::byte> bytes);
  /// The bytes of numbers without padding between them.
  template <class T, std::size_t N> void add(std::span<T, N> numbers) { add_bytes(std::as_bytes(numbers)); }
  void add(const std::string& text) { add(std::span(text)); }
  /// 32 hexadecimal digits.
  [[nodiscard]] std::string text() const;

 private:
  void mix(std::uint64_t word);
  std::uint64_t state_[2] = {0x243f6a8885a308d3u, 0x13198a2e03707344u};  // digits of pi
};

}  // namespace isocast
