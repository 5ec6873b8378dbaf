#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/apps/bench/claims.h>

#include <algorithm>
#include <cmath>

namespace isocast::bench {
namespace {

std::string text_of(double x) {
  return std::abs(x) < 1000 ? fmt::format("{:.3g}", x) : fmt::format("{:.0f}", x);
}

std::string text_of(const Bounds& bounds) {
  const bool least = std::isfinite(bounds.least), most = std::isfinite(bounds.most);
  if (bounds.least == bounds.most) return text_of(bounds.least);
  if (least && most) return fmt::format("{} to {}", text_of(bounds.least), text_of(bounds.most));
  return least ? "at least " + text_of(bounds.least) : "at most " + text_of(bounds.most);
}

}  // namespace

Claim measured(std::string id, std::string sentence, const std::string& what, Bounds bounds,
               const std::vector<double>& found) {
  Claim claim{std::move(id), std::move(sentence), what + ": " + text_of(bounds), {}, Outcome::not_testable};
  if (found.empty() || std::ranges::any_of(found, [](double x) { return std::isnan(x); })) {
    claim.found = "nothing to measure among the cases that were run";
    return claim;
  }
  const auto [least, most] = std::ranges::minmax(found);
  const auto within =
      std::ranges::count_if(found, [&](double x) { return x >= bounds.least && x <= bounds.most; });
  claim.found = least == most ? text_of(least) : fmt::format("{} to {}", text_of(least), text_of(most));
  if (within < std::ssize(found) && found.size() > 1)
    claim.found += fmt::format(", {} of {} within", within, found.size());
  claim.outcome = within == std::ssize(found) ? Outcome::reproduced : Outcome::refuted;
  return claim;
}

Claim untested(std::string id, std::string sentence, std::string why) {
  return {std::move(id), std::move(sentence), {}, std::move(why), Outcome::not_testable};
}

Claim later(std::string id, std::string sentence, std::string missing) {
  return {std::move(id), std::move(sentence), {}, std::move(missing), Outcome::later};
}

std::string_view word_of(Outcome outcome) {
  constexpr std::string_view kWords[] = {"reproduced", "refuted", "not testable here", "later"};
  return kWords[static_cast<int>(outcome)];
}

std::string tally_of(const std::vector<Claim>& claims) {
  std::vector<std::string> words;
  for (const Outcome outcome : {Outcome::reproduced, Outcome::refuted, Outcome::not_testable, Outcome::later})
    if (const auto count = std::ranges::count(claims, outcome, &Claim::outcome))
      words.push_back(fmt::format("{} {}", count, word_of(outcome)));
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace isocast::bench
