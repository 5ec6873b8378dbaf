// What the names in a formula stand for.
#pragma once

#include <isocast/implicit/expression/parse.h>
#include <isocast/implicit/expression/reader.h>

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace isocast {

/// A function that the formula defines; each call reads the body again with the parameters bound.
struct UserFunction {
  std::vector<std::string_view> parameters;
  Place body;
};

/// A name that holds in one body only.
struct Local {
  std::string_view name;
  NodeId node;
};
using Locals = std::vector<Local>;

/// Names are found in this order: variables, locals, definitions, parameters, constants.
class Scope {
 public:
  /// Throws InputError when a parameter is called like a variable, a function or a keyword. `parameters` must
  /// outlive the scope.
  explicit Scope(const Parameters& parameters);

  /// The node of a name that stands for a number; nothing for any other name.
  [[nodiscard]] std::optional<NodeId> value(Expression& expression, std::string_view name) const;
  [[nodiscard]] const UserFunction* function(std::string_view name) const;

  /// Whether a local may have that name: no variable, function or keyword of the language.
  [[nodiscard]] static bool is_free(std::string_view name);
  /// Whether a definition may: besides, no parameter and no earlier definition.
  [[nodiscard]] bool is_new(std::string_view name) const;
  [[nodiscard]] static bool is_keyword(std::string_view name);

  void define(std::string_view name, NodeId value) { values_.emplace(name, value); }
  void define(std::string_view name, UserFunction function) { functions_.emplace(name, std::move(function)); }

  /// All of them, for messages.
  [[nodiscard]] std::vector<std::string> known() const;

  Locals locals;

 private:
  std::unordered_map<std::string_view, const Constant*> parameters_;
  std::unordered_map<std::string_view, NodeId> values_;
  std::unordered_map<std::string_view, UserFunction> functions_;
};

}  // namespace isocast
