#include <fmt/format.h>
#include <isocast/base/interrupt.h>
#include <isocast/base/progress.h>
#include <isocast/base/text.h>
#include <isocast/volume/io/base64.h>
#include <isocast/volume/io/byte_order.h>
#include <isocast/volume/io/header_text.h>
#include <isocast/volume/io/samples.h>
#include <isocast/volume/io/vti_array.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

namespace isocast {
namespace {

// The array's bytes from its start on: those of the file, or as many as asked for out of base64.
class ArrayBytes {
 public:
  ArrayBytes(const VtiArray& array, const std::filesystem::path& path) : array_(array), path_(path) {}

  // At most `count` bytes, fewer where the array ends; valid until the next call.
  std::span<const std::byte> first(std::uint64_t count) {
    if (array_.encoding == VtiEncoding::raw)
      return {reinterpret_cast<const std::byte*>(array_.text.data()),
              std::min<std::uint64_t>(count, array_.text.size())};
    decoded_ = decode_base64(array_.text, count, path_);
    return decoded_;
  }

  // The first `count` of the words that stand before the samples.
  std::vector<std::uint64_t> words(std::uint64_t count) {
    const std::size_t width = array_.wide_words ? 8 : 4;
    const std::span<const std::byte> bytes =
        count <= array_.text.size() / width ? first(count * width) : std::span<const std::byte>{};
    if (bytes.size() < count * width)
      throw read_error(path_, fmt::format("the data array ends inside its header of {} words", count));
    std::vector<std::uint64_t> words(count);
    for (std::size_t i = 0; i < count; ++i)
      words[i] = array_.wide_words ? load_number<std::uint64_t>(&bytes[i * width], array_.big_endian)
                                   : load_number<std::uint32_t>(&bytes[i * width], array_.big_endian);
    return words;
  }

 private:
  const VtiArray& array_;
  const std::filesystem::path& path_;
  std::vector<std::byte> decoded_;
};

// Layout: [bytes] samples.
void read_plain(Volume& volume, const VtiArray& array, const MappedFile& file,
                const std::filesystem::path& path) {
  ArrayBytes source(array, path);
  const std::uint64_t expected = checked_bytes(volume, path), stated = source.words(1)[0];
  if (stated < expected) throw missing_samples(volume, stated, path);
  const std::uint64_t header = array.wide_words ? 8 : 4;
  if (array.encoding == VtiEncoding::raw) {
    const auto begin = reinterpret_cast<const std::byte*>(array.text.data()) - file.bytes.data();
    return place_samples(volume, file, static_cast<std::uint64_t>(begin) + header, array.big_endian, path);
  }
  const std::span<const std::byte> bytes = source.first(header + expected);
  if (bytes.size() < header + expected) throw missing_samples(volume, bytes.size() - header, path);
  copy_to_native(bytes.subspan(header), allocate_samples(volume, path), size_of(volume.type),
                 array.big_endian);
}

// Layout: [blocks] [bytes of a plain block] [plain bytes of the last one if shorter, or 0] [compressed bytes
// of each] blocks.
struct Blocks {
  std::uint64_t plain_size = 0;
  std::vector<std::uint64_t> begin;  // in the array, and the end of the last

