// isocast surfaces: the catalogue, as a table or as JSON.
#include <fmt/format.h>
#include <isocast/apps/isocast/verbs.h>
#include <isocast/implicit/expression/catalogue.h>

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

}  // namespace

void add_surfaces(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("surfaces", "The catalogue of surfaces, for use as @id");
  const auto json = std::make_shared<bool>(false);
  verb->add_flag("--json", *json,
                 "A list of objects: id, name, degree, kind, expr, params, domain, papers, notes");
  verb->callback([json] { *json ? print_json() : print_table(); });
}

}  // namespace isocast::verbs
