// The rows of one case, and what they say of it.
#pragma once

#include <isocast/apps/bench/condition.h>
#include <isocast/apps/bench/rows.h>

#include <string>
#include <string_view>
#include <vector>

namespace isocast::bench {

/// A case of the report; never without rows, and the last one's instruction set is the widest. `conditions`
/// may be empty: of cases that have none.
struct CaseRows {
  std::string suite, name, unit;
  std::vector<Row> rows;
  std::vector<ConditionCurve> conditions;
};

/// Method and setting, for readers.
[[nodiscard]] std::string name_of(const Row& row);
/// The row of the same method and setting, or null.
[[nodiscard]] const Row* twin(const CaseRows& rows, const Row& row, std::string_view isa,
                              std::string_view precision);

/// Rows in float of the last instruction set, with those in double beside them.
struct PrecisionPair {
  const Row *narrow, *wide;
};
[[nodiscard]] std::vector<PrecisionPair> precision_pairs(const CaseRows& rows);

/// A hit counts as good up to this error, in voxels or domain widths.
inline constexpr double kGoodError = 1e-3;

/// best       the fastest row of the last instruction set without a failed ray and with good hits only; where
///            there is none, the one with the fewest failures
/// right      whether it has no failure and good hits only
/// proved     the fastest such row of a method that proves something, or null
/// precision  recommended: float where no setting is more right in double, of the methods that prove
///            something if there are any, since others may be right by luck
/// reason     a sentence about it
struct CaseFinding {
  const Row *best = nullptr, *proved = nullptr;
  bool right = false;
  std::string precision, reason;
};
[[nodiscard]] CaseFinding examine(const CaseRows& rows);

}  // namespace isocast::bench
