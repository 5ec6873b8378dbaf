// The parts of isocast_openvdb, the process that knows OpenVDB. Each throws for what it cannot do, with a
// part of a sentence.
#pragma once

#include <isocast/volume/io/vdb_image.h>
#include <unistd.h>

#include <cstring>
#include <new>
#include <string>
#include <vector>

namespace isocast::vdb_process {

/// Leaves a grid of a .vdb file in file 3 as a VdbImage.
void read(const std::string& path, const std::string& grid_name);

/// Leaves `bytes` bytes in file 3: those of blosc's blocks at `offset` of a file, `size` bytes with their
/// sizes.
void unblosc(const std::string& path, std::uint64_t offset, std::uint64_t size, std::uint64_t bytes);

/// Writes the grid that comes over stdin (VdbOrder) to a .vdb or .nvdb file.
void write(const std::string& path);

/// The bits of a number, as in SparseTile.
template <class T> std::uint64_t bits_of(T value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof value);
  return bits;
}

/// File 3, written in large pieces.
class ImageWriter {
 public:
  void add(const void* bytes, std::size_t size) {
    written_ += size;
    const auto* from = static_cast<const std::byte*>(bytes);
    buffer_.insert(buffer_.end(), from, from + size);
    if (buffer_.size() >= kPiece) flush();
  }
  void align() {
    constexpr std::uint64_t kZero = 0;
    add(&kZero, (8 - written_ % 8) % 8);
  }
  void flush() {
    for (std::size_t done = 0; done < buffer_.size();) {
      const ssize_t n = ::write(3, buffer_.data() + done, buffer_.size() - done);
      if (n < 0) throw std::bad_alloc();
      done += static_cast<std::size_t>(n);
    }
    buffer_.clear();
  }

 private:
  static constexpr std::size_t kPiece = std::size_t(1) << 20;
  std::vector<std::byte> buffer_;
  std::uint64_t written_ = 0;
};

}  // namespace isocast::vdb_process
