// Bytes as formats pack them: numbers, zlib and gzip streams, base64.
#pragma once

#include <cstring>
#include <string>

namespace isocast::hostile {

/// One number, little-endian.
template <class N> std::string number(N value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

/// `repeats` times `plain`, compressed.
[[nodiscard]] std::string zlib(const std::string& plain, int repeats = 1);
[[nodiscard]] std::string gzip(const std::string& plain, int repeats = 1);
[[nodiscard]] std::string base64(const std::string& plain);

}  // namespace isocast::hostile
