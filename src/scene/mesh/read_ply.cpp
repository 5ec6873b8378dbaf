#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>
#include <isocast/base/text.h>
#include <isocast/scene/mesh/mesh.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <sstream>
#include <string_view>

namespace isocast {
namespace {

enum class Type : std::uint8_t { none, i8, u8, i16, u16, i32, u32, f32, f64 };

Type type_of(std::string_view word) {
  static constexpr struct {
    std::string_view name;
    Type type;
  } names[] = {{"char", Type::i8},   {"int8", Type::i8},     {"uchar", Type::u8},   {"uint8", Type::u8},
               {"short", Type::i16}, {"int16", Type::i16},   {"ushort", Type::u16}, {"uint16", Type::u16},
               {"int", Type::i32},   {"int32", Type::i32},   {"uint", Type::u32},   {"uint32", Type::u32},
               {"float", Type::f32}, {"float32", Type::f32}, {"double", Type::f64}, {"float64", Type::f64}};
  for (const auto& [name, type] : names)
    if (name == word) return type;
  return Type::none;
}
std::size_t size_of(Type type) {
  constexpr std::size_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<int>(type)];
}

// A list has a type for its length.
struct Property {
  std::string name;
  Type type, length = Type::none;
};
struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

class PlyReader {
 public:
  PlyReader(const std::filesystem::path& path, std::string_view bytes) : path_(path), bytes_(bytes) {}

