#include <fmt/format.h>
#include <imgui.h>
#include <isocast/apps/viewer/window/panels.h>
#include <isocast/base/module.h>
#include <isocast/isa/cpu.h>

#include <algorithm>

namespace isocast::viewer {
namespace {

const Method* row_of(const App& app) {
  const ObjectNews& news = app.object_news();
  const std::span<const Method> table = news.is_volume ? volume_methods() : formula_methods();
  const auto row = std::ranges::find(table, std::string_view(news.method), &Method::name);
  return row == table.end() ? nullptr : &*row;
}

std::string setting_of(const SessionObject& object, std::string_view option) {
  for (const std::string& word : object.set)
    if (word.starts_with(option) && word.size() > option.size() && word[option.size()] == '=')
      return word.substr(option.size() + 1);
  return {};
}
void set_option(SessionObject& object, std::string_view option, const std::string& value) {
  std::erase_if(object.set, [&](const std::string& word) {
    return word.starts_with(option) && word.size() > option.size() && word[option.size()] == '=';
  });
  object.set.push_back(fmt::format("{}={}", option, value));
}

// The `--set` options of the row, each as its kind asks for.
void option_row(App& app, const MethodOption& option) {
  SessionObject& object = app.session.object();
  const std::string typed = setting_of(object, option.name);
  const float width = 7 * ImGui::GetFontSize();
  const std::string name = fmt::format("method.{}", option.name);
  ImGui::SetNextItemWidth(width);
  if (!option.choices.empty()) {
    std::vector<std::string> names;
    for (const std::string_view word : isocast::words_of(option.choices)) names.emplace_back(word);
    std::string chosen = typed.empty() ? names[static_cast<std::size_t>(option.default_value)] : typed;
    if (choice(app, name.c_str(), names, chosen)) set_option(object, option.name, chosen);
  } else {
    double value = option.default_value;
    if (!typed.empty()) value = std::strtod(typed.c_str(), nullptr);
    bool on = value != 0;
    const bool is_switch = option.integer && option.lo == 0 && option.hi == 1;
    if (is_switch ? check_box(app, name.c_str(), "", on) : number_field(app, name.c_str(), value, width))
      set_option(object, option.name,
                 is_switch ? (on ? "1" : "0") : fmt::format("{}", std::clamp(value, option.lo, option.hi)));
  }
  ImGui::SameLine();
  ImGui::TextUnformatted(std::string(option.name).c_str());
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip(
        "%s", fmt::format("{}{}{}", option.meaning, option.unit.empty() ? "" : ", in ", option.unit).c_str());
}

// What rays are found with, of all objects; a GPU only where the program has its part.
void engine_row(App& app) {
  static const std::vector<std::string> engines = [] {
    std::vector<std::string> names = {"auto"};
    for (const Isa isa : available_isas()) names.emplace_back(name_of(isa));
    if (!find_part("isocast_cuda.so").empty()) names.emplace_back("cuda");
    return names;
  }();
  ImGui::SetNextItemWidth(rest_of_width(6.5f));
  choice(app, "method.isa", engines, app.session.words.isa);
  ImGui::SameLine();
  ImGui::TextUnformatted("processor");
}

}  // namespace

void method_panel(App& app) {
  SessionObject& object = app.session.object();
  const ObjectNews& news = app.object_news();
  if (news.methods.empty()) return wrapped("There is none to choose.");
  std::vector<std::string> methods = {"auto"};
  methods.insert(methods.end(), news.methods.begin(), news.methods.end());
  ImGui::SetNextItemWidth(rest_of_width(6.5f));
  if (choice(app, "method.name", methods, object.method)) object.set.clear();
  ImGui::SameLine();
  ImGui::SetNextItemWidth(rest_of_width(0));
  choice(app, "method.precision",
         news.is_volume ? std::vector<std::string>{"float", "double"}
                        : std::vector<std::string>{"float", "double", "mixed"},
         app.session.words.precision);
  engine_row(app);
  if (object.method == "auto" && !news.method.empty()) wrapped(news.method + ": " + news.method_reason);
  const Method* const row = row_of(app);
  if (!row) return;
  ImGui::TextUnformatted(fmt::format("proves {}", row->proves).c_str());
  if (row->options.empty() || object.method == "auto" || !ImGui::TreeNode("Options")) return;
  for (const MethodOption& option : row->options) option_row(app, option);
  ImGui::TreePop();
}

}  // namespace isocast::viewer
