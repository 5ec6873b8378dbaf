#include <fmt/format.h>
#include <isocast/apps/bench/condition_plot.h>
#include <isocast/apps/bench/findings.h>
#include <isocast/apps/bench/papers.h>
#include <isocast/apps/bench/plot.h>
#include <isocast/apps/bench/report.h>
#include <isocast/apps/bench/report_style.h>
#include <isocast/apps/bench/report_table.h>
#include <isocast/apps/bench/scatter_plot.h>
#include <isocast/apps/bench/small_picture.h>
#include <isocast/base/output_file.h>

#include <algorithm>

namespace isocast::bench {
namespace {

// The name of a case in files and in links within the document.
std::string slug_of(const CaseRows& rows) {
  std::string slug = rows.suite + "_" + rows.name;
  std::ranges::replace_if(
      slug, [](unsigned char c) { return !std::isalnum(c) && c != '-' && c != '_'; }, '_');
  return slug.substr(0, 80);
}

std::vector<CaseRows> rows_of(const Report& report) {
  std::vector<CaseRows> all;
  for (const ReportCase& one : report.cases) all.push_back(one.rows);
  return all;
}

std::string condition_of(const CaseRows& rows) {
  return condition_plot(rows.conditions, methods_of(rows.rows), rows.unit);
}

void add_head(Markup& html, const Report& report) {
  html.open("head")
      .element("meta", {{"charset", "utf-8"}})
      .element("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}})
      .element("title", {}, report.title);
  html.open("style").append(kReportStyle).close().close();
}

std::string contents_of(const Report& report) {
  const auto count = [](std::size_t n, const char* what) {
    return n == 0 ? std::string() : fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
  };
  std::string contents;
  for (const std::string& part : {count(report.cases.size(), "case"), count(report.frames.size(), "frame"),
                                  count(report.papers.size(), "paper")})
    contents += (contents.empty() || part.empty() ? "" : ", ") + part;
  return contents;
}

void add_findings(Markup& html, const Report& report) {
  const Provenance& from = report.provenance;
  html.open("header").element("h1", {}, report.title);
  html.element("p", {{"class", "soft"}},
               fmt::format("{} · {} ({} cores) · {} · commit {} · {}", contents_of(report), from.processor,
                           from.cores, from.compiler, from.commit, from.date));
  if (!report.cases.empty()) {
    html.open("ol", {{"class", "findings"}});
    for (const std::string& sentence : findings(rows_of(report))) html.element("li", {}, sentence);
    html.close();
  }
  html.close();
}

// A method with its setting, and how long it takes.
void add_choice(Markup& html, const CaseRows& rows, const Row* row, const std::string& otherwise) {
  html.open("td");
  if (row) {
    add_method(html, methods_of(rows.rows), row->method);
    html.text(fmt::format("{} in {}", short_setting(row->setting), row->precision));
  } else {
    html.text("–");
  }
  if (!otherwise.empty()) html.element("div", {{"class", "soft"}}, otherwise);
  html.close().element("td", {{"class", "number"}}, row ? short_time(row->seconds) : "");
}

std::string doubts_about(const Row& best) {
  return best.failures() > 0 ? fmt::format("the best, but {} rays fail", grouped(best.failures()))
                             : fmt::format("the best, but a hit errs by {}", short_number(best.t_error_max));
}

// A line per case: what to use.
void add_overview(Markup& html, const Report& report) {
  const bool pictures =
      std::ranges::any_of(report.cases, [](const auto& one) { return !one.pictures.empty(); });
  const bool proofs =
      std::ranges::any_of(report.cases, [](const auto& one) { return examine(one.rows).proved != nullptr; });
  html.element("h2", {}, "Case by case");
  html.open("div", {{"class", "card scroll"}}).open("table").open("tr");
  if (pictures) html.element("th");
  for (const char* name : {"case", "fastest that is right"}) html.element("th", {}, name);
  html.element("th", {{"class", "number"}}, "time");
  if (proofs) html.element("th", {}, "fastest that proves, too").element("th", {{"class", "number"}}, "time");
  html.element("th", {}, "precision").element("th", {{"class", "wide"}}, "why").close();
  for (const ReportCase& one : report.cases) {
    const CaseFinding finding = examine(one.rows);
    html.open("tr");
    if (pictures) {
      html.open("td");
      if (!one.pictures.empty()) html.element("img", {{"src", one.pictures[0].url}, {"alt", one.rows.name}});
      html.close();
    }
    html.open("td").element("a", {{"href", fmt::format("#{}", slug_of(one.rows))}}, one.rows.name).close();
    add_choice(html, one.rows, finding.best, finding.right ? std::string() : doubts_about(*finding.best));
    if (proofs) add_choice(html, one.rows, finding.proved, {});
    html.open("td").element("span", {{"class", fmt::format("tag {}", finding.precision)}}, finding.precision);
    html.close().element("td", {{"class", "wide soft"}}, finding.reason).close();
  }
  html.close().close();
}

// The colours of error pictures.
void add_key(Markup& html) {
  std::string ramp = "background:linear-gradient(90deg";
  for (int e = 2 * kLeastError; e <= 2 * kLargestError; ++e)
    ramp += fmt::format(",{}", hex_of(error_color(std::pow(10.0, 0.5 * e))));
  html.open("p", {{"class", "soft"}}).text(fmt::format("Error {}", power_of_ten(kLeastError)));
  html.element("span", {{"class", "ramp"}, {"style", ramp + ")"}}).text(power_of_ten(kLargestError));
  const auto swatch = [&](Verdict verdict, const char* words) {
    html.element("span", {{"class", "swatch"},
                          {"style", fmt::format("background:{}", hex_of(verdict_color(verdict)))}})
        .text(words);
  };
  swatch(Verdict::miss, "rightly nothing");
  swatch(Verdict::false_miss, "wrong");
  swatch(Verdict::undecided, "undecided by the method");
  swatch(Verdict::unknown, "by the reference");
  html.close();
}

void add_case(Markup& html, const ReportCase& one) {
  const CaseRows& rows = one.rows;
  const CaseFinding finding = examine(rows);
  html.element("h2", {{"id", slug_of(rows)}}, rows.suite + " / " + rows.name);
  html.element("p", {{"class", "soft"}}, one.about);
  html.open("p").text("Recommended precision: ");
  html.element("span", {{"class", fmt::format("tag {}", finding.precision)}}, finding.precision);
  html.text(fmt::format(" {}.", finding.reason)).close();
  html.open("div", {{"class", "card"}});
  html.open("div", {{"class", rows.conditions.empty() ? "plots single" : "plots"}});
  html.open("div").append(scatter_plot(rows.rows, rows.unit)).close();
  if (!rows.conditions.empty()) html.open("div").append(condition_of(rows)).close();
  html.close();
  if (!one.pictures.empty()) {
    html.open("div", {{"class", "pictures"}});
    for (const ReportPicture& picture : one.pictures)
      html.open("figure")
          .element("img", {{"src", picture.url}, {"alt", picture.caption}})
          .element("figcaption", {}, picture.caption)
          .close();
    html.close();
    add_key(html);
  }
  add_tables(html, rows);
  html.close();
}

void add_reading(Markup& html, const Report& report) {
  html.open("footer").element("h2", {}, "How to read this");
  html.element(
      "p", {},
      "A ray fails if its answer is wrong (a false miss, a false hit, another root than the first) or "
      "undecided. Errors are distances along the ray between the hit and the first crossing of the "
      "reference, in voxels of volumes and in the longest edge of a formula's domain. A row counts "
      "as right here if no ray fails and no hit errs by more than 10⁻³.");
  html.element(
      "p", {},
      "The condition of a root is how far it moves when the field changes by its own scale: at 10⁶ a "
      "relative error of 10⁻⁷ moves it by a tenth of the unit.");
  html.element("p", {},
               "Times are medians of repetitions in turns; small marks are swept settings of a method's own "
               "knob. Point at a mark for its numbers.");
  for (const std::string& note : report.notes) html.element("p", {}, note);
  html.close();
}

}  // namespace

std::vector<ReportCase> cases_of(const std::vector<Row>& rows, const std::string& unit) {
  std::vector<ReportCase> cases;
  for (const Row& row : rows) {
    if (cases.empty() || cases.back().rows.name != row.case_name)
      cases.push_back(
          {{row.suite, row.case_name, unit, {}, {}}, fmt::format("{} rays", grouped(row.rays)), {}});
    cases.back().rows.rows.push_back(row);
  }
  return cases;
}

std::string html_of(const Report& report) {
  Markup html;
  html.append("<!DOCTYPE html>\n").open("html", {{"lang", "en"}});
  add_head(html, report);
  html.open("body");
  add_findings(html, report);
  html.open("main");
  if (!report.cases.empty()) add_overview(html, report);
  for (const ReportCase& one : report.cases) add_case(html, one);
  if (!report.frames.empty()) add_frames(html, report.frames);
  add_papers(html, report.papers);
  html.close();
  add_reading(html, report);
  return html.finish();
}

void write_report(const std::filesystem::path& folder, const Report& report) {
  for (const ReportCase& one : report.cases) {
    const std::string slug = slug_of(one.rows);
    write_text_file(folder / (slug + ".svg"), scatter_plot(one.rows.rows, one.rows.unit));
    if (!one.rows.conditions.empty())
      write_text_file(folder / (slug + "_condition.svg"), condition_of(one.rows));
  }
  if (!report.frames.empty()) write_text_file(folder / "frames.svg", frames_plot(report.frames));
  write_text_file(folder / "report.html", html_of(report));
}

}  // namespace isocast::bench
