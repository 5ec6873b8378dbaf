// Families of cells and chords that are hard on intersectors, each for a reason.
#pragma once

#include <isocast/apps/reference/cell_reference.h>

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace isocast::bench {

class Random;

/// `make` fills corner values (minus iso), entry and exit; `index` only matters where the cells are the rays
/// of a picture.
struct CellFamily {
  std::string_view name, meaning;
  void (*make)(Random& random, std::uint64_t index, reference::CellChord& chord);
};

[[nodiscard]] std::span<const CellFamily> cell_families();
/// Throws InputError for a name that is none of them.
[[nodiscard]] const CellFamily& cell_family(std::string_view name);

/// Rays of one picture of the families "mc-...", which show the paper's synthetic cells.
inline constexpr std::uint64_t kPictureRays = 256 * 256;

enum class Rounding { to_float, none };

/// Cells first ... first + count - 1 of a family, a pure function of its arguments. Rounded to float, every
/// number is the same in both precisions; where the rounding moves a prescribed root, the reference is right
/// and the prescription is not.
[[nodiscard]] std::vector<reference::CellChord> make_cells(const CellFamily& family, std::uint64_t seed,
                                                           std::uint64_t first, std::uint64_t count,
                                                           Rounding rounding);

/// Whole chords, nothing carried; the last packet's unused lanes are inactive.
template <class T>
[[nodiscard]] std::vector<CellPacket<T>> packets_of(std::span<const reference::CellChord> chords) {
  std::vector<CellPacket<T>> packets((chords.size() + kPacketSize - 1) / kPacketSize);
  for (std::size_t n = 0; n < chords.size(); ++n) {
    CellPacket<T>& packet = packets[n / kPacketSize];
    const std::size_t lane = n % kPacketSize;
    for (int i = 0; i < 8; ++i) packet.f[i][lane] = static_cast<T>(chords[n].f[i]);
    for (int i = 0; i < 3; ++i) {
      packet.entry[i][lane] = static_cast<T>(chords[n].entry[i]);
      packet.exit[i][lane] = static_cast<T>(chords[n].exit[i]);
    }
    packet.slack[lane] = 0;
    packet.carry[lane] = std::numeric_limits<T>::quiet_NaN();
    packet.active |= 1u << lane;
  }
  return packets;
}

}  // namespace isocast::bench
