// The operators that stand between two operands, and truth.
#pragma once

#include <isocast/implicit/expression/expression.h>

#include <string_view>

namespace isocast {

/// One operator. Those of a higher level bind tighter; those of one level group to the left, but comparisons
/// do not group at all.
struct Infix {
  std::string_view symbol;
  int level;
  NodeId (*build)(Expression&, NodeId a, NodeId b);
};

/// `not` binds as tightly as a comparison, and takes one as its operand.
inline constexpr int kComparisonLevel = 2;

/// The operator of that symbol, or null: or, and, < > <= >= == !=, + -, * /, from loose to tight.
///
/// truth   a comparison is 1 or 0; any number but 0 counts as true; and, or and not give 1 or 0. All are
///         undefined (NaN) where an operand is, so none is skipped as in programming languages.
[[nodiscard]] const Infix* find_infix(std::string_view symbol);

/// 0 where a is true, 1 where it is 0.
[[nodiscard]] NodeId logical_not(Expression& expression, NodeId a);

}  // namespace isocast
