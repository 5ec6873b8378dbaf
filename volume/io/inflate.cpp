#include <fmt/format.h>
#include <isocast/base/interrupt.h>
#include <isocast/base/mapped_file.h>
#include <isocast/volume/io/header_text.h>
#include <isocast/volume/io/inflate.h>
#include <zlib.h>

#include <algorithm>
#include <new>

namespace isocast {

Inflater::Inflater(std::span<const std::byte> compressed, std::filesystem::path path)
    : compressed_(compressed), path_(std::move(path)), stream_(std::make_unique<z_stream_s>()) {
  constexpr int kZlibOrGzip = 15 + 32;
  if (inflateInit2(stream_.get(), kZlibOrGzip) != Z_OK) throw std::bad_alloc();
}

Inflater::Inflater(const Inflater& other)
    : compressed_(other.compressed_),
      fed_(other.fed_),
      path_(other.path_),
      stream_(std::make_unique<z_stream_s>()),
      finished_(other.finished_) {
  if (inflateCopy(stream_.get(), other.stream_.get()) != Z_OK) throw std::bad_alloc();
}

Inflater::~Inflater() { inflateEnd(stream_.get()); }

std::size_t Inflater::read(std::span<std::byte> out) {
  constexpr std::size_t kChunk = std::size_t(16) << 20;
  std::size_t filled = 0;
  while (filled < out.size() && !finished_) {
    throw_if_interrupted();

    // zlib counts in 32 bits: both sides go in chunks
    if (stream_->avail_in == 0) {
      const std::size_t chunk = std::min(kChunk, compressed_.size() - fed_);
      stream_->next_in = reinterpret_cast<Bytef*>(const_cast<std::byte*>(compressed_.data() + fed_));
      stream_->avail_in = static_cast<uInt>(chunk);
      fed_ += chunk;
    }
    const std::size_t room = std::min(kChunk, out.size() - filled);
    stream_->next_out = reinterpret_cast<Bytef*>(out.data() + filled);
    stream_->avail_out = static_cast<uInt>(room);

    // the input's end inside a stream counts as the stream's end: the caller knows what is missing
    const int code = inflate(stream_.get(), Z_NO_FLUSH);
    filled += room - stream_->avail_out;
    if (code == Z_STREAM_END) finish_member();
    else if (code == Z_BUF_ERROR && fed_ == compressed_.size()) finished_ = true;
    else if (code != Z_OK && code != Z_BUF_ERROR) throw damage();
  }
  return filled;
}

std::uint64_t Inflater::skip(std::uint64_t bytes) {
  std::byte ignored[4096];
  std::uint64_t skipped = 0;
  while (skipped < bytes && !finished_)
    skipped +=
        read({ignored, static_cast<std::size_t>(std::min<std::uint64_t>(sizeof ignored, bytes - skipped))});
  return skipped;
}

std::uint64_t Inflater::count_ahead(std::uint64_t bytes) const { return Inflater(*this).skip(bytes); }

InputError Inflater::damage() const {
  check_mapped_files();  // zeros of a file that shrank are no fault of the stream
  return read_error(
      path_, fmt::format("the compressed data is damaged near its byte {} ({})", fed_ - stream_->avail_in,
                         stream_->msg ? stream_->msg : "not a zlib or gzip stream"));
}

void Inflater::finish_member() {
  const std::span<const std::byte> rest = compressed_.subspan(fed_ - stream_->avail_in);
  const bool another = rest.size() >= 2 && rest[0] == std::byte(0x1f) && rest[1] == std::byte(0x8b);
  finished_ = !another || inflateReset(stream_.get()) != Z_OK;
}

}  // namespace isocast