  [[nodiscard]] std::uint64_t count() const { return begin.size() - 1; }
};

Blocks read_block_table(ArrayBytes& source, bool wide_words, const std::filesystem::path& path) {
  // the table: the array itself bounds its length
  const std::vector<std::uint64_t> head = source.words(3);
  const std::uint64_t count = head[0];
  if (count > std::numeric_limits<std::uint64_t>::max() - 3)
    throw read_error(path, fmt::format("the data array claims {} blocks", count));
  const std::vector<std::uint64_t> words = source.words(count + 3);

  Blocks blocks;
  blocks.plain_size = head[1];
  blocks.begin.push_back(words.size() * (wide_words ? 8 : 4));
  for (std::uint64_t i = 0; i < count; ++i) {
    std::uint64_t end = 0;
    if (__builtin_add_overflow(blocks.begin.back(), words[3 + i], &end))
      throw read_error(path, fmt::format("block {} of the data array claims {} bytes", i, words[3 + i]));
    blocks.begin.push_back(end);
  }
  return blocks;
}

void read_blocks(Volume& volume, const VtiArray& array, const std::filesystem::path& path) {
  ArrayBytes source(array, path);
  const std::uint64_t expected = checked_bytes(volume, path);
  const Blocks blocks = read_block_table(source, array.wide_words, path);

  // enough blocks, all of them there, and not too much in them
  const std::uint64_t needed = blocks.plain_size == 0 ? 0 : (expected - 1) / blocks.plain_size + 1;
  if (needed == 0 || needed > blocks.count())
    throw missing_samples(volume, blocks.count() * blocks.plain_size, path);
  const std::uint64_t end = blocks.begin[needed];
  const std::span<const std::byte> bytes = source.first(end);
  if (bytes.size() < end)
    throw read_error(path, fmt::format("expected {} bytes of compressed data, found {}", end, bytes.size()));
  check_ratio(checked_bytes(volume, path), end - blocks.begin[0], path);

  // each block to its place, the later ones of many after a look into all of them
  std::byte* const samples = allocate_samples(volume, path);
  Progress progress("inflating", static_cast<std::int64_t>(needed));
  const auto read_block = [&](std::uint64_t b, bool keep) {
    throw_if_interrupted();
    Inflater inflater(bytes.subspan(blocks.begin[b], blocks.begin[b + 1] - blocks.begin[b]), path);
    const std::uint64_t plain = std::min(blocks.plain_size, expected - b * blocks.plain_size);
    const std::uint64_t found =
        keep ? inflater.read({samples + b * blocks.plain_size, plain}) : inflater.skip(plain);
    if (found < plain)
      throw read_error(
          path, fmt::format("block {} of the data array holds {} bytes, expected {}", b, found, plain));
    inflater.skip(1);  // compares the block's checksum
    if (keep) progress.add();
  };
  using oneapi::tbb::parallel_for;
  const std::uint64_t early = std::min(needed, kept_unseen(end) / blocks.plain_size);
  parallel_for(std::uint64_t(0), early, [&](std::uint64_t b) { read_block(b, true); });
  parallel_for(early, needed, [&](std::uint64_t b) { read_block(b, false); });
  parallel_for(early, needed, [&](std::uint64_t b) { read_block(b, true); });
  copy_to_native({samples, expected}, samples, size_of(volume.type), array.big_endian);
}

// One number as a sample; integers must fit.
template <class S> std::optional<S> to_sample(std::string_view word) {
  if constexpr (std::is_floating_point_v<S>) {
    const std::optional<double> number = to_number<double>(word);
    return number ? std::optional<S>(static_cast<S>(*number)) : std::nullopt;
  } else {
    const std::optional<std::int64_t> number = to_number<std::int64_t>(word);
    return number && std::in_range<S>(*number) ? std::optional<S>(static_cast<S>(*number)) : std::nullopt;
  }
}

void read_ascii(Volume& volume, const VtiArray& array, const std::filesystem::path& path) {
  // a number and the blank behind it are at least two characters
  const std::uint64_t count = checked_bytes(volume, path) / size_of(volume.type),
                      most = (array.text.size() + 1) / 2;
  if (count > most)
    throw read_error(path,
                     fmt::format("expected {} numbers in the data array, found at most {}", count, most));
  std::byte* const samples = allocate_samples(volume, path);
  visit_sample_type(volume.type, [&]<class S>(SampleTag<S>) {
    if constexpr (!std::is_same_v<S, Half>) {
      std::string_view rest = trimmed(array.text);
      for (std::uint64_t i = 0; i < count; ++i) {
        if (i % 1000000 == 0) throw_if_interrupted();
        const std::string_view word = rest.substr(0, std::min(rest.find_first_of(" \t\r\n"), rest.size()));
        if (word.empty())
          throw read_error(path, fmt::format("expected {} numbers in the data array, found {}", count, i));
        const std::optional<S> sample = to_sample<S>(word);
        if (!sample)
          throw read_error(path, fmt::format("number {} of the data array is {}, expected one of type {}", i,
                                             in_quotes(word), name_of(volume.type)));
        std::memcpy(samples + i * sizeof(S), &*sample, sizeof(S));
        rest.remove_prefix(word.size());
        rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
      }
    }
  });
}

}  // namespace

void read_vti_array(Volume& volume, const VtiArray& array, const MappedFile& file,
                    const std::filesystem::path& path) {
  if (array.encoding == VtiEncoding::ascii) read_ascii(volume, array, path);
  else if (array.compressed) read_blocks(volume, array, path);
  else read_plain(volume, array, file, path);
  check_mapped_files();
}

}  // namespace isocast
