// The names of a formula that have sliders.
#pragma once

#include <isocast/apps/viewer/session.h>

#include <string>
#include <vector>

namespace isocast::viewer {

struct NamedNumber {
  std::string name;
  double value;
};

/// Parameters of the words and, of a catalogue surface, its own, with their values; not those of other
/// inputs.
[[nodiscard]] std::vector<NamedNumber> parameters_of(const RenderWords& words);

/// Whether time is given or the formula, or one of the scene's, may use w.
[[nodiscard]] bool uses_time(const Session& session);

}  // namespace isocast::viewer
