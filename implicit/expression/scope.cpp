#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/text.h>
#include <isocast/implicit/expression/builtins.h>
#include <isocast/implicit/expression/scope.h>

#include <algorithm>
#include <iterator>

namespace isocast {
namespace {

constexpr std::string_view kVariables[] = {"x", "y", "z", "w"};
constexpr std::string_view kKeywords[] = {"let", "in", "and", "or", "not"};

}  // namespace

Scope::Scope(const Parameters& parameters) {
  for (const Parameter& parameter : parameters) {
    if (!is_free(parameter.name))
      throw InputError(
          fmt::format("the parameter {} has the name of a variable or a function, expected a name of its own",
                      in_quotes(parameter.name)));
    parameters_[parameter.name] = &parameter.value;
  }
}

std::optional<NodeId> Scope::value(Expression& expression, std::string_view name) const {
  if (const auto place = std::ranges::find(kVariables, name); place != std::end(kVariables))
    return expression.variable(static_cast<int>(place - std::begin(kVariables)));
  const auto is_named = [&](const Local& local) { return local.name == name; };
  if (const auto local = std::find_if(locals.rbegin(), locals.rend(), is_named); local != locals.rend())
    return local->node;
  if (const auto found = values_.find(name); found != values_.end()) return found->second;
  if (const auto found = parameters_.find(name); found != parameters_.end())
    return expression.constant(*found->second);
  if (const std::optional<Constant> constant = named_constant(name)) return expression.constant(*constant);
  return std::nullopt;
}

const UserFunction* Scope::function(std::string_view name) const {
  const auto found = functions_.find(name);
  return found == functions_.end() ? nullptr : &found->second;
}

bool Scope::is_free(std::string_view name) {
  return !find_builtin(name) && name != "sum" && !is_keyword(name) &&
         std::ranges::count(kVariables, name) == 0;
}

bool Scope::is_new(std::string_view name) const {
  return is_free(name) && !parameters_.contains(name) && !values_.contains(name) &&
         !functions_.contains(name);
}

bool Scope::is_keyword(std::string_view name) { return std::ranges::count(kKeywords, name) != 0; }

std::vector<std::string> Scope::known() const {
  std::vector<std::string> names(std::begin(kVariables), std::end(kVariables));
  for (const Local& local : locals) names.emplace_back(local.name);
  for (const auto& [name, value] : values_) names.emplace_back(name);
  for (const auto& [name, function] : functions_) names.emplace_back(name);
  for (const auto& [name, constant] : parameters_) names.emplace_back(name);
  for (const Builtin& function : builtins()) names.emplace_back(function.name);
  names.insert(names.end(), {"sum", "pi", "e", "phi"});
  std::ranges::sort(names);
  return names;
}

}  // namespace isocast
