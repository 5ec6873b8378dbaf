#include <fmt/format.h>
#include <isocast/base/text.h>
#include <isocast/volume/io/vdb_header.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <string_view>

namespace isocast {
namespace {

// Little-endian fields one after the other, never behind the end.
class Fields {
 public:
  Fields(std::span<const std::byte> file, std::uint64_t at) : file_(file), at_(at) {}

  [[nodiscard]] std::uint64_t at() const { return at_; }
  std::span<const std::byte> bytes(std::uint64_t count, const char* what) {
    if (at_ > file_.size() || count > file_.size() - at_)
      throw std::runtime_error(
          fmt::format("it ends at byte {} inside {}, which takes {} bytes from byte {} on", file_.size(),
                      what, count, at_));
    const auto found = file_.subspan(at_, count);
    at_ += count;
    return found;
  }
  template <class N> N number(const char* what) {
    N value;
    std::memcpy(&value, bytes(sizeof value, what).data(), sizeof value);
    return value;
  }
  std::string text(const char* what) {
    const auto found = bytes(number<std::uint32_t>(what), what);
    return {reinterpret_cast<const char*>(found.data()), found.size()};
  }

 private:
  std::span<const std::byte> file_;
  std::uint64_t at_;
};

std::map<std::string, std::string> read_metadata(Fields& fields) {
  std::map<std::string, std::string> found;
  const auto count = fields.number<std::uint32_t>("the number of metadata");
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::string name = fields.text("a metadata name"), type = fields.text("a metadata type");
    const auto size = fields.number<std::uint32_t>("the size of metadata");
    const auto value = fields.bytes(size, "metadata");
    if (type == "string") found[name].assign(reinterpret_cast<const char*>(value.data()), value.size());
    if (type == "bool" && size == 1) found[name] = value[0] == std::byte(0) ? "false" : "true";
  }
  return found;
}

// "Tree_float_5_4_3_HalfFloat" to "float" and true.
void set_type(VdbGridHeader& grid, std::string type) {
  constexpr std::string_view kHalf = "_HalfFloat", kTree = "Tree_", kShape = "_5_4_3";
  grid.half = type.ends_with(kHalf);
  if (grid.half) type.resize(type.size() - kHalf.size());
  const bool standard = type.starts_with(kTree) && type.ends_with(kShape);
  grid.value_type = standard ? type.substr(kTree.size(), type.size() - kTree.size() - kShape.size()) : type;
}

// Where names repeat, a number stands behind them.
std::string shown_name(const std::string& unique) { return unique.substr(0, unique.find('\x1e')); }

// What stands at the beginning of a grid's own bytes.
void read_grid(std::span<const std::byte> file, VdbGridHeader& grid) {
  Fields fields(file, grid.begin);
  grid.compression = fields.number<std::uint32_t>("a grid's compression");
  grid.metadata = read_metadata(fields);
  grid.map_at = fields.at();
  grid.map_type = fields.text("the name of a transform");
}

}  // namespace

VdbHeader read_vdb_header(std::span<const std::byte> file) {
  constexpr std::uint64_t kMagic = 0x56444220;
  constexpr std::uint32_t kOldest = 222, kNewest = 224;
  VdbHeader header;
  Fields fields(file, 0);
  if (const auto magic = fields.number<std::uint64_t>("the magic number"); magic != kMagic)
    throw std::runtime_error(
        fmt::format("it starts with {:#x}, expected OpenVDB's magic number {:#x}", magic, kMagic));
  header.format = fields.number<std::uint32_t>("the version");
  if (header.format < kOldest || header.format > kNewest)
    throw std::runtime_error(fmt::format("its format is number {}, expected {} to {} (OpenVDB 1.1 to 10)",
                                         header.format, kOldest, kNewest));
  header.library_major = fields.number<std::uint32_t>("the version");
  header.library_minor = fields.number<std::uint32_t>("the version");
  const bool has_places = fields.number<std::uint8_t>("the header") != 0;
  fields.bytes(36, "the identifier");
  read_metadata(fields);

  const auto count = fields.number<std::int32_t>("the number of grids");
  if (count < 1) throw std::runtime_error(fmt::format("it has {} grids, expected at least one", count));
  for (std::int32_t i = 0; i < count; ++i) {
    VdbGridHeader grid;
    grid.name = shown_name(fields.text("a grid's name"));
    set_type(grid, fields.text("a grid's type"));
    grid.parent = shown_name(fields.text("the name of a grid's parent"));
    grid.begin = fields.number<std::uint64_t>("a grid's place");
    fields.number<std::uint64_t>("a grid's place");
    grid.end = fields.number<std::uint64_t>("a grid's place");
    // each grid follows its description; in what was written as a stream, no place tells where the next one
    // is
    if (!has_places) {
      grid.begin = fields.at();
      grid.end = file.size();
    }
    if (grid.begin < fields.at() || grid.begin > grid.end || grid.end > file.size())
      throw std::runtime_error(fmt::format("its grid {} lies at bytes {} to {}, the file ends at byte {}",
                                           in_quotes(grid.name), grid.begin, grid.end, file.size()));
    read_grid(file, grid);
    fields = Fields(file, grid.end);
    header.grids.push_back(std::move(grid));
    if (!has_places) break;
  }
  return header;
}

}  // namespace isocast
