#include <fmt/format.h>
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

bool text_uses_time(std::string text) {
  if (text.starts_with('@'))
    if (const CatalogueSurface* surface = find_surface(std::string_view(text).substr(1)))
      text = surface->expr;
  for (std::size_t at = text.find('w'); at != std::string::npos; at = text.find('w', at + 1))
    if ((at == 0 || !is_letter(text[at - 1])) && (at + 1 == text.size() || !is_letter(text[at + 1])))
      return true;
  return false;
}

// Any formula in the document, wherever it stands.
bool document_uses_time(const SceneJson& part) {
  if (part.is_array()) return std::ranges::any_of(part, document_uses_time);
  if (!part.is_object()) return false;
  return std::ranges::any_of(part.items(), [](const auto& item) {
    const SceneJson& value = item.value();
    if (!value.is_string()) return document_uses_time(value);
    const std::string& key = item.key();
    if (key == "id") return text_uses_time(fmt::format("@{}", value.get<std::string>()));
    return (key == "expr" || key == "formula") && text_uses_time(value);
  });
}

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

bool uses_time(const Session& session) {
  if (!session.words.time.empty()) return true;
  return session.document ? document_uses_time(*session.document) : text_uses_time(session.words.input);
}

}  // namespace isocast::viewer
