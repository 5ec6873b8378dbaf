// The tables of report.html.
#pragma once

#include <isocast/apps/bench/case_finding.h>
#include <isocast/apps/bench/markup.h>

#include <string>
#include <vector>

namespace isocast::bench {

/// The method's name behind a dot of its colour, and a blank.
void add_method(Markup& html, const std::vector<std::string>& methods, const std::string& method);

/// A table of texts: the first column names what the numbers of the others are of.
void add_text_table(Markup& html, const std::vector<std::string>& columns,
                    const std::vector<std::vector<std::string>>& rows);

/// The rows of the fronts and the methods as they are meant to run, on the last instruction set; all rows
/// below, folded.
void add_tables(Markup& html, const CaseRows& rows);

}  // namespace isocast::bench
