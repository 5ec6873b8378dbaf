#include <fmt/format.h>
#include <isocast/apps/scene_build/formula_input.h>
#include <isocast/apps/scene_build/placement.h>
#include <isocast/apps/scene_build/scene_objects.h>
#include <isocast/base/error.h>
#include <isocast/scene/color_map.h>
#include <isocast/volume/io/type_words.h>

#include <algorithm>

namespace isocast {
namespace {

Parameters parameters_of(const SceneJson& value) {
  Parameters parameters;
  if (value.contains("params"))
    for (const auto& [name, number] : value["params"].items())
      parameters.push_back({name, shortest_constant(number.get<double>())});
  return parameters;
}

SolidDescription clip_from_json(const SceneJson& value, const std::string& path,
                                const SceneContext& context) {
  const auto fail = [&](const std::string& what) {
    throw InputError(fmt::format("{}: {}: {}", context.source, path, what));
  };
  const int kinds = value.contains("plane") + value.contains("box") + value.contains("formula");
  if (kinds != 1) fail(fmt::format("found {} of plane, box and formula, expected one", kinds));
  std::string text;
  if (value.contains("plane")) text = plane_formula(value["plane"].get<std::array<double, 4>>());
  if (value.contains("box"))
    text = box_formula(point_from_json(value["box"][0]), point_from_json(value["box"][1]));
  if (value.contains("formula")) text = value["formula"];
  SolidDescription solid{{}, context.time};
  try {
    solid.formula = parse_expression(text, parameters_of(value));
  } catch (const InputError& error) { fail(error.what()); }
  return solid;
}

// One object while it is read: knows where it stands in the file.
class ObjectReader {
 public:
  ObjectReader(const SceneJson& value, const std::string& path, const SceneContext& context)
      : value_(value), path_(path), context_(context) {}

  ObjectDescription read() {
    ObjectDescription object;
    object.name = value_.value("name", "");
    object.visible = value_.value("visible", true);
    if (value_.contains("time")) object.time = value_["time"].get<double>();
    object.source = read_source();
    object.iso = numbers("iso");
    object.method = value_.value("method", "auto");
    for (const auto& [name, setting] : list("set").items())
      object.settings[name] =
          setting.is_string() ? setting.get<std::string>() : fmt::format("{}", setting.get<double>());
    object.normals = normals_from(value_.value("normals", "gradient"));
    object.by_component = value_.value("color_components", false);
    if (value_.contains("material")) object.materials = read_material(value_["material"]);
    if (value_.contains("transform")) object.place = in_place("transform", value_["transform"]);
    object.clips = clips_from_json(list("clip"), path_ + ".clip", {context_.source, context_.folder, time()});
    if (value_.contains("color_by")) object.color_by = read_color_by(value_["color_by"]);
    return object;
  }

 private:
  using Source = decltype(ObjectDescription::source);

  [[noreturn]] void fail(const std::string& path, const std::string& what) const {
    throw InputError(fmt::format("{}: {}: {}", context_.source, path, what));
  }
  // What a message of a reader below says, with the place in the file.
  template <class Read> auto at(const std::string& key, Read read) const {
    try {
      return read();
    } catch (const InputError& error) { fail(path_ + "." + key, error.what()); }
  }
  [[nodiscard]] const SceneJson& list(const char* key) const {
    static const SceneJson nothing;
    return value_.contains(key) ? value_[key] : nothing;
  }
  [[nodiscard]] static std::vector<double> numbers_of(const SceneJson& value) {
    if (value.is_null()) return {};
    return value.is_number() ? std::vector{value.get<double>()} : value.get<std::vector<double>>();
  }
  [[nodiscard]] std::vector<double> numbers(const char* key) const { return numbers_of(list(key)); }
  [[nodiscard]] std::filesystem::path file(const SceneJson& value) const {
    return context_.folder / value["file"].get<std::string>();
  }
  [[nodiscard]] double time() const { return value_.value("time", context_.time); }

  Source read_source() {
    const std::string type = value_["type"];
    if (type == "volume") return read_volume_source(value_);
    if (type == "mesh") return MeshSource{file(value_)};
    if (type == "csg") return read_csg();
    if (type == "instance") return read_instances();
    return type == "formula" ? read_formula_source("expr", value_["expr"])
                             : read_formula_source("id", fmt::format("@{}", value_["id"].get<std::string>()));
  }
  [[nodiscard]] VolumeSource read_volume_source(const SceneJson& value) const {
    VolumeSource volume;
    volume.file = file(value);
    if (value.contains("dims")) volume.read.dims = value["dims"].get<std::array<std::int64_t, 3>>();
    if (value.contains("sample_type"))
      volume.read.type = sample_type_from_word(value["sample_type"].get<std::string>(), path_);
    volume.read.big_endian = value.value("endian", "little") == "big";
    volume.read.skip = value.value("skip", std::uint64_t{0});
    volume.read.grid = value.value("grid", "");
    return volume;
  }
  [[nodiscard]] FormulaSource read_formula_source(const char* key, const std::string& text) const {
    FormulaRequest request{text, parameters_of(value_), {}};
    if (text.ends_with(".vm")) request.text = (context_.folder / text).string();
    if (value_.contains("domain")) request.domain = read_domain(value_["domain"]);
    FormulaInput input = at(key, [&] { return read_formula(request); });
    return {std::move(input.expression), input.domain, time(), request.text, request.parameters};
  }
  [[nodiscard]] Domain read_domain(const SceneJson& value) const {
    Domain domain;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      domain.lo[axis] = value[axis][0], domain.hi[axis] = value[axis][1];
      if (!(domain.lo[axis] < domain.hi[axis]))
        fail(fmt::format("{}.domain[{}]", path_, axis),
             fmt::format("found [{}, {}], expected lo below hi", domain.lo[axis], domain.hi[axis]));
    }
    return domain;
  }
  [[nodiscard]] CsgSource read_csg() const {
    CsgSource csg;
    const std::string op = value_["op"];
    csg.operation = op == "union"          ? CsgOperation::unite
                    : op == "intersection" ? CsgOperation::intersect
                                           : CsgOperation::subtract;
    for (std::size_t i = 0; i < value_["of"].size(); ++i)
      csg.of.push_back(object_from_json(value_["of"][i], fmt::format("{}.of[{}]", path_, i), context_));
    return csg;
  }
  [[nodiscard]] InstanceSource read_instances() const {
    InstanceSource instances;
    instances.of = value_["of"];
    const SceneJson& places = value_["transforms"];
    for (std::size_t i = 0; i < places.size(); ++i)
      instances.places.push_back(in_place(fmt::format("transforms[{}]", i), places[i]));
    return instances;
  }

