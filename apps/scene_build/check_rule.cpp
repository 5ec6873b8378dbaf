#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/apps/scene_build/scene_json.h>
#include <isocast/base/error.h>
#include <isocast/base/text.h>
#include <isocast/implicit/expression/nearest_name.h>

#include <algorithm>
#include <cmath>

namespace isocast {
namespace {

// A value as a user would recognise it.
std::string shown(const SceneJson& value) {
  if (value.is_object()) return "a record";
  if (value.is_array()) return fmt::format("a list of {}", value.size());
  if (value.is_string()) return in_quotes(value.get_ref<const std::string&>());
  return value.dump();
}

std::string nearest(const std::string& word, const std::vector<std::string>& names) {
  const std::string name = nearest_name(word, names);
  return name.empty() ? "" : fmt::format(", did you mean '{}'?", name);
}

template <class Names> std::vector<std::string> texts(const Names& names) {
  return {names.begin(), names.end()};
}

// Where a value stands, and what is wrong there.
class Checker {
 public:
  explicit Checker(const std::string& source) : source_(source) {}

  void check(const SceneJson& value, const Rule& rule, const std::string& path) const {
    switch (rule.kind) {
      case RuleKind::number:
      case RuleKind::integer: return check_number(value, rule, path);
      case RuleKind::boolean: return require(value.is_boolean(), value, rule, path);
      case RuleKind::text: return check_text(value, rule, path);
      case RuleKind::list: return check_list(value, rule, path);
      case RuleKind::record: return check_record(value, rule, path);
      case RuleKind::tagged: return check(value, record_of(value, rule, path), path);
      case RuleKind::either: return check_either(value, rule, path);
    }
  }

 private:
  [[noreturn]] void fail(const std::string& path, const std::string& what) const {
    throw InputError(fmt::format("{}: {}: {}", source_, path.empty() ? "the scene" : path, what));
  }
  void require(bool good, const SceneJson& value, const Rule& rule, const std::string& path) const {
    if (!good) fail(path, fmt::format("found {}, expected {}", shown(value), rule.meaning));
  }
  void check_number(const SceneJson& value, const Rule& rule, const std::string& path) const {
    require(value.is_number(), value, rule, path);
    const double x = value.get<double>();
    require(std::isfinite(x) && x >= rule.lo && x <= rule.hi && (x > rule.lo || !rule.above) &&
                (rule.kind == RuleKind::number || x == std::floor(x)),
            value, rule, path);
  }
  void check_text(const SceneJson& value, const Rule& rule, const std::string& path) const {
    require(value.is_string(), value, rule, path);
    const std::string& text = value.get_ref<const std::string&>();
    if (!rule.choices.empty()) {
      if (std::ranges::find(rule.choices, text) == rule.choices.end())
        fail(path, fmt::format("found {}, expected one of: {}{}", shown(value), fmt::join(rule.choices, ", "),
                               nearest(text, texts(rule.choices))));
      return;
    }
    const auto bytes = static_cast<double>(text.size());
    require(bytes >= rule.lo && bytes <= rule.hi && text.find('\0') == std::string::npos, value, rule, path);
  }
  void check_list(const SceneJson& value, const Rule& rule, const std::string& path) const {
    require(value.is_array(), value, rule, path);
    const auto length = static_cast<double>(value.size());
    require(length >= rule.lo && length <= rule.hi, value, rule, path);
    for (std::size_t i = 0; i < value.size(); ++i)
      check(value[i], *rule.parts[0], fmt::format("{}[{}]", path, i));
  }
  void check_record(const SceneJson& value, const Rule& rule, const std::string& path) const {
    require(value.is_object(), value, rule, path);
    std::vector<std::string> names;
    for (const RecordKey& key : rule.keys) names.emplace_back(key.name);
    for (const auto& [name, part] : value.items()) {
      const auto key = std::ranges::find(rule.keys, name, &RecordKey::name);
      const std::string here = fmt::format("{}{}{}", path, path.empty() ? "" : ".", printable(name));
      if (key != rule.keys.end()) check(part, *key->rule, here);
      else if (rule.others) check(part, *rule.others, here);
      else
        fail(here, fmt::format("found an unknown key, expected one of: {}{}", fmt::join(names, ", "),
                               nearest(name, names)));
    }
    for (const RecordKey& key : rule.keys)
      if (key.required && !value.contains(key.name))
        fail(path, fmt::format("the key '{}' is missing", key.name));
  }
  [[nodiscard]] const Rule& record_of(const SceneJson& value, const Rule& rule,
                                      const std::string& path) const {
    require(value.is_object(), value, rule, path);
    std::vector<std::string> words;
    for (const Rule* record : rule.parts) words.emplace_back(record->keys[0].rule->choices[0]);
    if (!value.contains("type"))
      fail(path, fmt::format("the key 'type' is missing, one of: {}", fmt::join(words, ", ")));
    const SceneJson& type = value["type"];
    const std::string word = type.is_string() ? type.get<std::string>() : "";
    for (std::size_t i = 0; i < words.size(); ++i)
      if (words[i] == word) return *rule.parts[i];
    fail(path + ".type", fmt::format("found {}, expected one of: {}{}", shown(type), fmt::join(words, ", "),
                                     nearest(word, words)));
  }
  // The alternative for the value's type of JSON says what is wrong.
  void check_either(const SceneJson& value, const Rule& rule, const std::string& path) const {
    for (const Rule* part : rule.parts)
      if (fits(value, part->kind)) return check(value, *part, path);
    require(false, value, rule, path);
  }
  static bool fits(const SceneJson& value, RuleKind kind) {
    switch (kind) {
      case RuleKind::number:
      case RuleKind::integer: return value.is_number();
      case RuleKind::boolean: return value.is_boolean();
      case RuleKind::text: return value.is_string();
      case RuleKind::list: return value.is_array();
      default: return value.is_object();
    }
  }
  // A stranger's key in a path.
  static std::string printable(const std::string& name) {
    const std::string quoted = in_quotes(name);
    return quoted.substr(1, quoted.size() - 2);
  }

  const std::string& source_;
};

}  // namespace

void check_rule(const SceneJson& value, const Rule& rule, const std::string& source) {
  Checker(source).check(value, rule, "");
}

}  // namespace isocast
