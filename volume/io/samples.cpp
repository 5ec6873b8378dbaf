#include <fmt/format.h>
#include <isocast/base/progress.h>
#include <isocast/volume/grid.h>
#include <isocast/volume/io/byte_order.h>
#include <isocast/volume/io/header_text.h>
#include <isocast/volume/io/samples.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

namespace isocast {
namespace {

std::string described(const Volume& volume) {
  return fmt::format("{} x {} x {} samples of type {}", volume.dims[0], volume.dims[1], volume.dims[2],
                     name_of(volume.type));
}

}  // namespace

std::uint64_t checked_bytes(const Volume& volume, const std::filesystem::path& path) {
  std::uint64_t bytes = size_of(volume.type);
  for (const std::int64_t n : volume.dims) {
    if (n < 1 || n > kMaxDim)
      throw read_error(
          path, fmt::format("found {}, expected dimensions between 1 and {}", described(volume), kMaxDim));
    if (__builtin_mul_overflow(bytes, static_cast<std::uint64_t>(n), &bytes) || bytes > INT64_MAX)
      throw read_error(path, described(volume) + " are more than 64-bit sizes can count");
  }
  return bytes;
}

std::byte* allocate_samples(Volume& volume, const std::filesystem::path& path) {
  const std::uint64_t bytes = checked_bytes(volume, path);
  const std::uint64_t memory =
      static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  std::byte* const samples = bytes < memory ? static_cast<std::byte*>(std::malloc(bytes)) : nullptr;
  if (!samples)
    throw read_error(path, fmt::format("{} need {} MB of memory, this machine has {} MB", described(volume),
                                       bytes / 1000000, memory / 1000000));
  volume.storage =
      std::shared_ptr<const void>(samples, [](const void* p) { std::free(const_cast<void*>(p)); });
  volume.samples = samples;
  volume.mapped = false;
  return samples;
}

void check_ratio(std::uint64_t bytes, std::uint64_t compressed, const std::filesystem::path& path) {
  constexpr std::uint64_t kFree = 200'000'000, kMostRatio = 200;
  const double ratio =
      static_cast<double>(bytes) / static_cast<double>(std::max<std::uint64_t>(compressed, 1));
  if (bytes > kFree && ratio > kMostRatio)
    throw read_error(path,
                     fmt::format("expected {} bytes out of {} compressed ones, {:.0f} times as much; above "
                                 "{} MB at most {} times as much is possible",
                                 bytes, compressed, ratio, kFree / 1'000'000, kMostRatio));
}

void place_samples(Volume& volume, const MappedFile& file, std::uint64_t offset, bool big_endian,
                   const std::filesystem::path& path) {
  const std::uint64_t bytes = checked_bytes(volume, path);
  const std::uint64_t found = file.bytes.size() - std::min<std::uint64_t>(offset, file.bytes.size());
  if (found < bytes) throw missing_samples(volume, found, path);
  const std::span<const std::byte> stored = file.bytes.subspan(offset, bytes);
  const std::size_t width = size_of(volume.type);

  // pages start aligned, so the offset decides
  if ((is_native(big_endian) || width == 1) && offset % width == 0) {
    volume.storage = file.pages;
    volume.samples = stored.data();
    volume.mapped = true;
  } else {
    copy_to_native(stored, allocate_samples(volume, path), width, big_endian);
    check_mapped_files();
  }
}

void place_last_samples(Volume& volume, const MappedFile& file, std::uint64_t offset, bool big_endian,
                        const std::filesystem::path& path) {
  const std::uint64_t bytes = checked_bytes(volume, path), size = file.bytes.size();
  place_samples(volume, file, std::max(offset, size - std::min(size, bytes)), big_endian, path);
}

std::uint64_t kept_unseen(std::uint64_t compressed) { return compressed + 192'000'000; }

std::uint64_t inflate_into(std::span<std::byte> out, Inflater& inflater) {
  constexpr std::size_t kSlab = std::size_t(16) << 20;
  const std::uint64_t unseen = kept_unseen(inflater.compressed_bytes());
  Progress progress("inflating", static_cast<std::int64_t>(out.size()));
  bool seen = false;
  for (std::size_t done = 0; done < out.size();) {
    const std::span<std::byte> rest = out.subspan(done), slab = rest.first(std::min(kSlab, rest.size()));
    if (!seen && done + slab.size() > unseen) {
      if (const std::uint64_t ahead = inflater.count_ahead(rest.size()); ahead < rest.size())
        return done + ahead;
      seen = true;
    }
    const std::size_t filled = inflater.read(slab);
    done += filled;
    if (filled < slab.size()) return done;
    progress.add(static_cast<std::int64_t>(filled));
  }
  return out.size();
}

void inflate_samples(Volume& volume, Inflater& inflater, std::uint64_t skip, bool big_endian,
                     const std::filesystem::path& path) {
  const std::uint64_t bytes = checked_bytes(volume, path);
  check_ratio(skip + bytes, inflater.compressed_bytes(), path);
  const std::span<std::byte> samples(allocate_samples(volume, path), bytes);
  inflater.skip(skip);
  if (const std::uint64_t found = inflate_into(samples, inflater); found < bytes)
    throw missing_samples(volume, found, path);

  // one byte more makes zlib compare its checksum where the stream ends with the samples
  inflater.skip(1);
  check_mapped_files();
  copy_to_native(samples, samples.data(), size_of(volume.type), big_endian);
}

InputError missing_samples(const Volume& volume, std::uint64_t found, const std::filesystem::path& path) {
  return read_error(path, fmt::format("expected {} bytes for {}, found {}", checked_bytes(volume, path),
                                      described(volume), found));
}

}  // namespace isocast
