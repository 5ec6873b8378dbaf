#include <fmt/format.h>
#include <isocast/base/hash.h>

#include <bit>
#include <cstring>

namespace isocast {
namespace {

// The odd 64-bit numbers nearest to 2^64 over the golden ratio and over the plastic number.
constexpr std::uint64_t kFactors[2] = {0x9e3779b97f4a7c15u, 0xc13fa9a902a6328fu};

}  // namespace

void Hash::mix(std::uint64_t word) {
  for (int i = 0; i < 2; ++i) {
    state_[i] = std::rotl((state_[i] ^ word) * kFactors[i], 29 + 4 * i);
    state_[i] ^= state_[i] >> 32;
  }
}

void Hash::add_bytes(std::span<const std::byte> bytes) {
  mix(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, std::min<std::size_t>(8, bytes.size() - i));
    mix(word);
  }
}

std::string Hash::text() const {
  Hash last = *this;  // so that the last word reaches all bits
  for (int i = 0; i < 3; ++i) last.mix(0);
  return fmt::format("{:016x}{:016x}", last.state_[0], last.state_[1]);
}

}  // namespace isocast
