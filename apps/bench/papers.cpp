#include <fmt/format.h>
#include <isocast/apps/bench/claims.h>
#include <isocast/apps/bench/papers.h>
#include <isocast/apps/bench/report_table.h>
#include <isocast/base/progress.h>

namespace isocast::bench {
namespace {

constexpr Paper (*kPapers[])(const PaperWishes&) = {marmitt_paper, knoll_paper, singh_paper, reimers_paper,
                                                    ganacim_paper};

std::string_view class_of(Outcome outcome) {
  constexpr std::string_view kClasses[] = {"tag good", "tag refuted", "tag none", "tag none"};
  return kClasses[static_cast<int>(outcome)];
}

void add_claims(Markup& html, const Paper& paper) {
  html.element("p", {}, tally_of(paper.claims) + ".");
  html.open("div", {{"class", "card scroll"}}).open("table").open("tr");
  for (const char* name : {"id", "claim", "verdict", "reproduced if", "found"}) html.element("th", {}, name);
  html.close();
  for (const Claim& claim : paper.claims) {
    html.open("tr").element("td", {{"class", "name"}}, claim.id).element("td", {}, claim.sentence);
    html.open("td").element("span", {{"class", std::string(class_of(claim.outcome))}},
                            word_of(claim.outcome));
    html.close().element("td", {{"class", "soft"}}, claim.expected).element("td", {}, claim.found).close();
  }
  html.close().close();
}

}  // namespace

std::vector<Paper> run_papers(const PaperWishes& wishes) {
  std::vector<Paper> papers;
  Progress progress("bench papers", std::ssize(kPapers));
  for (const auto& paper : kPapers) {
    papers.push_back(paper(wishes));
    progress.add();
  }
  return papers;
}

std::string papers_summary(const std::vector<Paper>& papers) {
  std::string text;
  for (const Paper& paper : papers) {
    text += fmt::format("{}\n  {}\n", paper.source, tally_of(paper.claims));
    for (const Claim& claim : paper.claims)
      text += fmt::format("  {:13} {:17} {}{}: {}\n", claim.id, word_of(claim.outcome), claim.sentence,
                          claim.expected.empty() ? "" : " (" + claim.expected + ")", claim.found);
  }
  return text;
}

void add_papers(Markup& html, const std::vector<Paper>& papers) {
  for (const Paper& paper : papers) {
    html.element("h2", {}, paper.source);
    for (const std::string& note : paper.notes) html.element("p", {{"class", "soft"}}, note);
    add_claims(html, paper);
    for (const PaperTable& table : paper.tables) {
      html.element("h3", {}, table.id + ": " + table.title);
      add_text_table(html, table.columns, table.rows);
    }
  }
}

}  // namespace isocast::bench
