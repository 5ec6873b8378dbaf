#include <isocast/apps/scene_build/scene_json.h>

#include <limits>

namespace isocast {
namespace {

using Schema = nlohmann::ordered_json;

// Collects the definitions of named rules while it writes the others in place.
class Writer {
 public:
  Schema write(const Rule& rule) {
    if (rule.name.empty()) return body(rule);
    const std::string name(rule.name);
    if (!definitions_.contains(name)) {
      definitions_[name] = Schema::object();
      definitions_[name] = body(rule);
    }
    return {{"$ref", "#/$defs/" + name}};
  }
  [[nodiscard]] const Schema& definitions() const { return definitions_; }

 private:
  Schema body(const Rule& rule) {
    switch (rule.kind) {
      case RuleKind::number: return with_range(rule, {{"type", "number"}}, "minimum", "maximum");
      case RuleKind::integer: return with_range(rule, {{"type", "integer"}}, "minimum", "maximum");
      case RuleKind::boolean: return {{"type", "boolean"}};
      case RuleKind::text:
        if (!rule.choices.empty()) return {{"enum", rule.choices}};
        return with_range(rule, {{"type", "string"}}, "minLength", "maxLength");
      case RuleKind::list: {
        Schema list = with_range(rule, {{"type", "array"}}, "minItems", "maxItems");
        list["items"] = write(*rule.parts[0]);
        return list;
      }
      case RuleKind::record: return record(rule);
      default: break;
    }
    Schema parts = Schema::array();
    for (const Rule* part : rule.parts) parts.push_back(write(*part));
    return {{rule.kind == RuleKind::tagged ? "oneOf" : "anyOf", parts}};
  }
  Schema record(const Rule& rule) {
    Schema keys = Schema::object(), required = Schema::array();
    for (const RecordKey& key : rule.keys) {
      Schema value = write(*key.rule);
      if (!key.meaning.empty()) value["description"] = key.meaning;
      keys[std::string(key.name)] = value;
      if (key.required) required.push_back(key.name);
    }
    Schema schema = {{"type", "object"}};
    if (!rule.keys.empty()) schema["properties"] = keys;
    if (!required.empty()) schema["required"] = required;
    schema["additionalProperties"] = rule.others ? write(*rule.others) : Schema(false);
    return schema;
  }
  static Schema with_range(const Rule& rule, Schema schema, const char* lo, const char* hi) {
    constexpr double kLargest = std::numeric_limits<double>::max();
    const auto bound = [](double x) {
      return x == static_cast<double>(static_cast<std::int64_t>(x)) ? Schema(static_cast<std::int64_t>(x))
                                                                    : Schema(x);
    };
    if (rule.lo > -kLargest) schema[rule.above ? "exclusiveMinimum" : lo] = bound(rule.lo);
    if (rule.hi < kLargest) schema[hi] = bound(rule.hi);
    return schema;
  }

  Schema definitions_ = Schema::object();
};

}  // namespace

std::string schema_of(const Rule& rule) {
  Writer writer;
  Schema schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "isocast scene"}};
  schema.update(writer.write(rule));
  schema["$defs"] = writer.definitions();
  return schema.dump(2) + "\n";
}

}  // namespace isocast
