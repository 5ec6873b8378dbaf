// Compressed bytes as a stream of plain ones.
#pragma once

#include <isocast/base/error.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

struct z_stream_s;

namespace isocast {

/// Reads on in a zlib stream or in gzip members that follow one another, told apart by their first bytes.
/// `compressed` must outlive it. Memory does not depend on what the stream holds.
class Inflater {
 public:
  Inflater(std::span<const std::byte> compressed, std::filesystem::path path);
  ~Inflater();
  Inflater& operator=(const Inflater&) = delete;

  /// Fills `out`, returns the bytes filled: fewer where the stream ends. Throws InputError (with the path and
  /// the position) when the stream is damaged.
  std::size_t read(std::span<std::byte> out);
  /// Reads `bytes` and forgets them, returns how many there were.
  std::uint64_t skip(std::uint64_t bytes);
  /// How many of the next `bytes` bytes there are; the stream stays where it is.
  [[nodiscard]] std::uint64_t count_ahead(std::uint64_t bytes) const;
  [[nodiscard]] std::uint64_t compressed_bytes() const { return compressed_.size(); }

 private:
  Inflater(const Inflater& other);
  [[nodiscard]] InputError damage() const;
  void finish_member();

  std::span<const std::byte> compressed_;
  std::size_t fed_ = 0;  // bytes handed to zlib
  std::filesystem::path path_;
  std::unique_ptr<z_stream_s> stream_;
  bool finished_ = false;
};

}  // namespace isocast
