#include <fmt/format.h>
#include <isocast/base/text.h>
#include <isocast/volume/io/base64.h>
#include <isocast/volume/io/header_text.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace isocast {
namespace {

enum : std::uint8_t { kPad = 64, kSpace = 65, kBad = 66 };

constexpr std::array<std::uint8_t, 256> kDigits = [] {
  std::array<std::uint8_t, 256> digits{};
  digits.fill(kBad);
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < kAlphabet.size(); ++i)
    digits[static_cast<std::uint8_t>(kAlphabet[i])] = static_cast<std::uint8_t>(i);
  for (const char c : {' ', '\t', '\r', '\n'}) digits[static_cast<std::uint8_t>(c)] = kSpace;
  digits['='] = kPad;
  return digits;
}();

}  // namespace

std::vector<std::byte> decode_base64(std::string_view text, std::size_t limit,
                                     const std::filesystem::path& path) {
  const auto fail = [&](std::size_t at, std::string_view what) {
    return read_error(path, fmt::format("the base64 data is damaged at its character {}: {}", at, what));
  };
  std::vector<std::byte> bytes;
  bytes.reserve(std::min(limit, text.size() / 4 * 3) + 3);
  std::uint32_t group = 0;
  int digits = 0, pads = 0;
  for (std::size_t i = 0; i < text.size() && bytes.size() < limit; ++i) {
    const std::uint8_t digit = kDigits[static_cast<std::uint8_t>(text[i])];
    if (digit == kSpace) continue;
    if (digit == kBad) throw fail(i, "unexpected " + in_quotes(text.substr(i, 1)));
    if (digit == kPad ? digits < 2 : pads > 0) throw fail(i, "misplaced padding");

    // four digits make three bytes, fewer with padding
    pads += digit == kPad;
    group = group << 6 | (digit == kPad ? 0u : digit);
    if (++digits < 4) continue;
    for (int b = 0; b < 3 - pads; ++b) bytes.push_back(static_cast<std::byte>(group >> (16 - 8 * b) & 0xff));
    group = 0;
    digits = pads = 0;
  }
  if (digits != 0) throw fail(text.size(), "the last group of four characters is cut short");
  bytes.resize(std::min(bytes.size(), limit));
  return bytes;
}

}  // namespace isocast
