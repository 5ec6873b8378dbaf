#include <isocast/base/interrupt.h>
#include <isocast/base/progress.h>
#include <isocast/volume/io/byte_order.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

namespace isocast {
namespace {

template <std::unsigned_integral U>
void copy_swapped(const std::byte* from, std::byte* to, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    U value;
    std::memcpy(&value, from + i * sizeof(U), sizeof value);
    value = swapped(value);
    std::memcpy(to + i * sizeof(U), &value, sizeof value);
  }
}

void copy_slab(const std::byte* from, std::byte* to, std::size_t bytes, std::size_t width, bool big_endian) {
  if (is_native(big_endian) || width == 1) std::memmove(to, from, bytes);
  else if (width == 2) copy_swapped<std::uint16_t>(from, to, bytes / 2);
  else if (width == 4) copy_swapped<std::uint32_t>(from, to, bytes / 4);
  else copy_swapped<std::uint64_t>(from, to, bytes / 8);
}

}  // namespace

void copy_to_native(std::span<const std::byte> from, std::byte* to, std::size_t width, bool big_endian) {
  if (from.data() == to && (is_native(big_endian) || width == 1)) return;
  constexpr std::size_t kSlab = std::size_t(4) << 20;
  Progress progress("converting", static_cast<std::int64_t>(from.size()));
  oneapi::tbb::parallel_for(std::size_t(0), (from.size() + kSlab - 1) / kSlab, [&](std::size_t slab) {
    throw_if_interrupted();
    const std::span<const std::byte> part =
        from.subspan(slab * kSlab, std::min(kSlab, from.size() - slab * kSlab));
    copy_slab(part.data(), to + slab * kSlab, part.size(), width, big_endian);
    progress.add(static_cast<std::int64_t>(part.size()));
  });
}

}  // namespace isocast
