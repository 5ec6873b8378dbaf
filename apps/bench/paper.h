// What a paper measured and claimed, with our figures beside it.
#pragma once

#include <isocast/apps/bench/rows.h>

#include <filesystem>
#include <string>
#include <vector>

namespace isocast::bench {

/// refuted: measured otherwise. later: needs a method or a stage of rendering that the bench does not have.
enum class Outcome { reproduced, refuted, not_testable, later };

/// id        of the claim, such as R-MAR-2
/// expected  the number that decides, and its bounds
/// found     the numbers, or why there are none
struct Claim {
  std::string id, sentence, expected, found;
  Outcome outcome;
};

/// In the paper's layout; every row has a cell for each column, the first names it.
struct PaperTable {
  std::string id, title;
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// notes  sentences about settings, data and how the figures compare
struct Paper {
  std::string source;
  std::vector<std::string> notes;
  std::vector<PaperTable> tables;
  std::vector<Claim> claims;
  std::vector<Row> rows;
};

/// quick   fewer cases, smaller pictures
/// folder  exists; volumes that are made lie in its `volumes`
/// data    folder of bonsai, aneurism and engine; empty: test volumes instead
/// cache   of the reference's answers; empty: none
struct PaperWishes {
  bool quick = false;
  std::filesystem::path folder, data, cache;
};

[[nodiscard]] Paper marmitt_paper(const PaperWishes& wishes);
[[nodiscard]] Paper knoll_paper(const PaperWishes& wishes);
[[nodiscard]] Paper singh_paper(const PaperWishes& wishes);
[[nodiscard]] Paper reimers_paper(const PaperWishes& wishes);
[[nodiscard]] Paper ganacim_paper(const PaperWishes& wishes);

}  // namespace isocast::bench
