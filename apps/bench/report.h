// report.html: what was run on what, the findings, a plot, a table and pictures per case, and papers, in one
// file.
#pragma once

#include <isocast/apps/bench/case_finding.h>
#include <isocast/apps/bench/frames.h>
#include <isocast/apps/bench/paper.h>
#include <isocast/apps/bench/rows.h>

#include <filesystem>
#include <string>
#include <vector>

namespace isocast::bench {

/// One small picture: `url` holds the data.
struct ReportPicture {
  std::string caption, url;
};

/// about     what the case is, in a line
/// pictures  the right one first; none of cases without pictures
struct ReportCase {
  CaseRows rows;
  std::string about;
  std::vector<ReportPicture> pictures;
};

/// frames  of growing volumes, behind the cases
/// papers  with their tables and claims, behind these
/// notes   sentences about how it was measured
struct Report {
  std::string title;
  Provenance provenance;
  std::vector<ReportCase> cases;
  std::vector<std::string> notes;
  std::vector<Paper> papers = {};
  std::vector<FrameTimes> frames = {};
};

/// A case without pictures for each name in some rows, in their order.
[[nodiscard]] std::vector<ReportCase> cases_of(const std::vector<Row>& rows, const std::string& unit);

/// A document that refers to nothing outside itself and opens without a network.
[[nodiscard]] std::string html_of(const Report& report);

/// report.html, and the plots as SUITE_CASE.svg, SUITE_CASE_condition.svg and frames.svg, in a prepared
/// folder.
void write_report(const std::filesystem::path& folder, const Report& report);

}  // namespace isocast::bench
