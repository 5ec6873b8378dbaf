// The surfaces that the program knows by name.
#pragma once

#include <isocast/implicit/expression/domain.h>
#include <isocast/implicit/expression/parse.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isocast {

/// One record of surfaces.json: f = 0 inside `domain`, w being time when `kind` is "dynamic". `degree` only
/// of polynomials.
struct CatalogueSurface {
  std::string id, name;
  std::optional<int> degree;
  std::string kind;  // "algebraic", "nonalgebraic", "csg", "dynamic"
  std::string expr;
  Parameters params;
  Domain domain;
  std::vector<std::string> papers;
  std::string notes;
};

/// All of them, in the order of the table; read at the first call.
[[nodiscard]] std::span<const CatalogueSurface> catalogue();

/// Null when there is none of that id.
[[nodiscard]] const CatalogueSurface* find_surface(std::string_view id);

/// The same, but throws InputError with the nearest id.
[[nodiscard]] const CatalogueSurface& require_surface(std::string_view id);

/// The surface's formula with its own parameters but for `overrides`; throws InputError when one of these is
/// not among them.
[[nodiscard]] Expression surface_expression(const CatalogueSurface& surface,
                                            const Parameters& overrides = {});

}  // namespace isocast
