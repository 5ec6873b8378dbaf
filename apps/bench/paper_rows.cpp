#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/apps/bench/log_axis.h>
#include <isocast/apps/bench/paper_rows.h>
#include <isocast/implicit/expression/catalogue.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isocast::bench {

MethodSetting paper_setting(std::span<const Method> table, const std::string& method,
                            const std::map<std::string, std::string>& set) {
  constexpr std::pair<std::string_view, std::string_view> kOfPapers[] = {
      {"beams", "0"}, {"trim", "0"}, {"rounding", "nearest"}, {"certify", "0"}};
  const Method& row = find_method(table, method);
  MethodSetting setting{method, {}, row.proves, set};
  for (const auto& [option, value] : kOfPapers)
    if (std::ranges::find(row.options, option, &MethodOption::name) != row.options.end())
      setting.set.emplace(option, value);
  std::vector<std::string> words;
  for (const auto& [key, value] : setting.set) words.push_back(key + "=" + value);
  setting.text = fmt::format("{}", fmt::join(words, " "));
  (void)resolve_options(row, setting.set);
  return setting;
}

const Row* PaperRows::find(std::string_view case_name, std::string_view method, std::string_view setting,
                           Isa isa, std::string_view precision) const {
  const auto found = std::ranges::find_if(rows_, [&](const Row& row) {
    return row.case_name == case_name && row.method == method && row.setting == setting &&
           row.isa == name_of(isa) && row.precision == precision;
  });
  return found == rows_.end() ? nullptr : &*found;
}

double PaperRows::seconds(std::string_view case_name, std::string_view method, std::string_view setting,
                          Isa isa) const {
  const Row* const row = find(case_name, method, setting, isa);
  return row ? row->seconds : std::numeric_limits<double>::quiet_NaN();
}

PictureCase paper_surface(std::string_view id, int size) {
  const CatalogueSurface& record = require_surface(id);
  PictureCase picture{"papers", record.id, {}, size, size};
  picture.scene.objects.front().source = FormulaSource{surface_expression(record), record.domain};
  return picture;
}

std::string table_number(double value) { return std::isnan(value) ? "–" : short_number(value); }

Isa four_lanes() {
  const std::vector<Isa> isas = available_isas();
  return std::ranges::find(isas, Isa::sse4) == isas.end() ? isas.front() : Isa::sse4;
}

}  // namespace isocast::bench
