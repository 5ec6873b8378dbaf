#include <fmt/format.h>
#include <isocast/apps/bench/case_finding.h>
#include <isocast/apps/bench/log_axis.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

namespace isocast::bench {
namespace {

// How far a row is from right; less is better.
std::pair<std::int64_t, bool> wrongness(const Row& row) {
  return {row.failures(), row.t_error_max > kGoodError};
}

bool is_right(const Row& row) { return wrongness(row) == std::pair(std::int64_t{0}, false); }

bool is_better(const Row& a, const Row& b) {
  return std::pair(wrongness(a), a.seconds) < std::pair(wrongness(b), b.seconds);
}

// The first decade of condition in which the method fails, or errs too much, in float.
std::optional<int> end_of_float(const CaseRows& rows, const std::string& method) {
  for (const ConditionCurve& curve : rows.conditions)
    if (curve.method == method && curve.precision == "float")
      for (const ConditionBin& bin : curve.bins)
        if (bin.failures > 0 || bin.max > kGoodError) return bin.decade;
  return std::nullopt;
}

void recommend(const CaseRows& rows, CaseFinding& finding) {
  std::vector<PrecisionPair> pairs = precision_pairs(rows);
  const auto proves = [](const PrecisionPair& pair) { return pair.narrow->proves != "nothing"; };
  if (std::ranges::any_of(pairs, proves)) std::erase_if(pairs, std::not_fn(proves));
  if (pairs.empty()) {
    finding.precision = finding.best->precision;
    finding.reason = "no other precision was run";
    return;
  }
  const Row *narrow = pairs.front().narrow, *wide = pairs.front().wide;
  for (const PrecisionPair& pair : pairs) {
    if (is_better(*pair.narrow, *narrow)) narrow = pair.narrow;
    if (is_better(*pair.wide, *wide)) wide = pair.wide;
  }
  const bool enough = wrongness(*narrow) <= wrongness(*wide);
  const Row& chosen = enough ? *narrow : *wide;
  finding.precision = chosen.precision;
  const std::string answers =
      chosen.failures() == 0
          ? "is right at every ray"
          : fmt::format("fails at {} of {} rays", grouped(chosen.failures()), grouped(chosen.rays));
  finding.reason = fmt::format("{} {} and errs by at most {} {}", name_of(chosen), answers,
                               short_number(chosen.t_error_max), rows.unit);
  if (!enough)
    finding.reason += fmt::format("; in float {} fails at {} and errs by {}", name_of(*narrow),
                                  grouped(narrow->failures()), short_number(narrow->t_error_max));
  if (const auto decade = end_of_float(rows, chosen.method))
    finding.reason += fmt::format("; its float is right up to condition {}", power_of_ten(*decade));
}

}  // namespace

std::string name_of(const Row& row) {
  return row.setting.empty() ? row.method : row.method + " " + short_setting(row.setting);
}

const Row* twin(const CaseRows& rows, const Row& row, std::string_view isa, std::string_view precision) {
  const auto found = std::ranges::find_if(rows.rows, [&](const Row& other) {
    return other.method == row.method && other.setting == row.setting && other.isa == isa &&
           other.precision == precision;
  });
  return found == rows.rows.end() ? nullptr : &*found;
}

std::vector<PrecisionPair> precision_pairs(const CaseRows& rows) {
  std::vector<PrecisionPair> pairs;
  for (const Row& row : rows.rows) {
    if (row.isa != rows.rows.back().isa || row.precision != "float") continue;
    if (const Row* const wide = twin(rows, row, row.isa, "double")) pairs.push_back({&row, wide});
  }
  return pairs;
}

CaseFinding examine(const CaseRows& rows) {
  CaseFinding finding;
  for (const Row& row : rows.rows) {
    if (row.isa != rows.rows.back().isa) continue;
    if (!finding.best || is_better(row, *finding.best)) finding.best = &row;
    if (row.proves == "nothing" || !is_right(row)) continue;
    if (!finding.proved || row.seconds < finding.proved->seconds) finding.proved = &row;
  }
  finding.right = is_right(*finding.best);
  recommend(rows, finding);
  return finding;
}

}  // namespace isocast::bench
