// isocast methods: every method, what it applies to and proves, its options and defaults.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/apps/isocast/verbs.h>
#include <isocast/implicit/methods.h>
#include <isocast/volume/methods.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

namespace isocast::verbs {
namespace {

nlohmann::ordered_json to_json(const Method& method) {
  nlohmann::ordered_json json = {{"name", method.name},
                                 {"applies_to", method.applies_to},
                                 {"proves", method.proves},
                                 {"arithmetic", method.arithmetic},
                                 {"precisions", method.precisions}};
  json["options"] = nlohmann::ordered_json::array();
  for (const MethodOption& option : method.options) {
    nlohmann::ordered_json entry = {{"name", option.name}, {"default", option.default_value}};
    entry["range"] = {option.lo, option.hi};
    if (!option.choices.empty()) {
      const auto words = words_of(option.choices);
      entry["default"] = words[static_cast<std::size_t>(option.default_value)];
      entry["range"] = words;
    }
    entry["unit"] = option.unit;
    entry["meaning"] = option.meaning;
    json["options"].push_back(entry);
  }
  json["source"] = method.source;
  return json;
}

void print(const Method& method) {
  fmt::print("{}: for a {}, proves {}, {} arithmetic, {}\n  {}\n", method.name, method.applies_to,
             method.proves, method.arithmetic, method.precisions, method.source);
  for (const MethodOption& option : method.options) {
    if (!option.choices.empty()) {
      const auto words = words_of(option.choices);
      fmt::print("  --set {}={}  ({})  {}\n", option.name,
                 words[static_cast<std::size_t>(option.default_value)], fmt::join(words, ", "),
                 option.meaning);
      continue;
    }
    fmt::print("  --set {}={}  ({} to {}{}{})  {}\n", option.name, option.default_value, option.lo, option.hi,
               option.unit.empty() ? "" : " ", option.unit, option.meaning);
  }
}

std::vector<Method> all_methods() {
  const auto volumes = volume_methods(), formulas = formula_methods();
  std::vector<Method> all(volumes.begin(), volumes.end());
  all.insert(all.end(), formulas.begin(), formulas.end());
  return all;
}

void run(bool json) {
  if (json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Method& method : all_methods()) list.push_back(to_json(method));
    fmt::print("{}\n", list.dump(2));
  } else {
    for (const Method& method : all_methods()) print(method);
    fmt::print(
        "--method auto takes marmitt for volumes, and for formulas interval, affine or certified, whichever "
        "costs less on a probe.\n");
  }
}

}  // namespace

void add_methods(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "methods", "Every method: what it applies to, what it proves, its options and defaults");
  const auto json = std::make_shared<bool>(false);
  verb->add_flag("--json", *json, "A JSON list on stdout");
  verb->callback([json] { run(*json); });
}

}  // namespace isocast::verbs
