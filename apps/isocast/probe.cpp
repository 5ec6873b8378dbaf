// isocast probe: one ray through every method, against the reference.
#include <fmt/format.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/isocast/probe_ray.h>
#include <isocast/apps/isocast/scene_options.h>
#include <isocast/apps/isocast/verbs.h>
#include <isocast/apps/scene_build/applicable_methods.h>
#include <isocast/apps/scene_build/scene_file.h>
#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

namespace isocast::verbs {
namespace {

using json = nlohmann::ordered_json;

struct ProbeWords {
  RenderWords scene;
  std::string pixel;
  bool as_json = false;
};

std::array<int, 2> parse_pixel(const std::string& text, int width, int height) {
  const std::vector<double> p = parse_numbers(text, "--pixel");
  const auto fits = [](double x, int size) { return x >= 0 && x < size && x == std::floor(x); };
  if (p.size() != 2 || !fits(p[0], width) || !fits(p[1], height))
    throw InputError(fmt::format("--pixel {}: expected X,Y from 0,0 (the upper left pixel) to {},{}", text,
                                 width - 1, height - 1));
  return {static_cast<int>(p[0]), static_cast<int>(p[1])};
}

// The one that was asked for, or all that apply.
std::vector<ProbeMethod> methods_of(const ObjectDescription& object) {
  if (object.method != "auto") return {{object.method, object.settings}};
  if (!object.settings.empty())
    throw InputError("found --set without --method, expected the method that it is for");
  std::vector<ProbeMethod> methods;
  for (const Method& method : applicable_methods(object)) methods.push_back({std::string(method.name), {}});
  return methods;
}

const char* name_of(Certificate certificate) {
  switch (certificate) {
    case Certificate::proved_hit: return "proved hit";
    case Certificate::proved_miss: return "proved miss";
    case Certificate::undecided: return "undecided";
    default: return "no proof";
  }
}
const char* name_of(reference::Doubt doubt) {
  switch (doubt) {
    case reference::Doubt::touch: return "a touch, perhaps";
    case reference::Doubt::zero: return "f is the iso-value all along";
    case reference::Doubt::jump: return "f jumps";
    case reference::Doubt::undefined: return "f is somewhere undefined";
    default: return "too much work";
  }
}

bool is_hit(const ProbeAnswer& answer) { return std::isfinite(answer.t); }

json json_of(const Probe& probe, const std::array<int, 2>& pixel, const std::vector<double>& iso) {
  json truth = {{"bits", probe.truth.bits}, {"roots", json::array()}, {"doubts", json::array()}};
  for (const reference::RayRoot& r : probe.truth.roots)
    truth["roots"].push_back({{"t", 0.5 * (r.lo + r.hi)},
                              {"t_interval", {r.lo, r.hi}},
                              {"crossing", r.crossing},
                              {"iso", iso[static_cast<std::size_t>(r.iso)]},
                              {"condition", r.condition},
                              {"distance", r.distance}});
  for (const reference::DoubtfulRange& d : probe.truth.doubts)
    truth["doubts"].push_back({{"t_interval", {d.lo, d.hi}}, {"why", name_of(d.doubt)}});
  json methods = json::array();
  for (const ProbeAnswer& a : probe.answers) {
    methods.push_back({{"name", a.method},
                       {"precision", a.precision},
                       {"t", is_hit(a) ? json(a.t) : json()},
                       {"t_interval", is_hit(a) ? json({a.t_lo, a.t_hi}) : json()},
                       {"certificate", name_of(a.certificate)},
                       {"error", a.error},
                       {"evaluations", a.work},
                       {"seconds", a.seconds},
                       {"verdict", a.verdict}});
    if (!a.contradiction.empty()) methods.back()["contradiction"] = a.contradiction;
  }
  return {{"pixel", pixel},
          {"ray", {{"origin", probe.origin}, {"direction", probe.direction}}},
          {"unit", probe.unit},
          {"reference", truth},
          {"methods", methods}};
}

void print(const Probe& probe, const std::vector<double>& iso, const char* unit) {
  const auto& [o, d] = std::tie(probe.origin, probe.direction);
  fmt::print("ray from {:.9g} {:.9g} {:.9g} along {:.9g} {:.9g} {:.9g}; lengths in {} of {:.6g}\n\n", o[0],
             o[1], o[2], d[0], d[1], d[2], unit, probe.unit);
  fmt::print("{:<22} {:<9} {:>10} {:>12} {:>12}\n", "reference t", "root", "iso", "condition",
             "nearest root");
  for (const reference::RayRoot& r : probe.truth.roots)
    fmt::print("{:<22.17g} {:<9} {:>10.6g} {:>12.3g} {:>12.3g}\n", 0.5 * (r.lo + r.hi),
               r.crossing ? "crossing" : "touch", iso[static_cast<std::size_t>(r.iso)], r.condition,
               r.distance);
  for (const reference::DoubtfulRange& doubt : probe.truth.doubts)
    fmt::print("not known from {:.17g} to {:.17g}: {}\n", doubt.lo, doubt.hi, name_of(doubt.doubt));
  if (probe.truth.roots.empty() && probe.truth.decided()) fmt::print("none\n");

  fmt::print("\n{:<16} {:<9} {:<18} {:>9} {:<12} {:>9} {:>7} {:>9}  {}\n", "method", "precision", "t",
             "bracket", "proof", "error", "work", "seconds", "verdict");
  for (const ProbeAnswer& a : probe.answers) {
    const std::string t = is_hit(a) ? fmt::format("{:.15g}", a.t) : "no hit",
                      bracket = is_hit(a) ? fmt::format("{:.2g}", a.t_hi - a.t_lo) : "",
                      error = std::isnan(a.error) ? "" : fmt::format("{:.2g}", a.error);
    fmt::print("{:<16} {:<9} {:<18} {:>9} {:<12} {:>9} {:>7} {:>9.2g}  {}\n", a.method, a.precision, t,
               bracket, name_of(a.certificate), error, a.work, a.seconds, a.verdict);
  }
}

// An object of a scene alone, without its clip solids, of which the reference knows nothing.
ObjectDescription probed(ObjectDescription object) {
  if (!std::holds_alternative<VolumeSource>(object.source) &&
      !std::holds_alternative<FormulaSource>(object.source))
    throw InputError(
        fmt::format("probe: found the object '{}' there, expected a volume or a formula", object.name));
  object.clips.clear();
  object.color_by.reset();
  return object;
}

void run(const ProbeWords& words) {
  SceneDescription description = describe(words.scene);
  const auto [width, height] = size_of(words.scene, description);
  const std::array<int, 2> pixel = parse_pixel(words.pixel, width, height);
  const std::vector<double> iso =
      words.scene.iso.empty() ? std::vector<double>() : parse_numbers(words.scene.iso, "--iso");
  if (!iso.empty()) description.objects.front().iso = iso;
  const Isa isa = isa_from_name(words.scene.isa);
  std::optional<View> scene_view;
  if (is_scene_file(words.scene.input)) {
    const BuiltScene all = build_scene(description, {isa, false});
    scene_view.emplace(frame(all.scene.bounds(), description.camera, double(width) / height), width, height);
    const std::size_t object = object_at(all, *scene_view, pixel[0], pixel[1]).value_or(0);
    description.objects = {probed(description.objects[object])};
  }
  const std::vector<ProbeMethod> methods = methods_of(description.objects.front());
  const BuiltScene built = build_scene(description, {isa, false});
  const View view = scene_view ? *scene_view
                               : View(frame(built.scene.bounds(), description.camera, double(width) / height),
                                      width, height);
  const Probe probe = probe_ray(description, built, view, pixel[0], pixel[1], methods, isa);
  check_mapped_files();

  if (words.as_json) fmt::print("{}\n", json_of(probe, pixel, built.objects.front().iso).dump(2));
  else print(probe, built.objects.front().iso, built.objects.front().volume ? "voxels" : "domain widths");
  std::string contradictions;
  for (const ProbeAnswer& a : probe.answers)
    if (!a.contradiction.empty())
      contradictions += fmt::format("\n{} in {}: {}", a.method, a.precision, a.contradiction);
  if (!contradictions.empty()) throw std::runtime_error("A PROOF CONTRADICTS THE REFERENCE" + contradictions);
}

}  // namespace

void add_probe(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("probe",
                         "One ray through every applicable method, in float and double, against the "
                         "high-precision reference");
  const auto words = std::make_shared<ProbeWords>();
  add_scene_options(*verb, words->scene,
                    "One method, to which --set applies (default: all that apply, as they are)");
  verb->add_option("--pixel", words->pixel,
                   "X,Y from the upper left corner, 0,0; the ray leads through its centre")
      ->required();
  verb->add_flag("--json", words->as_json, "One JSON object on stdout");
  verb->callback([words] { run(*words); });
}

}  // namespace isocast::verbs
