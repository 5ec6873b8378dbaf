// INPUT words that mean a formula.
#pragma once

#include <isocast/implicit/expression/domain.h>
#include <isocast/implicit/expression/parse.h>

#include <optional>
#include <string>

namespace isocast {

/// Whether the word names a volume file: it ends like one; or it holds a / and is no formula of these
/// parameters.
[[nodiscard]] bool is_volume_file(const std::string& word, const Parameters& parameters);

/// text        a formula, the name of a .vm tape, or @id of the catalogue
/// parameters  values of its names; of a catalogue surface, other ones than its own
/// domain      the box; none: the catalogue's, else [-1, 1]^3
struct FormulaRequest {
  std::string text;
  Parameters parameters;
  std::optional<Domain> domain;
};
struct FormulaInput {
  Expression expression;
  Domain domain;
};
/// Throws InputError for what cannot be read, and for parameters that a tape does not have.
[[nodiscard]] FormulaInput read_formula(const FormulaRequest& request);

}  // namespace isocast
