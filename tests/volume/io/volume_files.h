// Volume files made by tests: a folder that goes away, bytes in either order, compressed bytes, and the error
// of a bad file.
#pragma once

#include <isocast/base/error.h>
#include <isocast/volume/io/read_volume.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace isocast::test {

/// A folder of its own below the system's temporary one, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "isocast_test_XXXXXX").string();
    REQUIRE(mkdtemp(name.data()));
    path_ = name;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  /// Writes a file into the folder.
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::ofstream(path_ / name, std::ios::binary) << content;
    return path_ / name;
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// One number's bytes.
template <class N> std::string bytes_of(N value, bool big_endian = false) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  if (big_endian) std::ranges::reverse(bytes);
  return bytes;
}
template <class N> std::string bytes_of(const std::vector<N>& values, bool big_endian = false) {
  std::string bytes;
  for (const N& value : values) bytes += bytes_of(value, big_endian);
  return bytes;
}

/// `count` values of the type, its extremes among them.
template <class S> std::vector<S> pattern(std::size_t count) {
  std::vector<S> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = static_cast<S>(7 * i % 101);
  values.front() = std::numeric_limits<S>::lowest();
  values.back() = std::numeric_limits<S>::max();
  return values;
}

/// Bytes that do not compress.
inline std::string noise(std::size_t count) {
  std::mt19937 random(1);
  std::string bytes(count, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random());
  return bytes;
}

inline std::string deflated(const std::string& plain, int window_bits) {
  z_stream stream = {};
  REQUIRE(deflateInit2(&stream, 9, Z_DEFLATED, window_bits, 8, Z_DEFAULT_STRATEGY) == Z_OK);
  std::string out(deflateBound(&stream, plain.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(plain.data()));
  stream.avail_in = static_cast<uInt>(plain.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  REQUIRE(deflate(&stream, Z_FINISH) == Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}
inline std::string gzip(const std::string& plain) { return deflated(plain, 15 + 16); }
inline std::string zlib(const std::string& plain) { return deflated(plain, 15); }

template <class S> std::vector<S> samples_of(const Volume& volume) {
  REQUIRE(size_of(volume.type) == sizeof(S));
  std::vector<S> samples(static_cast<std::size_t>(volume.count()));
  std::memcpy(samples.data(), volume.samples, samples.size() * sizeof(S));
  return samples;
}

/// The sentence with which reading fails; empty if it does not.
inline std::string error_of(const std::filesystem::path& path, const ReadOptions& options = {}) {
  try {
    (void)read_volume(path, options);
  } catch (const InputError& error) { return error.what(); }
  return {};
}

/// `text` with the first `from` replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != text.npos);
  return text.replace(at, from.size(), to);
}

template <class S> constexpr SampleType kTypeOf = SampleType::u8;
template <> inline constexpr SampleType kTypeOf<std::int8_t> = SampleType::i8;
template <> inline constexpr SampleType kTypeOf<std::uint16_t> = SampleType::u16;
template <> inline constexpr SampleType kTypeOf<std::int16_t> = SampleType::i16;
template <> inline constexpr SampleType kTypeOf<std::uint32_t> = SampleType::u32;
template <> inline constexpr SampleType kTypeOf<std::int32_t> = SampleType::i32;
template <> inline constexpr SampleType kTypeOf<float> = SampleType::f32;
template <> inline constexpr SampleType kTypeOf<double> = SampleType::f64;

}  // namespace isocast::test

/// The sample types that every format has.
#define ISO_FILE_SAMPLE_TYPES \
  std::uint8_t, std::int8_t, std::uint16_t, std::int16_t, std::uint32_t, std::int32_t, float, double
