// The suite `papers`: what the papers measured and claimed, with our figures beside it.
#pragma once

#include <isocast/apps/bench/markup.h>
#include <isocast/apps/bench/paper.h>

namespace isocast::bench {

/// All papers, those whose methods are missing with their claims only. Progress goes to stderr.
[[nodiscard]] std::vector<Paper> run_papers(const PaperWishes& wishes);

/// Every paper with its claims and verdicts, as text.
[[nodiscard]] std::string papers_summary(const std::vector<Paper>& papers);

/// Every paper as a part of report.html: claims first, then the tables.
void add_papers(Markup& html, const std::vector<Paper>& papers);

}  // namespace isocast::bench
