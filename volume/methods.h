// The rows of the method table for volumes.
#pragma once

#include <isocast/ray/method.h>
#include <isocast/volume/cell/options.h>

#include <map>
#include <span>
#include <string>

namespace isocast {

/// midpoint, linear, neubauer, schwarze, marmitt, certified: in the order of CellMethod.
[[nodiscard]] std::span<const Method> volume_methods();

struct CellMethodChoice {
  CellMethod method;
  CellOptions options;
  [[nodiscard]] bool proves() const { return method == CellMethod::certified; }
};
/// A row with its `--set` values. `iterations` given without `adaptive` asks for exactly that many steps
/// (adaptive=0). Throws InputError as find_method and resolve_options do.
[[nodiscard]] CellMethodChoice choose_cell_method(std::string_view name,
                                                  std::map<std::string, std::string> settings);

}  // namespace isocast
