#include "mutant.h"

#include <algorithm>
#include <functional>
#include <random>

namespace isocast::hostile {
namespace {

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t n) { return n == 0 ? 0 : random() % n; }

// Three quarters of all places are in the head.
std::size_t place(const MadeFile& file, Random& random) {
  return below(random, file.head == 0 || random() % 4 == 0 ? file.bytes.size() : file.head);
}

void flip_bits(std::string& bytes, const MadeFile& file, Random& random) {
  for (std::uint64_t left = 1 + random() % 4; left > 0; --left)
    bytes[place(file, random)] ^= static_cast<char>(1 << random() % 8);
}

// A number of 1, 2, 4 or 8 bytes becomes 0, -1, or the largest or smallest of its kind.
void set_extreme(std::string& bytes, const MadeFile& file, Random& random) {
  const std::size_t width = std::size_t(1) << random() % 4, at = place(file, random) / width * width;
  const std::uint64_t extremes[] = {0, 0x0101010101010101, 0x7fffffffffffffff, 0x8000000000000000, ~0ull};
  for (std::size_t i = 0; i < width && at + i < bytes.size(); ++i)
    bytes[at + i] = static_cast<char>(extremes[random() % 5] >> 8 * (8 - width + i));
}

// The number that is written at or behind a place of the head becomes another one.
void set_written_number(std::string& bytes, const MadeFile& file, Random& random) {
  constexpr const char* kNumbers[] = {
      "0",   "-1",   "4294967295",           "4294967296", "9223372036854775807",
      "nan", "-inf", "18446744073709551616", "1e309",      "1073741825",
      "",    "1"};
  constexpr std::string_view kDigits = "0123456789.-";
  const std::size_t begin = bytes.find_first_of(kDigits, place(file, random));
  if (begin == bytes.npos) return;
  const std::size_t end = std::min(bytes.find_first_not_of(kDigits, begin), bytes.size());
  bytes.replace(begin, end - begin, kNumbers[random() % std::size(kNumbers)]);
}

void move_piece(std::string& bytes, const MadeFile& file, Random& random) {
  const std::size_t at = place(file, random), size = 1 + below(random, 40);
  if (random() % 2) bytes.erase(at, size);
  else bytes.insert(at, bytes.substr(at, size));
}

}  // namespace

Mutant mutant(const MadeFile& file, std::uint64_t n) {
  Random random(std::hash<std::string>()(file.name) + n);
  Mutant made{file.name, file.bytes, Expected::either};
  constexpr std::uint64_t kKinds = 6;
  if (n % kKinds < 2) {
    made.bytes.resize(n % kKinds == 0 ? below(random, file.needed)
                                      : std::min(place(file, random), file.needed - 1));
    made.expected = Expected::error;
    return made;
  }
  constexpr void (*kDamages[])(std::string&, const MadeFile&, Random&) = {flip_bits, set_extreme,
                                                                          set_written_number, move_piece};
  kDamages[n % kKinds - 2](made.bytes, file, random);
  return made;
}

}  // namespace isocast::hostile
