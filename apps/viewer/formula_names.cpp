#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/viewer/formula_names.h>
#include <isocast/implicit/expression/catalogue.h>

#include <algorithm>
#include <cctype>

namespace isocast::viewer {
namespace {

void set(std::vector<NamedNumber>& numbers, const std::string& name, double value) {
  const auto known = std::ranges::find(numbers, name, &NamedNumber::name);
  if (known == numbers.end()) numbers.push_back({name, value});
  else known->value = value;
}

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

}  // namespace

std::vector<NamedNumber> parameters_of(const RenderWords& words) {
  std::vector<NamedNumber> numbers;
  const std::string input = typed_formula(words.input);
  if (input.starts_with('@'))
    if (const CatalogueSurface* surface = find_surface(std::string_view(input).substr(1)))
      for (const Parameter& parameter : surface->params) set(numbers, parameter.name, parameter.value.value);
  for (const std::string& word : words.params) {
    const auto [name, value] = parse_key_value(word, "--param");
    set(numbers, name, parse_number(value, "--param"));
  }
  return numbers;
}

bool uses_time(const RenderWords& words) {
  if (!words.time.empty()) return true;
  std::string text = words.input;
  if (text.starts_with('@'))
    if (const CatalogueSurface* surface = find_surface(std::string_view(text).substr(1)))
      text = surface->expr;
  for (std::size_t at = text.find('w'); at != std::string::npos; at = text.find('w', at + 1))
    if ((at == 0 || !is_letter(text[at - 1])) && (at + 1 == text.size() || !is_letter(text[at + 1])))
      return true;
  return false;
}

}  // namespace isocast::viewer
