#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/text.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/expression/nearest_name.h>
#include <isocast_surfaces_json.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace isocast {
namespace {

using Json = nlohmann::ordered_json;

CatalogueSurface read_surface(const Json& record) {
  CatalogueSurface surface;
  record.at("id").get_to(surface.id);
  record.at("name").get_to(surface.name);
  if (record.at("degree").is_number()) surface.degree = record["degree"].get<int>();
  record.at("kind").get_to(surface.kind);
  record.at("expr").get_to(surface.expr);
  for (const auto& [name, value] : record.at("params").items())
    surface.params.push_back({name, shortest_constant(value.get<double>())});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    surface.domain.lo[axis] = record.at("domain").at(axis).at(0).get<double>();
    surface.domain.hi[axis] = record.at("domain").at(axis).at(1).get<double>();
  }
  record.at("papers").get_to(surface.papers);
  record.at("notes").get_to(surface.notes);
  return surface;
}

std::vector<CatalogueSurface> read_catalogue() {
  std::vector<CatalogueSurface> surfaces;
  for (const Json& record : Json::parse(kSurfacesJson)) surfaces.push_back(read_surface(record));
  return surfaces;
}

}  // namespace

std::span<const CatalogueSurface> catalogue() {
  static const std::vector<CatalogueSurface> surfaces = read_catalogue();
  return surfaces;
}

const CatalogueSurface* find_surface(std::string_view id) {
  const auto found = std::ranges::find(catalogue(), id, &CatalogueSurface::id);
  return found == catalogue().end() ? nullptr : &*found;
}

const CatalogueSurface& require_surface(std::string_view id) {
  if (const CatalogueSurface* surface = find_surface(id)) return *surface;
  std::vector<std::string> ids;
  for (const CatalogueSurface& surface : catalogue()) ids.push_back(surface.id);
  const std::string nearest = nearest_name(id, ids);
  throw InputError(
      fmt::format("found no surface {} in the catalogue, expected one that 'isocast surfaces' lists{}",
                  in_quotes(id), nearest.empty() ? "" : fmt::format("; the nearest is '{}'", nearest)));
}

Expression surface_expression(const CatalogueSurface& surface, const Parameters& overrides) {
  // only the surface's own parameters can be set
  std::vector<std::string> names;
  for (const Parameter& parameter : surface.params) names.push_back(parameter.name);
  for (const Parameter& parameter : overrides)
    if (std::ranges::count(names, parameter.name) == 0)
      throw InputError(fmt::format("found the parameter {}, expected {} of @{}", in_quotes(parameter.name),
                                   names.empty() ? "none" : fmt::format("one of {}", fmt::join(names, " ")),
                                   surface.id));

  // defaults first, so that the others override them
  Parameters parameters = surface.params;
  parameters.insert(parameters.end(), overrides.begin(), overrides.end());
  return parse_expression(surface.expr, parameters, "@" + surface.id);
}

}  // namespace isocast
