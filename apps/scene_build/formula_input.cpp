#include <isocast/apps/scene_build/formula_input.h>
#include <isocast/base/error.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/expression/vm_tape.h>
#include <isocast/volume/io/read_volume.h>

#include <algorithm>
#include <filesystem>

namespace isocast {

bool is_volume_file(const std::string& word, const Parameters& parameters) {
  if (has_volume_extension(word)) return true;
  if (word.find('/') == std::string::npos || word.ends_with(".vm")) return false;
  std::error_code ignored;
  if (std::filesystem::exists(word, ignored)) return true;
  try {  // x/2 is a formula, folder/name is not
    (void)parse_expression(word, parameters);
    return false;
  } catch (const InputError&) { return true; }
}

FormulaInput read_formula(const FormulaRequest& request) {
  FormulaInput input;
  if (request.text.starts_with('@')) {
    const CatalogueSurface& surface = require_surface(std::string_view(request.text).substr(1));
    input = {surface_expression(surface, request.parameters), surface.domain};
  } else if (request.text.ends_with(".vm")) {
    if (!request.parameters.empty()) throw InputError("found --param for a tape, which has no parameters");
    input.expression = read_vm_file(request.text);
  } else {
    input.expression = parse_expression(request.text, request.parameters);
  }
  if (request.domain) input.domain = *request.domain;
  return input;
}

}  // namespace isocast
