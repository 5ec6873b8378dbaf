#include <isocast/volume/methods.h>

#include <algorithm>
#include <string>

namespace isocast {
namespace {

constexpr const char* kMarmittPaper =
    "Marmitt, Kleer, Wald, Friedrich, Slusallek: Fast and accurate ray-voxel intersection techniques for "
    "iso-surface ray tracing, VMV 2004";

constexpr MethodOption iterations(double default_value) {
  return {"iterations",
          default_value,
          1,
          100,
          true,
          "steps",
          "steps of regula falsi (or bisection) when adaptive=0"};
}
constexpr MethodOption adaptive(double default_value) {
  return {"adaptive",
          default_value,
          0,
          1,
          true,
          "",
          "1: refine until a step is below 2^-20 (float) or 2^-46 (double) of the chord; 0: exactly "
          "`iterations` steps"};
}
constexpr MethodOption kFace = {
    "face", 0, 0, 1, true, "", "1: bilinear values on the cell's faces; 0: trilinear (the same bits)"};
constexpr MethodOption kStable = {
    "stable",
    1,
    0,
    1,
    true,
    "",
    "1: cubic by averages in Bernstein form; 0: the textbook's powers, which lose digits"};
constexpr MethodOption kTouch = {
    "touch",
    0,
    0,
    1,
    true,
    "",
    "1: an extremum that reaches the iso-value without crossing is a hit, marked undecided"};
constexpr MethodOption kBisection = {
    "bisection", 0, 0, 1, true, "", "1: bisection instead of regula falsi when adaptive=0"};

constexpr MethodOption kLinear[] = {kFace};
constexpr MethodOption kNeubauer[] = {iterations(3), adaptive(0), kFace};
constexpr MethodOption kSchwarze[] = {kStable};
constexpr MethodOption kMarmitt[] = {iterations(3), adaptive(1), kStable, kTouch, kBisection};

constexpr Method kMethods[kCellMethodCount] = {
    {"midpoint", "volume", "nothing", "basic", "float double", {}, kMarmittPaper},
    {"linear", "volume", "nothing", "basic", "float double", kLinear, kMarmittPaper},
    {"neubauer", "volume", "nothing", "basic", "float double", kNeubauer,
     "Neubauer, Mroz, Hauser, Wegenkittl: Cell-based first-hit ray casting, VisSym 2002"},
    {"schwarze", "volume", "nothing", "library", "float double", kSchwarze,
     "Schwarze: Cubic and quartic roots, Graphics Gems, 1990"},
    {"marmitt", "volume", "nothing", "basic", "float double", kMarmitt, kMarmittPaper},
    {"certified",
     "volume",
     "both",
     "basic",
     "float double",
     {},
     "isocast: marmitt with outward error bounds of Bernstein coefficients"},
};

}  // namespace

std::span<const Method> volume_methods() { return kMethods; }

CellMethodChoice choose_cell_method(std::string_view name, std::map<std::string, std::string> settings) {
  const Method& method = find_method(kMethods, name == "auto" ? "marmitt" : name);
  const bool has_adaptive =
      std::ranges::any_of(method.options, [](const MethodOption& o) { return o.name == "adaptive"; });
  if (has_adaptive && settings.contains("iterations")) settings.emplace("adaptive", std::string(1, '0'));
  const std::map<std::string, double> values = resolve_options(method, settings);
  const auto value = [&](const char* key, double otherwise) {
    const auto found = values.find(key);
    return found == values.end() ? otherwise : found->second;
  };
  CellMethodChoice choice;
  choice.method = static_cast<CellMethod>(&method - kMethods);
  choice.options.iterations = static_cast<int>(value("iterations", 0));
  choice.options.adaptive = choice.method == CellMethod::certified || value("adaptive", 0) != 0;
  choice.options.stable = value("stable", 1) != 0;
  choice.options.face = value("face", 0) != 0;
  choice.options.touch = value("touch", 0) != 0;
  choice.options.bisection = value("bisection", 0) != 0;
  return choice;
}

}  // namespace isocast