  Mesh read() {
    read_header();
    for (const Element& element : elements_) read_element(element);
    if (mesh_.normals.size() != mesh_.positions.size()) mesh_.normals.clear();
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}: byte {}: {}", path_.string(), at_, what));
  }
  std::vector<std::string> header_line() {
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string_view::npos || end - at_ > 4096)
      fail("the header does not end, expected end_header");
    std::istringstream line{std::string(bytes_.substr(at_, end - at_))};
    std::vector<std::string> words;
    for (std::string word; line >> word;) words.push_back(word);
    at_ = end + 1;
    return words;
  }
  void read_header() {
    if (!bytes_.starts_with("ply\n") && !bytes_.starts_with("ply\r\n"))
      fail("found no 'ply', expected a PLY file");
    for (header_line();;) {
      const std::vector<std::string> words = header_line();
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") break;
      if (words[0] == "format" && words.size() == 3) read_format(words);
      else if (words[0] == "element" && words.size() == 3) add_element(words);
      else if (words[0] == "property" && !elements_.empty()) add_property(words);
      else
        fail(fmt::format("found {} in the header, expected format, element, property or end_header",
                         in_quotes(words[0])));
      if (elements_.size() > 100) fail("found more than 100 elements");
    }
    if (!known_format_) fail("the header names no format");
  }
  void read_format(const std::vector<std::string>& words) {
    ascii_ = words[1] == "ascii";
    const bool big = words[1] == "binary_big_endian";
    if (!ascii_ && !big && words[1] != "binary_little_endian")
      fail(fmt::format("found the format {}, expected ascii, binary_little_endian or binary_big_endian",
                       in_quotes(words[1])));
    swap_ = big != (std::endian::native == std::endian::big);
    known_format_ = true;
  }
  void add_element(const std::vector<std::string>& words) {
    Element element{words[1], 0, {}};
    const char* const end = words[2].data() + words[2].size();
    if (const auto [to, error] = std::from_chars(words[2].data(), end, element.count);
        error != std::errc() || to != end)
      fail(fmt::format("found the count {}, expected a number", in_quotes(words[2])));
    // whatever it is, it takes a byte
    if (element.count > bytes_.size())
      fail(
          fmt::format("found {} times {}, more than the file has bytes", element.count, in_quotes(words[1])));
    elements_.push_back(std::move(element));
  }
  void add_property(const std::vector<std::string>& words) {
    Property property{words.back(), Type::none};
    const bool list = words.size() == 5 && words[1] == "list";
    if (list) property.length = type_of(words[2]), property.type = type_of(words[3]);
    else if (words.size() == 3) property.type = type_of(words[1]);
    const bool whole_length = property.length != Type::f32 && property.length != Type::f64;
    if (property.type == Type::none || (list && property.length == Type::none) || !whole_length)
      fail("found a property without a known type, such as 'float' or 'list uchar int'");
    elements_.back().properties.push_back(std::move(property));
    if (elements_.back().properties.size() > 1000) fail("found more than 1000 properties");
  }

  double next(Type type) { return ascii_ ? next_word() : next_number(type); }
  double next_word() {
    while (at_ < bytes_.size() && static_cast<unsigned char>(bytes_[at_]) <= ' ') ++at_;
    double value = 0;
    const char* const begin = bytes_.data() + at_;
    const auto [end, error] = std::from_chars(begin, bytes_.data() + bytes_.size(), value);
    if (error != std::errc())
      fail(at_ < bytes_.size() ? "expected a number" : "the file ends, expected a number");
    at_ += static_cast<std::size_t>(end - begin);
    return value;
  }
  template <class T> double number_at(const unsigned char* bytes) const {
    unsigned char own[sizeof(T)];
    std::copy_n(bytes, sizeof(T), own);
    if (swap_) std::reverse(own, own + sizeof(T));
    T value;
    std::memcpy(&value, own, sizeof(T));
    return static_cast<double>(value);
  }
  double next_number(Type type) {
    const std::size_t size = size_of(type);
    if (bytes_.size() - at_ < size) fail("the file ends, expected a number");
    const auto* const bytes = reinterpret_cast<const unsigned char*>(bytes_.data()) + at_;
    at_ += size;
    switch (type) {
      case Type::i8: return number_at<std::int8_t>(bytes);
      case Type::u8: return number_at<std::uint8_t>(bytes);
      case Type::i16: return number_at<std::int16_t>(bytes);
      case Type::u16: return number_at<std::uint16_t>(bytes);
      case Type::i32: return number_at<std::int32_t>(bytes);
      case Type::u32: return number_at<std::uint32_t>(bytes);
      case Type::f32: return number_at<float>(bytes);
      default: return number_at<double>(bytes);
    }
  }
  std::uint64_t next_length(Type type) {
    const double length = next(type);
    if (!(length >= 0 && length <= static_cast<double>(bytes_.size() - at_)))
      fail(fmt::format("found a list of {}, more than the file has bytes left", length));
    return static_cast<std::uint64_t>(length);
  }

  void read_element(const Element& element) {
    if (element.properties.empty()) return;
    const bool vertices = element.name == "vertex", faces = element.name == "face";
    if (vertices) prepare_vertices(element);
    for (std::uint64_t i = 0; i < element.count; ++i)
      for (std::size_t p = 0; p < element.properties.size(); ++p) {
        const Property& property = element.properties[p];
        const bool corners = faces && property.length != Type::none &&
                             (property.name == "vertex_indices" || property.name == "vertex_index");
        if (corners) read_face(property);
        else if (property.length != Type::none)
          for (std::uint64_t left = next_length(property.length); left > 0; --left) (void)next(property.type);
        else if (const double value = next(property.type); vertices) set(places_[p], value);
      }
  }
  // Where each property of a vertex goes: 0 to 2 position, 3 to 5 normal, -1 nowhere.
  void prepare_vertices(const Element& element) {
    if (element.count >= kMostVertices) fail("found too many vertices");
    static constexpr std::string_view names[] = {"x", "y", "z", "nx", "ny", "nz"};
    int found = 0;
    places_.clear();
    for (const Property& property : element.properties) {
      const auto name = std::ranges::find(names, property.name);
      const bool known = name != std::end(names) && property.length == Type::none;
      places_.push_back(known ? static_cast<int>(name - names) : -1);
      if (known) found |= 1 << (name - names);
    }
    if ((found & 7) != 7) fail("found no x, y and z of vertices");
    const std::uint64_t plausible = std::min<std::uint64_t>(element.count, (bytes_.size() - at_) / 3);
    mesh_.positions.reserve(plausible);
    has_normals_ = (found & 56) == 56;
    if (has_normals_) mesh_.normals.reserve(plausible);
  }
  // Numbers of a vertex come in the order of its properties; the first one of each begins it.
  void set(int place, double value) {
    if (place < 0) return;
    if (place < 3) {
      if (set_positions_++ % 3 == 0) mesh_.positions.emplace_back();
      mesh_.positions.back()[place] = value;
    } else if (has_normals_) {
      if (set_normals_++ % 3 == 0) mesh_.normals.emplace_back();
      mesh_.normals.back()[place - 3] = static_cast<float>(value);
    }
  }
  void read_face(const Property& property) {
    const std::uint64_t corners = next_length(property.length);
    if (corners < 3) fail(fmt::format("found a face of {} corners, expected three or more", corners));
    std::uint32_t first = 0, last = 0;
    for (std::uint64_t k = 0; k < corners; ++k) {
      const double index = next(property.type);
      if (!(index >= 0 && index < static_cast<double>(kMostVertices) && index == std::floor(index)))
        fail(fmt::format("found the corner {}, expected the number of a vertex", index));
      const auto vertex = static_cast<std::uint32_t>(index);
      if (k == 0) first = vertex;
      if (k >= 2) mesh_.triangles.push_back({first, last, vertex});
      last = vertex;
    }
    if (mesh_.triangles.size() > kMostTriangles) fail("found too many triangles");
  }

  const std::filesystem::path& path_;
  std::string_view bytes_;
  std::size_t at_ = 0;
  bool ascii_ = false, swap_ = false, known_format_ = false, has_normals_ = false;
  std::uint64_t set_positions_ = 0, set_normals_ = 0;
  std::vector<Element> elements_;
  std::vector<int> places_;
  Mesh mesh_;
};

}  // namespace

Mesh read_ply(const std::filesystem::path& path) {
  const MappedFile file = map_file(path);
  Mesh mesh = PlyReader(path, {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()}).read();
  check_mapped_files();
  return mesh;
}

}  // namespace isocast
