#include <fmt/format.h>
#include <isocast/base/text.h>
#include <isocast/volume/io/header_text.h>
#include <isocast/volume/io/metaimage.h>
#include <isocast/volume/io/samples.h>
#include <isocast/volume/io/type_words.h>

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <map>

namespace isocast {
namespace {

// The fields that matter to a reader of scalar volumes; the others are skipped.
constexpr std::string_view kKnown[] = {"ObjectType",
                                       "NDims",
                                       "DimSize",
                                       "BinaryData",
                                       "BinaryDataByteOrderMSB",
                                       "ElementByteOrderMSB",
                                       "CompressedData",
                                       "CompressedDataSize",
                                       "HeaderSize",
                                       "TransformMatrix",
                                       "Rotation",
                                       "Orientation",
                                       "Offset",
                                       "Position",
                                       "Origin",
                                       "ElementSpacing",
                                       "ElementSize",
                                       "ElementNumberOfChannels",
                                       "ElementToIntensityFunctionSlope",
                                       "ElementToIntensityFunctionOffset",
                                       "ElementType",
                                       "ElementDataFile"};

struct Field {
  int line;
  std::string_view value;
};

// Fields by name, up to ElementDataFile; asked for by the names that mean the same, best first.
struct Header {
  using Names = std::initializer_list<std::string_view>;

  const std::filesystem::path& path;
  std::map<std::string_view, Field> fields;
  std::size_t bytes = 0;  // with the line of ElementDataFile

  [[nodiscard]] InputError unexpected(std::string_view name, std::string_view expected) const {
    const Field& field = fields.at(name);
    return read_error(path, fmt::format("line {}: field '{}' has the value {}, expected {}", field.line, name,
                                        in_quotes(field.value), expected));
  }
  // The name that is there; empty if none is.
  [[nodiscard]] std::string_view present(Names names) const {
    const auto found =
        std::ranges::find_if(names, [&](std::string_view name) { return fields.contains(name); });
    return found == names.end() ? std::string_view{} : *found;
  }
  [[nodiscard]] std::string_view required(std::string_view name) const {
    if (!fields.contains(name)) throw read_error(path, fmt::format("its header has no field '{}'", name));
    return fields.at(name).value;
  }
  [[nodiscard]] bool flag(Names names, bool fallback) const {
    const std::string_view name = present(names);
    if (name.empty()) return fallback;
    const std::string word = lower_case(fields.at(name).value);
    if (word != "true" && word != "false" && word != "1" && word != "0")
      throw unexpected(name, "True or False");
    return word == "true" || word == "1";
  }
  [[nodiscard]] std::int64_t whole(std::string_view name, std::int64_t fallback, std::int64_t least,
                                   std::int64_t most = std::numeric_limits<std::int64_t>::max()) const {
    if (!fields.contains(name)) return fallback;
    const auto number = to_number<std::int64_t>(fields.at(name).value);
    if (!number || *number < least || *number > most)
      throw unexpected(
          name, least == most ? fmt::format("{}", most) : fmt::format("a whole number from {} on", least));
    return *number;
  }
  [[nodiscard]] std::optional<std::vector<double>> numbers(Names names, std::size_t count) const {
    const std::string_view name = present(names);
    if (name.empty()) return std::nullopt;
    auto values = to_numbers<double>(fields.at(name).value, count);
    if (!values) throw unexpected(name, fmt::format("{} numbers", count));
    return values;
  }
};

Header parse_header(std::string_view text, const std::filesystem::path& path) {
  Header header{path, {}};
  for (int line = 1; header.bytes < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', header.bytes), text.size());
    const std::string_view content = trimmed(text.substr(header.bytes, end - header.bytes));
    header.bytes = std::min(end + 1, text.size());
    if (content.empty()) continue;
    const std::size_t separator = content.find_first_of("=:");
    if (separator == content.npos)
      throw read_error(path,
                       fmt::format("line {}: found {}, expected 'Name = value'", line, in_quotes(content)));
    const std::string_view name = trimmed(content.substr(0, separator));
    if (std::ranges::find(kKnown, name) == std::end(kKnown)) continue;
    constexpr std::size_t kLongest = 4096;
    if (content.size() > kLongest)
      throw read_error(path,
                       fmt::format("line {}: field '{}' is longer than {} characters", line, name, kLongest));
    header.fields[name] = {line, trimmed(content.substr(separator + 1))};
    if (name == "ElementDataFile") return header;
  }
  if (text.empty()) throw read_error(path, "it is empty, expected a MetaImage header");
  throw read_error(path, "its header has no field 'ElementDataFile'");
}

void read_dims(Volume& volume, const Header& header, std::size_t rank) {
  const auto dims = to_numbers<std::int64_t>(header.required("DimSize"), rank);
  if (!dims || std::ranges::any_of(*dims, [](std::int64_t n) { return n < 1; }))
    throw header.unexpected("DimSize", fmt::format("{} whole numbers from 1 on", rank));
  if (rank == 4 && dims->back() != 1) throw header.unexpected("DimSize", "a fourth dimension of 1");
  std::copy_n(dims->begin(), 3, volume.dims.begin());
}

Transform world_from_grid(const Header& header, std::size_t rank) {
  const auto matrix = header.numbers({"TransformMatrix", "Rotation", "Orientation"}, rank * rank);
  const auto offset = header.numbers({"Offset", "Position", "Origin"}, rank);
  const auto spacing = header.numbers({"ElementSpacing", "ElementSize"}, rank);
  Transform transform;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t a = 0; a < 3; ++a)
      transform.m[r][a] = (matrix ? (*matrix)[a * rank + r] : a == r) * (spacing ? (*spacing)[a] : 1);
    transform.m[r][3] = offset ? (*offset)[r] : 0;
  }
  return transform;
}

