#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>
#include <isocast/base/text.h>
#include <isocast/scene/mesh/mesh.h>

#include <charconv>
#include <limits>
#include <string_view>
#include <unordered_map>

namespace isocast {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Line by line; corners with a normal of their own become vertices of their own.
class ObjReader {
 public:
  ObjReader(const std::filesystem::path& path, std::string_view text) : path_(path), text_(text) {}

  Mesh read() {
    while (!text_.empty()) {
      ++line_;
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      read_line(text_.substr(0, end));
      text_.remove_prefix(std::min(end + 1, text_.size()));
    }
    if (any_normal_) {
      // corners without a normal leave the mesh without any
      if (normals_of_.size() == mesh_.positions.size())
        for (const std::uint32_t normal : normals_of_) {
          if (normal == kNone || normal >= normals_.size()) {
            mesh_.normals.clear();
            break;
          }
          mesh_.normals.push_back(normals_[normal]);
        }
    }
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", path_.string(), line_, what));
  }
  static std::string_view next_word(std::string_view& line) {
    const std::size_t begin = std::min(line.find_first_not_of(" \t\r"), line.size());
    line.remove_prefix(begin);
    const std::size_t end = std::min(line.find_first_of(" \t\r"), line.size());
    const std::string_view word = line.substr(0, end);
    line.remove_prefix(end);
    return word;
  }
  template <class T> T number(std::string_view word) const {
    T value = 0;
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
      fail(fmt::format("found {}, expected a number", in_quotes(word)));
    return value;
  }
  void read_line(std::string_view line) {
    const std::string_view key = next_word(line);
    if (key == "v") {
      Double3 p;
      for (double& x : p) x = number<double>(next_word(line));
      positions_.push_back(p);
    } else if (key == "vn") {
      std::array<float, 3> n;
      for (float& x : n) x = static_cast<float>(number<double>(next_word(line)));
      normals_.push_back(n);
    } else if (key == "f") {
      read_face(line);
    }
  }
  // Counted from 1, or backwards from -1.
  [[nodiscard]] std::uint32_t index(std::string_view word, std::size_t count, const char* what) const {
    const auto i = number<std::int64_t>(word);
    const std::int64_t at = i > 0 ? i - 1 : static_cast<std::int64_t>(count) + i;
    if (i == 0 || at < 0 || at >= static_cast<std::int64_t>(count))
      fail(fmt::format("found the {} {}, expected one of the {} so far", what, i, count));
    return static_cast<std::uint32_t>(at);
  }
  void read_face(std::string_view line) {
    std::uint32_t first = 0, last = 0;
    for (int corner = 0;; ++corner) {
      const std::string_view word = next_word(line);
      if (word.empty()) {
        if (corner < 3) fail(fmt::format("found a face of {} corners, expected three or more", corner));
        return;
      }
      const std::uint32_t vertex = corner_of(word);
      if (corner == 0) first = vertex;
      if (corner >= 2) mesh_.triangles.push_back({first, last, vertex});
      last = vertex;
      if (mesh_.triangles.size() > kMostTriangles) fail("found too many triangles");
    }
  }
  // "7", "7/1", "7//3" or "7/1/3" to a vertex of the mesh.
  std::uint32_t corner_of(std::string_view word) {
    const std::size_t slash = std::min(word.find('/'), word.size()), second = word.find('/', slash + 1);
    const std::uint32_t position = index(word.substr(0, slash), positions_.size(), "vertex");
    std::uint32_t normal = kNone;
    if (slash < word.size() && second != std::string_view::npos && second + 1 < word.size())
      normal = index(word.substr(second + 1), normals_.size(), "normal");
    any_normal_ = any_normal_ || normal != kNone;
    const std::uint64_t pair = std::uint64_t{position} << 32 | normal;
    const auto [found, fresh] =
        vertex_of_.try_emplace(pair, static_cast<std::uint32_t>(mesh_.positions.size()));
    if (fresh) {
      if (mesh_.positions.size() >= kMostVertices) fail("found too many vertices");
      mesh_.positions.push_back(positions_[position]);
      normals_of_.push_back(normal);
    }
    return found->second;
  }

  const std::filesystem::path& path_;
  std::string_view text_;
  std::size_t line_ = 0;
  std::vector<Double3> positions_;
  std::vector<std::array<float, 3>> normals_;
  std::unordered_map<std::uint64_t, std::uint32_t> vertex_of_;
  std::vector<std::uint32_t> normals_of_;
  bool any_normal_ = false;
  Mesh mesh_;
};

}  // namespace

Mesh read_obj(const std::filesystem::path& path) {
  const MappedFile file = map_file(path);
  Mesh mesh = ObjReader(path, {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()}).read();
  check_mapped_files();
  return mesh;
}

}  // namespace isocast
