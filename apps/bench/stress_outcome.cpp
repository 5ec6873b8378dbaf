#include <fmt/format.h>
#include <isocast/apps/bench/stress_run.h>

#include <algorithm>

namespace isocast::bench {
namespace {

std::string name_of(const StressAnswer& answer) {
  return fmt::format("{} in {}", answer.row.method, answer.row.precision);
}

std::string_view words_of(Counted counted) {
  switch (counted) {
    case Counted::wrong: return "wrong at";
    case Counted::undecided: return "undecided at";
    case Counted::proved_hit: return "a proved hit at";
    case Counted::proved_miss: return "a proved miss at";
  }
  return {};
}

std::string_view methods_of(const Expectation& e) {
  if (e.method.empty()) return "every method";
  return e.method == kProving ? "every method that proves" : e.method;
}

std::string sentence_of(const Expectation& e) {
  const std::string share = e.most == 0      ? "none"
                            : e.least == 100 ? "all"
                            : e.least == 0   ? fmt::format("at most {} %", e.most)
                            : e.most == 100  ? fmt::format("at least {} %", e.least)
                                             : fmt::format("{} to {} %", e.least, e.most);
  return fmt::format("{}{}: {} {} of the rays", methods_of(e),
                     e.precision.empty() ? "" : fmt::format(" in {}", e.precision), words_of(e.counted),
                     share);
}

bool concerns(const Expectation& e, const StressAnswer& answer) {
  const bool proves = answer.row.proves != "nothing";
  return (e.method.empty() ||
          (e.method == kProving && proves && !answer.row.method.starts_with("frustum-")) ||
          e.method == answer.row.method) &&
         (e.precision.empty() || e.precision == answer.row.precision);
}

void add_break(StressOutcome& outcome, const std::string& what) {
  outcome.broken += (outcome.broken.empty() ? "" : "; ") + what;
}

}  // namespace

std::int64_t StressAnswer::count(Counted counted) const {
  switch (counted) {
    case Counted::wrong: return wrong();
    case Counted::undecided: return row.undecided;
    case Counted::proved_hit: return counts.hits;
    case Counted::proved_miss: return counts.misses;
  }
  return 0;
}

bool StressResult::as_expected() const {
  return std::ranges::all_of(outcomes, [](const StressOutcome& outcome) { return outcome.broken.empty(); });
}

std::vector<StressOutcome> outcomes_of(const std::vector<Expectation>& expected,
                                       const std::vector<StressAnswer>& answers) {
  std::vector<StressOutcome> outcomes = {{"no proof is false", {}}, {"no answer is malformed", {}}};
  for (const StressAnswer& answer : answers) {
    const StressCounts& counts = answer.counts;
    if (counts.false_proofs > 0)
      add_break(outcomes[0], fmt::format("{}: {}", name_of(answer), counts.false_proofs));
    if (counts.malformed > 0)
      add_break(outcomes[1], fmt::format("{}: {}", name_of(answer), counts.malformed));
  }
  for (const Expectation& e : expected) {
    StressOutcome& outcome = outcomes.emplace_back(StressOutcome{sentence_of(e), {}});
    for (const StressAnswer& answer : answers) {
      const double share =
          100 * static_cast<double>(answer.count(e.counted)) / static_cast<double>(answer.row.rays);
      if (concerns(e, answer) && !(share >= e.least && share <= e.most))
        add_break(outcome, fmt::format("{}: {:.3g} %", name_of(answer), share));
    }
  }
  return outcomes;
}

}  // namespace isocast::bench
