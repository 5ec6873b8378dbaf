#include <fmt/format.h>
#include <isocast/apps/scene_build/color_by.h>
#include <isocast/apps/scene_build/scene_json.h>
#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>
#include <isocast/implicit/expression/evaluate.h>
#include <isocast/implicit/expression/simplify.h>
#include <isocast/implicit/register_memory.h>
#include <isocast/isa/cpu.h>
#include <isocast/math/elementary.h>
#include <isocast/scene/srgb.h>
#include <isocast/volume/volume_sampler.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace isocast {
namespace {

// Values along a range, looked up in a map.
class MappedField final : public ColorField {
 public:
  using Value = std::function<double(const Double3&)>;
  MappedField(Value value, ColorMap map, const std::array<double, 2>& range, bool logarithmic,
              const Color& nan_color)
      : value_(std::move(value)), map_(std::move(map)), logarithmic_(logarithmic), nan_color_(nan_color) {
    lo_ = scaled(range[0]);
    size_ = scaled(range[1]) - lo_;
  }
  void find_colors(std::span<const Double3> points, std::span<Color> colors) const override {
    const DefaultFloatEnvironment environment;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double value = scaled(value_(points[i]));
      colors[i] = std::isnan(value) ? nan_color_ : map_.at((value - lo_) / size_);
    }
  }

 private:
  [[nodiscard]] double scaled(double value) const {
    if (!logarithmic_) return value;
    return value > 0 ? log(value) : std::nan("");
  }

  Value value_;
  ColorMap map_;
  double lo_, size_;
  bool logarithmic_;
  Color nan_color_;
};

struct OpenField {
  MappedField::Value value;
  std::array<double, 2> range;
};

OpenField open(const VolumeSource& source, VolumeLibrary& library) {
  const VolumeSampler sampler(library.get(source));
  const auto statistics = library.statistics(source);
  return {[sampler](const Double3& p) { return sampler.value_at(p); }, {statistics->min, statistics->max}};
}

OpenField open(const FormulaSource& source, VolumeLibrary& /*library*/) {
  const auto tape = std::make_shared<const Tape>(make_tape(simplify(source.expression)));
  return {[tape, time = source.time](const Double3& p) {
            const double inputs[4] = {p[0], p[1], p[2], time};
            return evaluate(tape->view(), inputs,
                            static_cast<double*>(registers_of(tape->registers * sizeof(double))));
          },
          {-1, 1}};
}

}  // namespace

std::shared_ptr<const ColorField> make_color_field(const ColorBy& description, VolumeLibrary& library) {
  ColorMap map = read_color_map(description.map);
  OpenField field = std::visit([&](const auto& source) { return open(source, library); }, description.field);
  std::array<double, 2> range = description.range.value_or(field.range);
  if (description.logarithmic && !(range[0] > 0)) range[0] = range[1] * 1e-6;
  if (!(range[0] < range[1])) {
    if (description.logarithmic)
      throw InputError(
          fmt::format("color_by with log: found values up to {}, expected some above 0", range[1]));
    range[1] = range[0] + 1;  // a constant field
  }
  const Color nan_color = description.nan_color.value_or(map.at(std::nan("")));
  return std::make_shared<MappedField>(std::move(field.value), std::move(map), range, description.logarithmic,
                                       nan_color);
}

ColorMap read_color_map(const std::string& name) {
  if (!name.ends_with(".json")) return color_map_from_name(name);
  const MappedFile file = map_file(name);
  const SceneJson json =
      parse_scene_json({reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()}, name);
  check_mapped_files();
  const auto fail = [&](const std::string& what) {
    throw InputError(fmt::format(
        "{}: {}, expected a colour map of ParaView: [{{\"RGBPoints\": [x, r, g, b, ...]}}]", name, what));
  };
  const SceneJson& map = json.is_array() && !json.empty() ? json[0] : json;
  if (!map.is_object() || !map.contains("RGBPoints") || !map["RGBPoints"].is_array())
    fail("found no RGBPoints");
  const SceneJson& numbers = map["RGBPoints"];
  constexpr std::size_t kMost = 1 << 16;
  if (numbers.size() % 4 != 0 || numbers.size() < 8 || numbers.size() > 4 * kMost)
    fail(fmt::format("found {} numbers", numbers.size()));
  const auto is_number = [](const SceneJson& number) { return number.is_number(); };
  if (!std::ranges::all_of(numbers, is_number)) fail("found something other than a number in RGBPoints");
  const auto color_at = [](const SceneJson& list, std::size_t i) {
    std::array<double, 3> srgb;
    for (std::size_t c = 0; c < 3; ++c) srgb[c] = std::clamp(list[i + c].get<double>(), 0.0, 1.0);
    return srgb;
  };
  std::vector<ColorPoint> points;
  const double first = numbers[0], last = numbers[numbers.size() - 4];
  if (!(first < last)) fail(fmt::format("found points from {} to {}", first, last));
  for (std::size_t i = 0; i < numbers.size(); i += 4) {
    const ColorPoint point{(numbers[i].get<double>() - first) / (last - first), color_at(numbers, i + 1)};
    if (!(point.x >= 0 && point.x <= 1) || (!points.empty() && point.x < points.back().x))
      fail("found points that do not rise");
    points.push_back(point);
  }
  if (!map.contains("NanColor")) return ColorMap(std::move(points));
  const SceneJson& nan = map["NanColor"];
  if (!nan.is_array() || nan.size() != 3 || !std::ranges::all_of(nan, is_number))
    fail("found a NanColor that is not three numbers");
  Color color;
  for (std::size_t c = 0; c < 3; ++c) color[c] = static_cast<float>(linear_from_srgb(color_at(nan, 0)[c]));
  return ColorMap(std::move(points), color);
}

}  // namespace isocast
