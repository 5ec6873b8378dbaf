// Verdicts on claims, from measured numbers.
#pragma once

#include <isocast/apps/bench/paper.h>

#include <limits>

namespace isocast::bench {

/// least <= number <= most.
struct Bounds {
  double least = -std::numeric_limits<double>::infinity(), most = std::numeric_limits<double>::infinity();
};

/// Reproduced if every number lies within the bounds, else refuted; not testable without numbers, or with one
/// that is NaN: then something it needs was not run, or is 0/0.
///
/// what  the number, in words
[[nodiscard]] Claim measured(std::string id, std::string sentence, const std::string& what, Bounds bounds,
                             const std::vector<double>& found);

/// Not testable by this bench, because of `why`.
[[nodiscard]] Claim untested(std::string id, std::string sentence, std::string why);

/// Testable when there is what is `missing`.
[[nodiscard]] Claim later(std::string id, std::string sentence, std::string missing);

/// "reproduced", "refuted", "not testable here", "later".
[[nodiscard]] std::string_view word_of(Outcome outcome);

/// "12 reproduced, 3 refuted, ...", those that occur.
[[nodiscard]] std::string tally_of(const std::vector<Claim>& claims);

}  // namespace isocast::bench
