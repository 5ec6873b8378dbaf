// The tables of report.html.
#pragma once

#include <isocast/apps/bench/case_finding.h>
#include <isocast/apps/bench/markup.h>

#include <string>
#include <vector>

namespace isocast::bench {

/// The method's name behind a dot of its colour, and a blank.
void add_method(Markup& html, const std::vector<std::string>& methods, const std::string& method);

/// The rows of the fronts and the methods as they are meant to run, on the last instruction set; all rows
/// below, folded.
void add_tables(Markup& html, const CaseRows& rows);

}  // namespace isocast::bench
