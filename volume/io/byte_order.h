// Numbers of a file in the order of this machine.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace isocast {

[[nodiscard]] constexpr bool is_native(bool big_endian) {
  return big_endian == (std::endian::native == std::endian::big);
}

[[nodiscard]] inline std::uint8_t swapped(std::uint8_t v) { return v; }
[[nodiscard]] inline std::uint16_t swapped(std::uint16_t v) { return __builtin_bswap16(v); }
[[nodiscard]] inline std::uint32_t swapped(std::uint32_t v) { return __builtin_bswap32(v); }
[[nodiscard]] inline std::uint64_t swapped(std::uint64_t v) { return __builtin_bswap64(v); }

/// One unsigned number at any address.
template <std::unsigned_integral U> [[nodiscard]] U load_number(const std::byte* from, bool big_endian) {
  U value;
  std::memcpy(&value, from, sizeof value);
  return is_native(big_endian) ? value : swapped(value);
}

/// Copies numbers of `width` bytes (1, 2, 4 or 8) into native order, in parallel; `to` may be from.data().
void copy_to_native(std::span<const std::byte> from, std::byte* to, std::size_t width, bool big_endian);

}  // namespace isocast