  [[nodiscard]] Transform in_place(const std::string& key, const SceneJson& value) const {
    Placement placement;
    if (value.contains("matrix")) {
      if (value.size() > 1) fail(path_ + "." + key, "found matrix and other keys, expected matrix alone");
      placement.matrix.emplace();
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 4; ++c) placement.matrix->m[r][c] = value["matrix"][r][c];
    }
    if (value.contains("scale"))
      placement.scale = value["scale"].is_number() ? Double3{value["scale"], value["scale"], value["scale"]}
                                                   : point_from_json(value["scale"]);
    if (value.contains("rotate")) {
      for (int a = 0; a < 3; ++a) placement.axis[a] = value["rotate"][a];
      placement.degrees = value["rotate"][3];
    }
    if (value.contains("translate")) placement.shift = point_from_json(value["translate"]);
    return at(key, [&] { return transform_of(placement); });
  }

  [[nodiscard]] MaterialDescription read_material(const SceneJson& value) const {
    MaterialDescription material;
    if (value.contains("color")) {
      const SceneJson& color = value["color"];
      const auto numbers = color.is_string() ? 0 : std::ranges::count_if(color, [](const SceneJson& each) {
        return each.is_number();
      });
      if (numbers != 0 && (numbers != 3 || color.size() != 3))
        fail(path_ + ".material.color", "expected [r, g, b], \"#rrggbb\" or a list of these");
      if (color.is_string() || numbers == 3) material.colors = {color_from_json(color)};
      else
        for (const SceneJson& each : color) material.colors.push_back(color_from_json(each));
    }
    const auto shares = [&](const char* key) {
      return value.contains(key) ? numbers_of(value[key]) : std::vector<double>{};
    };
    material.opacities = shares("opacity");
    material.reflectivities = shares("reflectivity");
    material.speculars = shares("specular");
    return material;
  }
  [[nodiscard]] ColorBy read_color_by(const SceneJson& value) const {
    const std::string path = path_ + ".color_by";
    ColorBy colors;
    if (value.contains("file") == value.contains("expr")) fail(path, "expected one of 'file' and 'expr'");
    if (value.contains("file")) colors.field = read_volume_source(value);
    else
      colors.field = FormulaSource{
          at("color_by.expr",
             [&] { return parse_expression(value["expr"].get<std::string>(), parameters_of(value)); }),
          {},
          time()};
    colors.map = value.value("map", colors.map);
    if (colors.map.ends_with(".json")) colors.map = (context_.folder / colors.map).string();
    else at("color_by.map", [&] { return color_map_from_name(colors.map); });
    if (value.contains("range")) {
      colors.range = value["range"].get<std::array<double, 2>>();
      if (!((*colors.range)[0] < (*colors.range)[1])) fail(path + ".range", "expected lo below hi");
    }
    colors.logarithmic = value.value("log", false);
    if (colors.logarithmic && colors.range && !((*colors.range)[0] > 0))
      fail(path + ".range", "expected numbers above 0 where log is true");
    if (value.contains("nan_color")) colors.nan_color = color_from_json(value["nan_color"]);
    return colors;
  }
  static NormalKind normals_from(const std::string& name) {
    return name == "difference"  ? NormalKind::difference
           : name == "neighbour" ? NormalKind::neighbour
                                 : NormalKind::gradient;
  }

  const SceneJson& value_;
  const std::string& path_;
  const SceneContext& context_;
};

}  // namespace

ObjectDescription object_from_json(const SceneJson& value, const std::string& path,
                                   const SceneContext& context) {
  return ObjectReader(value, path, context).read();
}

std::vector<SolidDescription> clips_from_json(const SceneJson& value, const std::string& path,
                                              const SceneContext& context) {
  std::vector<SolidDescription> clips;
  for (std::size_t i = 0; i < value.size(); ++i)
    clips.push_back(clip_from_json(value[i], fmt::format("{}[{}]", path, i), context));
  return clips;
}

Color color_from_json(const SceneJson& value) {
  if (value.is_string()) return color_from_hex(value);
  return value.get<Color>();
}

Double3 point_from_json(const SceneJson& value) { return value.get<Double3>(); }

}  // namespace isocast
