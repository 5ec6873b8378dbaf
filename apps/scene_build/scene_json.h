// The text of a scene as JSON that is known to follow the rules.
#pragma once

#include <isocast/apps/scene_build/scene_rules.h>

#include <nlohmann/json.hpp>
#include <string>

namespace isocast {

using SceneJson = nlohmann::json;

/// Reads JSON with // and /* */ comments, of at most 64 MB and 64 levels. Throws InputError "source:line:
/// column: ..." for what is none, and for a key that a record has twice.
[[nodiscard]] SceneJson parse_scene_json(const std::string& text, const std::string& source);

/// Throws InputError "source: objects[2].material.color: found ..., expected ..." for the first value that
/// breaks the rule, with the nearest name for an unknown key or word.
void check_rule(const SceneJson& value, const Rule& rule, const std::string& source);

/// The JSON Schema (draft 2020-12) of a rule.
[[nodiscard]] std::string schema_of(const Rule& rule);

}  // namespace isocast
