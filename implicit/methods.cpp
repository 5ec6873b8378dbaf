#include <isocast/implicit/methods.h>

namespace isocast {
namespace {

constexpr const char* kKnoll =
    "Knoll, Hijazi, Kensler, Schott, Hansen, Hagen: Fast ray tracing of arbitrary implicit surfaces with "
    "interval and affine arithmetic, Computer Graphics Forum 28(1), 2009";

constexpr MethodOption kEps = {
    "eps", 0, 0, 1e300, false, "world length", "parts of a ray below it are judged; 0: eps-rel decides"};
constexpr MethodOption kEpsRel = {
    "eps-rel", 0x1p-11, 0x1p-40, 1, false, "of the domain's longest edge", "the same as a fraction"};
constexpr MethodOption kTrim = {
    "trim", 1, 0, 1, true, "", "1: what a form proves empty of a part is left out before it is divided"};

constexpr MethodOption kBisection = {
    "bisection",
    0,
    0,
    1,
    true,
    "",
    "t: each ray for itself; k: 16 rays are divided together, along the axis that they follow most",
    "t k"};

constexpr MethodOption kInterval[] = {kEps, kEpsRel, kBisection};
constexpr MethodOption kAffine[] = {kEps, kEpsRel, kBisection, kTrim};
constexpr Method kMethods[kFormulaMethodCount] = {
    {"interval", "formula", "both", "library", "float double", kInterval, kKnoll},
    {"affine", "formula", "both", "library", "float double", kAffine, kKnoll},
};

}  // namespace

std::span<const Method> formula_methods() { return kMethods; }

FormulaMethodChoice choose_formula_method(std::string_view name,
                                          const std::map<std::string, std::string>& settings) {
  const Method& method = find_method(kMethods, name == "auto" ? "affine" : name);
  const std::map<std::string, double> values = resolve_options(method, settings);
  FormulaMethodChoice choice;
  choice.method = static_cast<FormulaMethod>(&method - kMethods);
  choice.eps = values.at("eps");
  choice.eps_rel = values.at("eps-rel");
  choice.options.packets = values.at("bisection") == 1;
  if (const auto trim = values.find("trim"); trim != values.end()) choice.options.trim = trim->second != 0;
  return choice;
}

}  // namespace isocast
