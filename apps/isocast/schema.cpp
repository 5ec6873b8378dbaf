// isocast schema: the JSON Schema of scene files.
#include <fmt/format.h>
#include <isocast/apps/isocast/verbs.h>
#include <isocast/apps/scene_build/scene_json.h>

#include <CLI/CLI.hpp>

namespace isocast::verbs {

void add_schema(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("schema", "The JSON Schema of scene files, for editors and checks");
  verb->callback([] { fmt::print("{}", schema_of(scene_rule())); });
}

}  // namespace isocast::verbs
