#include <fmt/format.h>
#include <isocast/base/text.h>
#include <isocast/volume/io/header_text.h>
#include <isocast/volume/io/nrrd.h>
#include <isocast/volume/io/nrrd_header.h>
#include <isocast/volume/io/samples.h>
#include <isocast/volume/io/type_words.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace isocast {
namespace {

// Drops an axis of size 1 from four: one without a direction if there is a choice, else the last.
std::vector<NrrdAxis> three_axes(const NrrdHeader& header, const std::filesystem::path& path) {
  std::vector<NrrdAxis> axes = header.axes;
  if (axes.size() == 3) return axes;
  const bool first = axes[0].size == 1, last = axes[3].size == 1;
  if (!first && !last)
    throw read_error(
        path, fmt::format("its four axes have sizes {} {} {} {}, expected the first or the last to be 1",
                          axes[0].size, axes[1].size, axes[2].size, axes[3].size));
  const bool drop_first = first && (!last || (!axes[0].direction && axes[3].direction));
  axes.erase(drop_first ? axes.begin() : axes.end() - 1);
  return axes;
}

// Axes along x, y, z: the distance of samples, and where the first one is.
void place_on_axis(const NrrdAxis& axis, int a, Transform& world_from_grid) {
  const double steps = static_cast<double>(axis.cell_centered ? axis.size : axis.size - 1);
  double spacing = axis.spacing;
  if (std::isnan(spacing))
    spacing = std::isnan(axis.max - axis.min) || steps == 0 ? 1 : (axis.max - axis.min) / steps;
  world_from_grid.m[a][a] = spacing;
  world_from_grid.m[a][3] = std::isnan(axis.min) ? 0 : axis.min + (axis.cell_centered ? spacing / 2 : 0);
}

Transform world_from_grid(const NrrdHeader& header, const std::vector<NrrdAxis>& axes,
                          const std::filesystem::path& path) {
  Transform transform;
  for (int a = 0; a < 3; ++a) {
    if (!header.has_directions) {
      place_on_axis(axes[a], a, transform);
      continue;
    }
    if (!axes[a].direction) throw read_error(path, fmt::format("axis {} has no space direction", a));
    for (int r = 0; r < 3; ++r) transform.m[r][a] = (*axes[a].direction)[r];
    transform.m[a][3] = header.origin[a];
  }
  return transform;
}

// Where the samples' encoding begins: behind the header and the lines to skip.
std::uint64_t data_offset(const NrrdHeader& header, std::span<const std::byte> bytes,
                          const std::filesystem::path& path) {
  std::uint64_t offset = header.data_file.empty() ? header.bytes : 0;
  for (std::int64_t line = 0; line < header.line_skip; ++line) {
    const void* end =
        offset < bytes.size() ? std::memchr(bytes.data() + offset, '\n', bytes.size() - offset) : nullptr;
    if (!end)
      throw read_error(path, fmt::format("it ends after {} of the {} lines to skip", line, header.line_skip));
    offset = static_cast<std::uint64_t>(static_cast<const std::byte*>(end) - bytes.data()) + 1;
  }
  return offset;
}

// Bytes to skip count in the plain data; -1: the samples are the last bytes of a raw file.
void read_samples(Volume& volume, const NrrdHeader& header, const MappedFile& file,
                  const std::filesystem::path& path) {
  const std::uint64_t offset = data_offset(header, file.bytes, path);
  const bool big_endian = header.big_endian.value_or(false);
  if (header.encoding == "raw") {
    if (header.byte_skip < 0) return place_last_samples(volume, file, offset, big_endian, path);
    return place_samples(volume, file, offset + static_cast<std::uint64_t>(header.byte_skip), big_endian,
                         path);
  }
  if (header.encoding != "gzip" && header.encoding != "gz")
    throw read_error(
        path, "the encoding " + in_quotes(header.encoding) + " is not supported, expected raw or gzip");
  if (header.byte_skip < 0) throw read_error(path, "a byte skip of -1 needs the encoding raw");
  Inflater inflater(file.bytes.subspan(offset), path);
  inflate_samples(volume, inflater, static_cast<std::uint64_t>(header.byte_skip), big_endian, path);
}

}  // namespace

Volume read_nrrd(const std::filesystem::path& path) {
  const MappedFile file = map_file(path);
  const NrrdHeader header =
      parse_nrrd_header({reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()}, path);

  // the description
  Volume volume;
  volume.format = "nrrd";
  volume.type = sample_type_from_word(header.type, "cannot read " + path.string());
  if (volume.type == SampleType::f16)
    throw read_error(path, "NRRD has no type f16, the nearest that is possible is f32");
  if (size_of(volume.type) > 1 && !header.big_endian)
    throw read_error(path, "its header has no field 'endian'");
  const std::vector<NrrdAxis> axes = three_axes(header, path);
  for (int a = 0; a < 3; ++a) volume.dims[a] = axes[a].size;
  volume.world_from_grid = world_from_grid(header, axes, path);
  volume.slope = header.slope;
  volume.intercept = header.intercept;

  // the samples
  if (!header.data_file.empty()) {
    const std::filesystem::path source = data_file_beside(path, header.data_file);
    read_samples(volume, header, map_file(source), source);
  } else {
    if (!header.ended)
      throw read_error(path, "its header names no data file and does not end with an empty line");
    read_samples(volume, header, file, path);
  }
  return volume;
}

}  // namespace isocast
