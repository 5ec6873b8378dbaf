#include <fmt/format.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/viewer/command_line.h>
#include <isocast/volume/io/type_words.h>

namespace isocast::viewer {
namespace {

std::string quoted(const std::string& word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string text(1, '\'');
  for (const char c : word) c == '\'' ? text.append("'\\''") : text.append(1, c);
  return text.append(1, '\'');
}

// The words of the line so far.
class Line {
 public:
  explicit Line(std::string start) : text_(std::move(start)) {}
  void add(const char* option, const std::string& value, const std::string& otherwise = "") {
    if (value != otherwise) text_ += fmt::format(" {} {}", option, quoted(value));
  }
  void add(const char* option, const std::vector<std::string>& values) {
    for (const std::string& value : values) add(option, value);
  }
  void add(const char* option, const std::optional<int>& value) {
    if (value) text_ += fmt::format(" {} {}", option, *value);
  }
  void flag(const char* option, bool set) {
    if (set) text_ += fmt::format(" {}", option);
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void add_reading(const ReadOptions& read, Line& line) {
  if (read.dims)
    line.add("--dims", fmt::format("{},{},{}", (*read.dims)[0], (*read.dims)[1], (*read.dims)[2]));
  if (read.type) line.add("--type", std::string(name_of(*read.type)));
  line.add("--endian", read.big_endian ? "big" : "");
  line.add("--skip", read.skip ? fmt::format("{}", read.skip) : "");
  line.add("--grid", read.grid);
}

}  // namespace

std::string command_line(const RenderWords& words, const std::string& output) {
  const RenderWords plain;
  Line line("isocast render " + quoted(typed_formula(words.input)));
  add_reading(words.read, line);
  line.add("--iso", words.iso);
  line.add("--param", words.params);
  line.add("--domain", words.domain);
  line.add("--time", words.time);
  line.add("--frames", words.frames);
  line.add("--method", words.method, plain.method);
  line.add("--set", words.set);
  line.add("--precision", words.precision, plain.precision);
  line.add("--normals", words.normals, plain.normals);
  line.add("--clip", words.clips);
  line.add("--colors", words.colors);
  line.flag("--color-components", words.by_component);
  line.add("--opacity", words.opacity);
  line.add("--transparency-depth", words.transparency_depth);
  line.add("--reflectivity", words.reflectivity);
  line.add("--reflections", words.reflections);
  line.add("--environment", words.environment);
  line.add("--light", words.lights);
  line.flag("--shadows", words.shadows);
  if (words.ambient_occlusion > 0) line.add("--ambient-occlusion", std::optional(words.ambient_occlusion));
  line.add("--ambient-occlusion-radius", words.ambient_occlusion_radius);
  line.add("--camera", words.camera);
  line.add("--camera-position", words.position);
  line.add("--camera-target", words.target);
  line.add("--camera-up", words.up);
  line.add("--fov", words.fov);
  line.add("--ortho", words.ortho);
  line.add("--size", words.size);
  line.add("--spp", words.spp);
  line.add("--filter", words.filter, plain.filter);
  line.add("--aa", words.aa);
  line.add("-o", output);
  return line.text();
}

}  // namespace isocast::viewer
