// isocast surfaces: the catalogue, as a table, as JSON or as a picture of them all.
#include <fmt/format.h>
#include <isocast/apps/isocast/contact_sheet.h>
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/isocast/verbs.h>
#include <isocast/base/error.h>
#include <isocast/base/output_file.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/render/image_file.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

namespace isocast::verbs {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const CatalogueSurface& surface) {
  Json params = Json::object(), domain = Json::array();
  for (const Parameter& parameter : surface.params) params[parameter.name] = parameter.value.value;
  for (int axis = 0; axis < 3; ++axis) domain.push_back({surface.domain.lo[axis], surface.domain.hi[axis]});
  return {{"id", surface.id},
          {"name", surface.name},
          {"degree", surface.degree ? Json(*surface.degree) : Json()},
          {"kind", surface.kind},
          {"expr", surface.expr},
          {"params", params},
          {"domain", domain},
          {"papers", surface.papers},
          {"notes", surface.notes}};
}

void print_json() {
  Json list = Json::array();
  for (const CatalogueSurface& surface : catalogue()) list.push_back(to_json(surface));
  fmt::print("{}\n", list.dump(2));
}

void print_table() {
  // the widest id makes the column
  std::size_t width = 0;
  for (const CatalogueSurface& surface : catalogue()) width = std::max(width, surface.id.size());
  fmt::print("{:{}}  {:12}  {:>6}  name (parameters)\n", "id", width, "kind", "degree");
  for (const CatalogueSurface& surface : catalogue()) {
    std::vector<std::string> params;
    for (const Parameter& parameter : surface.params)
      params.push_back(fmt::format("{}={}", parameter.name, parameter.value.value));
    fmt::print("{:{}}  {:12}  {:>6}  {}{}\n", surface.id, width, surface.kind,
               surface.degree ? std::to_string(*surface.degree) : "", surface.name,
               params.empty() ? "" : fmt::format(" ({})", fmt::join(params, " ")));
  }
}

// The words of the command line.
struct Request {
  bool json = false;
  int size = 256;
  std::string output, method = "auto", time = "0", precision = "float";
  std::vector<std::string> set;
};

void draw(const Request& request) {
  if (!request.output.ends_with(".png"))
    throw InputError(fmt::format("-o {}: expected a name that ends with .png", request.output));
  SheetWishes wishes;
  wishes.size = request.size;
  wishes.method = request.method;
  wishes.time = parse_number(request.time, "--time");
  wishes.evaluation.double_precision = request.precision == "double";
  wishes.evaluation.mixed_precision = request.precision == "mixed";
  for (const std::string& word : request.set) wishes.settings.insert(parse_key_value(word, "--set"));
  // a bad name fails before the work
  { const OutputFile writable(request.output); }
  const Sheet sheet = draw_catalogue(wishes);
  write_png(request.output, sheet.width, sheet.height, sheet.rgba.data());
}

void run(const Request& request) {
  if (!request.output.empty()) draw(request);
  else if (request.json) print_json();
  else print_table();
}

}  // namespace

void add_surfaces(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("surfaces", "The catalogue of surfaces, for use as @id");
  const auto r = std::make_shared<Request>();
  CLI::Option* json = verb->add_flag(
      "--json", r->json, "A list of objects: id, name, degree, kind, expr, params, domain, papers, notes");
  CLI::Option* output =
      verb->add_option("-o", r->output, "A picture, .png, of all surfaces as 'render @id' draws them")
          ->excludes(json);
  verb->add_option("--size", r->size, "Of each surface's tile, in pixels along both edges")
      ->check(CLI::Range(16, 1024))
      ->capture_default_str()
      ->needs(output);
  verb->add_option("--method", r->method, "auto, or a method for formulas that 'isocast methods' lists")
      ->capture_default_str()
      ->needs(output);
  verb->add_option("--set", r->set, "An option of the method, KEY=VALUE")
      ->allow_extra_args(false)
      ->needs(output);
  verb->add_option("--precision", r->precision, "float or double")
      ->check(CLI::IsMember({"float", "double"}))
      ->capture_default_str()
      ->needs(output);
  verb->add_option("--time", r->time, "The variable w of surfaces that move")
      ->capture_default_str()
      ->needs(output);
  verb->callback([r] { run(*r); });
}

}  // namespace isocast::verbs
