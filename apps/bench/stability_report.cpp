#include <fmt/format.h>
#include <isocast/apps/bench/log_axis.h>
#include <isocast/apps/bench/markup.h>
#include <isocast/apps/bench/report_style.h>
#include <isocast/apps/bench/stability_report.h>

#include <algorithm>

namespace isocast::bench {
namespace {

void add_head(Markup& html, const std::vector<StressResult>& results, const Provenance& from) {
  constexpr const char* kTitle = "isocast bench stability";
  html.open("head").element("meta", {{"charset", "utf-8"}}).element("title", {}, kTitle);
  html.open("style").append(kReportStyle).close().close();
  html.open("body").open("header").element("h1", {}, kTitle);
  html.element("p", {{"class", "soft"}},
               fmt::format("{} cases · {} ({} cores) · {} · commit {} · {}", results.size(), from.processor,
                           from.cores, from.compiler, from.commit, from.date));
  html.close();
}

// "as expected" or not, as a tag.
void add_tag(Markup& html, bool as_expected) {
  html.element("span", {{"class", as_expected ? "tag" : "tag double"}},
               as_expected ? "as expected" : "NOT AS EXPECTED");
}

void add_overview(Markup& html, const std::vector<StressResult>& results) {
  const auto good = std::ranges::count_if(results, &StressResult::as_expected);
  html.element("p", {}, fmt::format("{} of {} cases are as expected.", good, results.size()));
  html.open("div", {{"class", "card scroll"}}).open("table");
  for (const StressResult& result : results) {
    html.open("tr").open("td", {{"class", "name"}});
    html.element("a", {{"href", "#" + result.name}}, result.name).close();
    html.element("td", {}, result.stresses).open("td", {{"class", "name"}});
    add_tag(html, result.as_expected());
    html.close().close();
  }
  html.close().close();
}

void add_count(Markup& html, std::int64_t count, bool bad) {
  html.element("td", {{"class", count == 0 ? "number zero" : bad ? "number bad" : "number"}}, grouped(count));
}

void add_answers(Markup& html, const StressResult& result) {
  html.open("div", {{"class", "scroll"}}).open("table").open("tr");
  for (const char* name : {"method", "precision"}) html.element("th", {}, name);
  for (const char* name : {"right", "wrong", "undecided", "not known", "proved hits", "proved misses",
                           "false proofs", "largest error", "time"})
    html.element("th", {{"class", "number"}}, name);
  html.close();
  for (const StressAnswer& answer : result.answers) {
    html.open("tr").element("td", {{"class", "name"}}, answer.row.method);
    html.element("td", {}, answer.row.precision);
    add_count(html, answer.right(), false);
    add_count(html, answer.wrong(), true);
    add_count(html, answer.row.undecided, false);
    add_count(html, answer.row.undecided_reference, false);
    add_count(html, answer.counts.hits, false);
    add_count(html, answer.counts.misses, false);
    add_count(html, answer.counts.false_proofs, true);
    html.element("td", {{"class", "number"}}, short_number(answer.row.t_error_max));
    html.element("td", {{"class", "number"}}, short_time(answer.row.seconds)).close();
  }
  html.close().close();
}

void add_case(Markup& html, const StressResult& result) {
  html.element("h2", {{"id", result.name}}, result.name);
  html.element("p", {{"class", "soft"}}, result.stresses);
  html.open("div", {{"class", "card"}});
  for (const StressOutcome& outcome : result.outcomes) {
    html.open("p").text(outcome.expected + " ");
    add_tag(html, outcome.broken.empty());
    if (!outcome.broken.empty()) html.text(" found " + outcome.broken);
    html.close();
  }
  add_answers(html, result);
  html.close();
}

}  // namespace

std::string stability_html(const std::vector<StressResult>& results, const Provenance& provenance) {
  Markup html;
  html.append("<!DOCTYPE html>\n").open("html", {{"lang", "en"}});
  add_head(html, results, provenance);
  html.open("main");
  add_overview(html, results);
  for (const StressResult& result : results) add_case(html, result);
  html.element(
      "p", {{"class", "soft"}},
      "Wrong: false hits, false misses and hits that are nearer to another root than to the first "
      "crossing. Not known: rays that the reference leaves undecided. Errors are in voxels or domain "
      "widths, times of one run on one thread.");
  return html.finish();
}

}  // namespace isocast::bench
