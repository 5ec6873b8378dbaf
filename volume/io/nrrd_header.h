// The text header of NRRD files.
#pragma once

#include <isocast/math/transform.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isocast {

/// One axis as the header tells it; NaN: not told.
struct NrrdAxis {
  std::int64_t size = 0;
  double spacing = std::numeric_limits<double>::quiet_NaN();
  double min = std::numeric_limits<double>::quiet_NaN(), max = std::numeric_limits<double>::quiet_NaN();
  bool cell_centered = false;
  std::optional<Double3> direction;  // space directions, nothing for "none"
};

/// The fields that matter to a reader of scalar volumes; the others are skipped. slope and intercept come
/// from the keys isocast_slope and isocast_intercept.
struct NrrdHeader {
  std::string type, encoding, data_file;
  std::optional<bool> big_endian;
  std::vector<NrrdAxis> axes;  // fastest first
  bool has_directions = false;
  Double3 origin = {0, 0, 0};
  std::int64_t line_skip = 0, byte_skip = 0;
  double slope = 1, intercept = 0;
  std::size_t bytes = 0;  // of the header, with the empty line that ends it
  bool ended = false;     // by an empty line: samples may follow
};

/// Parses the header at the start of `text` (magic NRRD0001 to NRRD0005). Throws InputError with the path and
/// the line.
[[nodiscard]] NrrdHeader parse_nrrd_header(std::string_view text, const std::filesystem::path& path);

}  // namespace isocast
