#include <isocast/apps/scene_build/applicable_methods.h>

#include <algorithm>

namespace isocast {

std::vector<Method> applicable_methods(const ObjectDescription& object, MethodWish wish) {
  const auto copied = [](std::span<const Method> table) {
    return std::vector<Method>(table.begin(), table.end());
  };
  const auto* const formula = std::get_if<FormulaSource>(&object.source);
  if (!formula) return copied(volume_methods());
  std::vector<Method> methods = copied(formula_methods());
  const std::optional<int> degree = polynomial_degree(formula->expression).degree;
  const bool own = wish == MethodWish::own_answers;
  std::erase_if(methods, [&](const Method& method) {
    const FormulaMethodChoice choice = choose_formula_method(method.name, {});
    if (choice.has_form()) return !degree || (own && *degree > kMostFormDegree);
    return own && choice.pass != FormulaPass::none;
  });
  return methods;
}

}  // namespace isocast
