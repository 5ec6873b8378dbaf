#include <fmt/format.h>
#include <isocast/base/text.h>
#include <isocast/volume/io/header_text.h>
#include <isocast/volume/io/samples.h>
#include <isocast/volume/io/type_words.h>
#include <isocast/volume/io/vti.h>
#include <isocast/volume/io/vti_array.h>

#include <algorithm>
#include <pugixml.hpp>

namespace isocast {
namespace {

// The XML without the appended data, which may be gigabytes and no XML at all.
struct VtiDocument {
  std::string head;  // parsed in place
  pugi::xml_document xml;
  std::string_view appended;  // behind the underscore, to the end of the file
};

void parse_document(VtiDocument& document, std::string_view text, const std::filesystem::path& path) {
  // cut after the tag that opens the appended data, then close what is open
  std::string& head = document.head;
  head = text.substr(0, text.find("<AppendedData"));
  if (head.size() < text.size()) {
    const std::size_t tag_end = text.find('>', head.size());
    if (tag_end == text.npos) throw read_error(path, "its element AppendedData is cut short");
    const std::size_t underscore = text.find_first_not_of(" \t\r\n", tag_end + 1);
    if (underscore == text.npos || text[underscore] != '_')
      throw read_error(path, "its appended data does not start with an underscore");
    document.appended = text.substr(underscore + 1);
    head += text.substr(head.size(), tag_end + 1 - head.size());
    head += "</AppendedData></VTKFile>";
  }
  // each costs many times its bytes
  constexpr std::ptrdiff_t kMostMarks = 1'000'000;
  const auto marks = std::ranges::count_if(head, [](char c) { return c == '<' || c == '='; });
  if (marks > kMostMarks)
    throw read_error(
        path, fmt::format("its XML has {} elements and attributes, expected at most {}", marks, kMostMarks));
  if (trimmed(head).empty()) throw read_error(path, "it is empty, expected a VTKFile element");
  const pugi::xml_parse_result result =
      document.xml.load_buffer_inplace(head.data(), head.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!result)
    throw read_error(path,
                     fmt::format("its XML is damaged at byte {}: {}", result.offset, result.description()));
}

template <class N>
std::vector<N> numbers_of(pugi::xml_node node, const char* name, std::size_t count, const char* fallback,
                          const std::filesystem::path& path) {
  const char* text = node.attribute(name).as_string(fallback);
  const auto numbers = to_numbers<N>(text, count);
  if (!numbers)
    throw read_error(path, fmt::format("attribute {} of {} is {}, expected {} numbers", name, node.name(),
                                       in_quotes(text), count));
  return *numbers;
}

// The piece's extent gives the dimensions, and where its first sample lies.
void read_geometry(Volume& volume, pugi::xml_node image, pugi::xml_node piece,
                   const std::filesystem::path& path) {
  const auto extent = numbers_of<std::int64_t>(piece, "Extent", 6, "", path);
  const auto origin = numbers_of<double>(image, "Origin", 3, "0 0 0", path);
  const auto spacing = numbers_of<double>(image, "Spacing", 3, "1 1 1", path);
  const auto direction = numbers_of<double>(image, "Direction", 9, "1 0 0 0 1 0 0 0 1", path);
  Transform image_from_grid, world_from_image;
  for (int a = 0; a < 3; ++a) {
    const std::int64_t lo = extent[2 * a], hi = extent[2 * a + 1];
    constexpr std::int64_t kMost = std::int64_t(1) << 40;
    if (lo < -kMost || hi > kMost || hi < lo)
      throw read_error(path, fmt::format("the piece's Extent runs from {} to {} on axis {}", lo, hi, a));
    volume.dims[a] = hi - lo + 1;
    image_from_grid.m[a][a] = spacing[a];
    image_from_grid.m[a][3] = spacing[a] * static_cast<double>(lo);
    for (int c = 0; c < 3; ++c) world_from_image.m[a][c] = direction[3 * a + c];
    world_from_image.m[a][3] = origin[a];
  }
  volume.world_from_grid = world_from_image * image_from_grid;
}

// The array named by Scalars, else the first of one component.
pugi::xml_node find_scalars(pugi::xml_node piece, const std::filesystem::path& path) {
  const auto components = [](pugi::xml_node array) {
    return array.attribute("NumberOfComponents").as_llong(1);
  };
  const pugi::xml_node points = piece.child("PointData");
  const pugi::xml_node first = points.child("DataArray");
  if (!first && piece.child("CellData").child("DataArray"))
    throw read_error(path, "it has data for cells only, expected an array of point data");
  if (!first) throw read_error(path, "it has no array of point data");
  const std::string active = points.attribute("Scalars").as_string();
  pugi::xml_node array = first;
  if (!active.empty()) {
    array = points.find_child_by_attribute("DataArray", "Name", active.c_str());
    if (!array)
      throw read_error(path, "its point data has no array " + in_quotes(active) + ", which Scalars names");
  } else {
    while (components(array) != 1 && array.next_sibling("DataArray")) array = array.next_sibling("DataArray");
  }
  if (components(array) != 1)
    throw read_error(path, fmt::format("the array {} has {} components, expected scalars",
                                       in_quotes(array.attribute("Name").as_string()), components(array)));
  return array;
}

// Where the array's bytes are and how they are written.
VtiArray locate_array(const VtiDocument& document, pugi::xml_node array, const std::filesystem::path& path) {
  const pugi::xml_node file = document.xml.child("VTKFile");
  const auto choice = [&](pugi::xml_node node, const char* name, std::string_view fallback,
                          std::string_view first, std::string_view second) {
    const std::string_view value = node.attribute(name).as_string(fallback.data());
    if (value != first && value != second)
      throw read_error(path, fmt::format("attribute {} of {} is {}, expected {} or {}", name, node.name(),
                                         in_quotes(value), first, second));
    return value == second;
  };
  VtiArray found;
  found.big_endian = choice(file, "byte_order", "LittleEndian", "LittleEndian", "BigEndian");
  found.wide_words = choice(file, "header_type", "UInt32", "UInt32", "UInt64");
  const std::string_view compressor = file.attribute("compressor").as_string();
  found.compressed = !compressor.empty();
  if (found.compressed && compressor != "vtkZLibDataCompressor")
    throw read_error(path, fmt::format("the compressor {} is not supported, expected vtkZLibDataCompressor",
                                       in_quotes(compressor)));

  // inline
  const std::string_view format = array.attribute("format").as_string();
  if (format == "ascii" || format == "binary") {
    found.encoding = format == "ascii" ? VtiEncoding::ascii : VtiEncoding::base64;
    found.text = array.text().get();
    return found;
  }
  if (format != "appended")
    throw read_error(path,
                     fmt::format("attribute format of DataArray is {}, expected ascii, binary or appended",
                                 in_quotes(format)));

  // appended: raw runs to the end of the file, base64 to the closing tag
  const pugi::xml_node appended = file.child("AppendedData");
  if (!appended) throw read_error(path, "its array is appended, but it has no element AppendedData");
  found.encoding =
      choice(appended, "encoding", "base64", "base64", "raw") ? VtiEncoding::raw : VtiEncoding::base64;
  const std::string_view data = found.encoding == VtiEncoding::raw
                                    ? document.appended
                                    : document.appended.substr(0, document.appended.find('<'));
  const std::string_view offset_text = array.attribute("offset").as_string();
  const auto offset = to_number<std::uint64_t>(offset_text);
  if (!offset || *offset > data.size())
    throw read_error(path, fmt::format("attribute offset of DataArray is {}, expected a number up to {}",
                                       in_quotes(offset_text), data.size()));
  found.text = data.substr(*offset);
  return found;
}

}  // namespace

Volume read_vti(const std::filesystem::path& path) {
  const MappedFile file = map_file(path);
  VtiDocument document;
  parse_document(document, {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()}, path);
  const pugi::xml_node root = document.xml.child("VTKFile"), image = root.child("ImageData"),
                       piece = image.child("Piece");
  if (!image) throw read_error(path, "it has no element ImageData inside VTKFile");
  if (!piece || piece.next_sibling("Piece"))
    throw read_error(path, "expected exactly one element Piece in ImageData");

  // the description, then the samples
  Volume volume;
  volume.format = "vti";
  read_geometry(volume, image, piece, path);
  const pugi::xml_node array = find_scalars(piece, path);
  volume.type = sample_type_from_word(array.attribute("type").as_string(), "cannot read " + path.string());
  if (volume.type == SampleType::f16)
    throw read_error(path, "VTI has no type f16, the nearest that is possible is f32");
  read_vti_array(volume, locate_array(document, array, path), file, path);
  return volume;
}

}  // namespace isocast
