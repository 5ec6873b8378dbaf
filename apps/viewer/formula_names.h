// The names of a formula that have sliders.
#pragma once

#include <isocast/apps/isocast/render_words.h>

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

/// Whether time is given or the input's text may use w.
[[nodiscard]] bool uses_time(const RenderWords& words);

}  // namespace isocast::viewer
