#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/apps/bench/findings.h>
#include <isocast/apps/bench/log_axis.h>

#include <algorithm>
#include <map>

namespace isocast::bench {
namespace {

using Cases = std::span<const CaseRows>;

double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

// "affine in 5, marmitt in 2", of so many cases each.
std::string ranking(const std::map<std::string, int>& counts) {
  std::vector<std::pair<int, std::string>> order;
  for (const auto& [method, count] : counts) order.emplace_back(-count, method);
  std::ranges::sort(order);
  std::vector<std::string> words;
  for (const auto& [count, method] : order) words.push_back(fmt::format("{} in {}", method, -count));
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string best_methods(Cases cases) {
  std::map<std::string, int> best, proved;
  std::vector<std::string> open;
  for (const CaseRows& rows : cases) {
    const CaseFinding finding = examine(rows);
    if (finding.right) ++best[finding.best->method];
    else open.push_back(rows.name);
    if (finding.proved) ++proved[finding.proved->method];
  }
  std::string text = open.empty()
                         ? "In every case some method is right at all rays."
                         : fmt::format("In {} of {} cases some method is right at all rays, but none in {}.",
                                       cases.size() - open.size(), cases.size(), fmt::join(open, ", "));
  if (!best.empty()) text += fmt::format(" The fastest of these is {}.", ranking(best));
  if (!proved.empty()) text += fmt::format(" Where it shall prove its answers, it is {}.", ranking(proved));
  return text;
}

// Failures of methods as they are meant to run, on one instruction set in float, and where most are.
std::string failures(Cases cases) {
  struct Sum {
    std::int64_t failed = 0, undecided = 0, rays = 0, most = 0;
    std::string where;
  };
  std::map<std::string, Sum> sums;
  for (const CaseRows& rows : cases)
    for (const PrecisionPair& pair : precision_pairs(rows)) {
      const Row& row = *pair.narrow;
      Sum& sum = sums[name_of(row)];
      sum.failed += row.failures();
      sum.undecided += row.undecided;
      sum.rays += row.rays;
      if (row.failures() > sum.most) sum.most = row.failures(), sum.where = rows.name;
    }
  std::vector<std::string> none;
  std::vector<std::pair<std::int64_t, std::string>> some;
  for (const auto& [name, sum] : sums) {
    if (sum.failed == 0) none.push_back(name);
    else
      some.emplace_back(
          -sum.failed,
          fmt::format("{} at {} of {} rays ({}{} in {})", name, grouped(sum.failed), grouped(sum.rays),
                      sum.undecided == sum.failed ? "all undecided, " : "", grouped(sum.most), sum.where));
  }
  if (sums.empty()) return {};
  std::ranges::sort(some);
  if (some.size() > 4) some.resize(4);
  std::vector<std::string> words;
  for (const auto& [count, text] : some) words.push_back(text);
  std::string text = words.empty() ? "In float no method failed anywhere."
                                   : fmt::format("Failures in float: {}.", fmt::join(words, "; "));
  if (!none.empty() && !words.empty()) text += fmt::format(" None: {}.", fmt::join(none, ", "));
  return text;
}

std::string instruction_sets(Cases cases) {
  const std::string narrow = cases.front().rows.front().isa, wide = cases.front().rows.back().isa;
  if (narrow == wide) return {};
  std::map<std::string, std::vector<double>> gains[2];
  std::vector<double> all[2];
  for (const CaseRows& rows : cases)
    for (const Row& row : rows.rows) {
      const Row* slow = row.isa == wide ? twin(rows, row, narrow, row.precision) : nullptr;
      if (!slow) continue;
      const bool precise = row.precision == "double";
      gains[precise][row.method].push_back(slow->seconds / row.seconds);
      all[precise].push_back(slow->seconds / row.seconds);
    }
  std::pair<double, std::string> least = {1e300, ""}, most = {0, ""};
  for (const auto& [method, ratios] : gains[0]) {
    least = std::min(least, {median(ratios), method});
    most = std::max(most, {median(ratios), method});
  }
  std::string text = fmt::format("Against {}, {} takes", wide, narrow);
  if (!all[0].empty()) text += fmt::format(" {:.1f} times as long in float", median(all[0]));
  if (!all[1].empty())
    text += fmt::format("{} {:.1f} times in double", all[0].empty() ? "" : " and", median(all[1]));
  text += " (medians)";
  if (!least.second.empty() && least.second != most.second)
    text += fmt::format("; in float most for {} ({:.1f}), least for {} ({:.1f})", most.second, most.first,
                        least.second, least.first);
  return text + ".";
}

std::string double_precision(Cases cases) {
  std::vector<double> times, narrow_errors, wide_errors;
  std::int64_t narrow_failures = 0, wide_failures = 0;
  for (const CaseRows& rows : cases)
    for (const PrecisionPair& pair : precision_pairs(rows)) {
      times.push_back(pair.wide->seconds / pair.narrow->seconds);
      narrow_errors.push_back(pair.narrow->t_error_p50);
      wide_errors.push_back(pair.wide->t_error_p50);
      narrow_failures += pair.narrow->failures();
      wide_failures += pair.wide->failures();
    }
  if (times.empty()) return {};
  return fmt::format(
      "Double takes {:.2f} times as long as float (median). With it the failed rays of all methods and cases "
      "go "
      "from {} to {}, and the median error from {} to {}.",
      median(times), grouped(narrow_failures), grouped(wide_failures), short_number(median(narrow_errors)),
      short_number(median(wide_errors)));
}

std::string where_float_ends(Cases cases) {
  std::vector<std::string> words;
  bool compared = false;
  for (const CaseRows& rows : cases) {
    compared |= !precision_pairs(rows).empty();
    if (examine(rows).precision == "double") words.push_back(rows.name);
  }
  if (!compared) return {};
  if (words.empty()) return "Float is enough in every case: double is not more right anywhere.";
  return fmt::format(
      "Float is enough in {} of {} cases. Double is recommended for {}, where it is right at rays at which "
      "float is not.",
      cases.size() - words.size(), cases.size(), fmt::join(words, ", "));
}

}  // namespace

std::vector<std::string> findings(Cases cases) {
  std::vector<std::string> all;
  if (cases.empty()) return all;
  for (const auto& sentence : {best_methods, failures, instruction_sets, double_precision, where_float_ends})
    if (std::string text = sentence(cases); !text.empty()) all.push_back(std::move(text));
  return all;
}

}  // namespace isocast::bench
