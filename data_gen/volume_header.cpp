#include <fmt/format.h>
#include <isocast/data_gen/volume_header.h>

#include <limits>
#include <type_traits>

namespace isocast {
namespace {

// Blanks for a comment in a header of so many bytes without them.
std::string padding(std::size_t bytes) {
  constexpr std::size_t kAlignment = 64;
  return std::string((kAlignment - bytes % kAlignment) % kAlignment, ' ');
}

// By SampleType.
constexpr std::string_view kNrrdNames[] = {"uint8", "int8", "uint16", "int16", "uint32",
                                           "int32", "",     "float",  "double"};
constexpr std::string_view kMetaImageNames[] = {
    "MET_UCHAR", "MET_CHAR", "MET_USHORT", "MET_SHORT", "MET_UINT", "MET_INT", "", "MET_FLOAT", "MET_DOUBLE"};

}  // namespace

IntegerRange integer_range(SampleType type) {
  return visit_sample_type(type, []<class S>(SampleTag<S>) {
    if constexpr (std::is_integral_v<S>)
      return IntegerRange{double(std::numeric_limits<S>::lowest()), double(std::numeric_limits<S>::max())};
    else return IntegerRange{};
  });
}

std::string nrrd_header(const StoredVolume& volume) {
  const SampleGrid& grid = volume.grid;
  std::string header = fmt::format(
      "NRRD0005\n# sampled by isocast\ntype: {}\ndimension: 3\nspace dimension: 3\nsizes: {} {} {}\nendian: "
      "little\n"
      "encoding: raw\nspace directions: ({},0,0) (0,{},0) (0,0,{})\nspace origin: ({},{},{})\n",
      kNrrdNames[int(volume.type)], grid.dims[0], grid.dims[1], grid.dims[2], grid.spacing(0),
      grid.spacing(1), grid.spacing(2), grid.domain.lo[0], grid.domain.lo[1], grid.domain.lo[2]);
  if (!is_float(volume.type)) {
    const auto [lowest, largest] = integer_range(volume.type);
    header += fmt::format("old min: {}\nold max: {}\nisocast_slope:={}\nisocast_intercept:={}\n",
                          volume.slope * lowest + volume.intercept, volume.slope * largest + volume.intercept,
                          volume.slope, volume.intercept);
  }
  constexpr std::size_t kFollowing = 3;  // "#" and two line ends
  return header + "#" + padding(header.size() + kFollowing) + "\n\n";
}

std::string metaimage_header(const StoredVolume& volume) {
  const SampleGrid& grid = volume.grid;
  const std::string start = "ObjectType = Image\nNDims = 3\nComment = sampled by isocast";
  std::string rest = fmt::format(
      "\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = False\n"
      "TransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = {} {} {}\nElementSpacing = {} {} {}\nDimSize = {} {} "
      "{}\n",
      grid.domain.lo[0], grid.domain.lo[1], grid.domain.lo[2], grid.spacing(0), grid.spacing(1),
      grid.spacing(2), grid.dims[0], grid.dims[1], grid.dims[2]);
  if (!is_float(volume.type))
    rest += fmt::format("ElementToIntensityFunctionSlope = {}\nElementToIntensityFunctionOffset = {}\n",
                        volume.slope, volume.intercept);
  rest += fmt::format("ElementType = {}\nElementDataFile = LOCAL\n", kMetaImageNames[int(volume.type)]);
  return start + padding(start.size() + rest.size()) + rest;
}

}  // namespace isocast
