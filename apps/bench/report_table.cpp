#include <fmt/format.h>
#include <isocast/apps/bench/log_axis.h>
#include <isocast/apps/bench/plot.h>
#include <isocast/apps/bench/report_table.h>
#include <isocast/apps/bench/scatter_plot.h>

#include <algorithm>

namespace isocast::bench {
namespace {

void add_count(Markup& html, std::int64_t count) {
  html.element("td", {{"class", count == 0 ? "number zero" : "number bad"}}, grouped(count));
}

void add_number(Markup& html, const std::string& text) { html.element("td", {{"class", "number"}}, text); }

void add_row(Markup& html, const std::vector<std::string>& methods, const Row& row) {
  html.open("tr").open("td", {{"class", "name"}});
  add_method(html, methods, row.method);
  html.text(short_setting(row.setting)).close();
  html.element("td", {}, row.precision).element("td", {}, row.isa);
  add_number(html, short_time(row.seconds));
  add_number(html, short_time(row.seconds_mad));
  add_number(html, short_number(row.mrays_per_s));
  for (const std::int64_t count : {row.false_misses, row.false_hits, row.wrong_root, row.undecided})
    add_count(html, count);
  for (const double error : {row.t_error_p50, row.t_error_p99, row.t_error_max, row.normal_error_deg_max})
    add_number(html, short_number(error));
  html.element("td", {}, row.pareto ? "●" : "").close();
}

void add_table(Markup& html, const CaseRows& rows, const std::vector<const Row*>& some) {
  html.open("div", {{"class", "scroll"}}).open("table").open("tr");
  for (const char* name : {"method", "precision", "isa"}) html.element("th", {}, name);
  for (const char* name : {"time", "±", "10⁶ rays/s", "false misses", "false hits", "wrong roots",
                           "undecided", "error p50", "p99", "max", "normal max °"})
    html.element("th", {{"class", "number"}}, name);
  html.element("th", {}, "front").close();
  const std::vector<std::string> methods = methods_of(rows.rows);
  for (const Row* row : some) add_row(html, methods, *row);
  html.close().close();
}

}  // namespace

void add_method(Markup& html, const std::vector<std::string>& methods, const std::string& method) {
  const auto m = static_cast<std::size_t>(std::ranges::find(methods, method) - methods.begin());
  html.element("span", {{"class", "dot"}, {"style", fmt::format("background:{}", method_color(m))}})
      .text(method + " ");
}

void add_text_table(Markup& html, const std::vector<std::string>& columns,
                    const std::vector<std::vector<std::string>>& rows) {
  const auto kind = [](std::size_t column) -> std::string { return column == 0 ? "name" : "number"; };
  html.open("div", {{"class", "card scroll"}}).open("table").open("tr");
  for (std::size_t c = 0; c < columns.size(); ++c) html.element("th", {{"class", kind(c)}}, columns[c]);
  html.close();
  for (const std::vector<std::string>& row : rows) {
    html.open("tr");
    for (std::size_t c = 0; c < row.size(); ++c) html.element("td", {{"class", kind(c)}}, row[c]);
    html.close();
  }
  html.close().close();
}

void add_tables(Markup& html, const CaseRows& rows) {
  std::vector<const Row*> chosen, all;
  for (const Row& row : rows.rows) {
    all.push_back(&row);
    if (row.isa == rows.rows.back().isa && (row.pareto || row.setting.empty())) chosen.push_back(&row);
  }
  std::ranges::sort(chosen, {}, &Row::seconds);
  add_table(html, rows, chosen);
  html.open("details").element("summary", {}, fmt::format("All {} rows", all.size()));
  add_table(html, rows, all);
  html.close();
}

}  // namespace isocast::bench
