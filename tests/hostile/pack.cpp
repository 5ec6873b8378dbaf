#include "pack.h"

#include <zlib.h>

#include <cstdint>

namespace isocast::hostile {
namespace {

std::string deflated(const std::string& plain, int repeats, int window_bits) {
  z_stream stream = {};
  deflateInit2(&stream, 1, Z_DEFLATED, window_bits, 8, Z_DEFAULT_STRATEGY);
  std::string out, piece(std::size_t(1) << 16, '\0');
  for (int n = 1; n <= repeats; ++n) {
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(plain.data()));
    stream.avail_in = static_cast<uInt>(plain.size());
    do {
      stream.next_out = reinterpret_cast<Bytef*>(piece.data());
      stream.avail_out = static_cast<uInt>(piece.size());
      deflate(&stream, n == repeats ? Z_FINISH : Z_NO_FLUSH);
      out.append(piece, 0, piece.size() - stream.avail_out);
    } while (stream.avail_out == 0);
  }
  deflateEnd(&stream);
  return out;
}

}  // namespace

std::string zlib(const std::string& plain, int repeats) { return deflated(plain, repeats, 15); }
std::string gzip(const std::string& plain, int repeats) { return deflated(plain, repeats, 15 + 16); }

std::string base64(const std::string& plain) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < plain.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t b = 0; b < 3; ++b)
      group = group << 8 | (i + b < plain.size() ? static_cast<std::uint8_t>(plain[i + b]) : 0u);
    for (std::size_t d = 0; d < 4; ++d)
      text += i + d > plain.size() ? '=' : kDigits[group >> (18 - 6 * d) & 63];
  }
  return text;
}

}  // namespace isocast::hostile