// `begin`: the first byte behind the header, where the file has one; HeaderSize replaces it, -1: the samples
// are the last bytes.
void read_samples(Volume& volume, const Header& header, const MappedFile& file, std::uint64_t begin,
                  const std::filesystem::path& path) {
  const bool big_endian = header.flag({"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}, false),
             compressed = header.flag({"CompressedData"}, false);
  const std::int64_t skip = header.whole("HeaderSize", 0, -1);
  if (skip < 0 && compressed) throw header.unexpected("HeaderSize", "0 or more for compressed data");
  if (skip < 0) return place_last_samples(volume, file, begin, big_endian, path);
  const std::uint64_t offset = skip > 0 ? static_cast<std::uint64_t>(skip) : begin;
  if (!compressed) return place_samples(volume, file, offset, big_endian, path);

  // the stream's size is a help that may be missing, or 0
  const std::span<const std::byte> rest =
      file.bytes.subspan(std::min<std::uint64_t>(offset, file.bytes.size()));
  const auto stated = static_cast<std::uint64_t>(header.whole("CompressedDataSize", 0, 0));
  if (stated > rest.size())
    throw read_error(path,
                     fmt::format("expected {} bytes of compressed data, found {}", stated, rest.size()));
  Inflater inflater(stated > 0 ? rest.first(stated) : rest, path);
  inflate_samples(volume, inflater, 0, big_endian, path);
}

}  // namespace

Volume read_metaimage(const std::filesystem::path& path) {
  const MappedFile file = map_file(path);
  const Header header =
      parse_header({reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()}, path);

  // what is none of ours
  if (header.fields.contains("ObjectType") && header.required("ObjectType") != "Image")
    throw header.unexpected("ObjectType", "Image");
  if (!header.flag({"BinaryData"}, true)) throw header.unexpected("BinaryData", "True");
  (void)header.whole("ElementNumberOfChannels", 1, 1, 1);
  const std::string_view type = header.required("ElementType"), rank = header.required("NDims");
  if (!type.starts_with("MET_")) throw header.unexpected("ElementType", "a type like MET_SHORT");
  if (rank != "3" && rank != "4") throw header.unexpected("NDims", "3, or 4 with a last dimension of 1");

  // the description
  const std::size_t axes = rank == "3" ? 3 : 4;
  Volume volume;
  volume.format = "metaimage";
  volume.type = sample_type_from_word(type, "cannot read " + path.string());
  read_dims(volume, header, axes);
  volume.world_from_grid = world_from_grid(header, axes);
  volume.slope = header.numbers({"ElementToIntensityFunctionSlope"}, 1).value_or(std::vector{1.0})[0];
  volume.intercept = header.numbers({"ElementToIntensityFunctionOffset"}, 1).value_or(std::vector{0.0})[0];

  // the samples
  const std::string_view data = header.required("ElementDataFile");
  if (lower_case(data) == "local") {
    read_samples(volume, header, file, header.bytes, path);
  } else {
    const std::filesystem::path source = data_file_beside(path, data);
    read_samples(volume, header, map_file(source), 0, source);
  }
  return volume;
}

}  // namespace isocast
