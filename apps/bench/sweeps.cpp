#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/apps/bench/sweeps.h>
#include <isocast/apps/scene_build/applicable_methods.h>
#include <isocast/implicit/methods.h>
#include <isocast/volume/methods.h>

#include <algorithm>
#include <cmath>

namespace isocast::bench {
namespace {

// The option that trades a method's time for error, and its values; of `longest` where they are lengths. A
// method's knob is the first of these that it has (`eps` is a length where there is an eps-rel).
struct Knob {
  std::string_view option;
  bool length;
  std::vector<double> values, quick_values;
};

std::vector<double> powers_of_half(std::initializer_list<int> exponents) {
  std::vector<double> powers;
  for (const int exponent : exponents) powers.push_back(std::ldexp(1.0, -exponent));
  return powers;
}

const std::vector<Knob>& knobs() {
  static const std::vector<Knob> all = {
      {"eps-rel", false, powers_of_half({6, 8, 10, 12, 14, 16, 18, 20, 22, 24}),
       powers_of_half({6, 10, 14, 18})},
      {"eps", false, powers_of_half({6, 8, 10, 12, 14, 16, 18, 20}), powers_of_half({6, 10, 14})},
      {"step", true, powers_of_half({5, 6, 7, 8, 9, 10, 11, 12}), powers_of_half({6, 8, 10})},
      {"iterations", false, {1, 2, 3, 4, 5, 6, 8, 10}, {1, 3, 10}}};
  return all;
}

// What else a method may do otherwise than by default; tried at its default knob.
struct Switch {
  const char *option, *value;
};
constexpr Switch kSwitches[] = {{"stop", "value"}, {"certify", "0"}};

bool has_option(const Method& method, std::string_view option) {
  return std::ranges::find(method.options, option, &MethodOption::name) != method.options.end();
}

const Knob* knob_of(const Method& method) {
  const auto found =
      std::ranges::find_if(knobs(), [&](const Knob& knob) { return has_option(method, knob.option); });
  return found == knobs().end() ? nullptr : &*found;
}

std::string text_of(const std::map<std::string, std::string>& set) {
  std::vector<std::string> words;
  for (const auto& [key, value] : set) words.push_back(key + "=" + value);
  return fmt::format("{}", fmt::join(words, " "));
}

}  // namespace

std::vector<MethodSetting> method_settings(const ObjectDescription& object, const SettingWishes& wishes,
                                           double longest) {
  const bool volume = std::holds_alternative<VolumeSource>(object.source);
  const std::span<const Method> table = volume ? volume_methods() : formula_methods();
  const std::vector<Method> applicable = applicable_methods(object);
  std::vector<const Method*> methods;
  for (const std::string& name : wishes.wanted) methods.push_back(&find_method(table, name));
  if (wishes.wanted.empty())
    for (const Method& method : applicable) methods.push_back(&method);

  std::vector<MethodSetting> settings;
  const auto add = [&](const Method& method, const std::map<std::string, std::string>& set, bool swept) {
    (void)resolve_options(method, set);
    settings.push_back({std::string(method.name), text_of(set), method.proves, set, swept});
  };
  const auto text_of_value = [&](const Knob& knob, double value) {
    return fmt::format("{}", knob.length ? value * longest : value);
  };
  for (const Method* method : methods) add(*method, wishes.set, false);
  if (!wishes.set.empty()) return settings;
  for (const Method* method : methods)
    if (const Knob* knob = knob_of(*method))
      for (const double value : wishes.quick ? knob->quick_values : knob->values)
        add(*method, {{std::string(knob->option), text_of_value(*knob, value)}}, true);
  for (const Method* method : methods)
    for (const auto& [option, value] : kSwitches)
      if (has_option(*method, option)) add(*method, {{option, value}}, true);
  return settings;
}

}  // namespace isocast::bench
