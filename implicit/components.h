// Which operand of a constructive solid a point belongs to.
#pragma once

#include <isocast/implicit/expression/tape.h>
#include <isocast/math/transform.h>

#include <vector>

namespace isocast {

/// The operands of the min, max, negations and choices that a formula ends in, in the order of its text, from
/// 0; a formula without such an end is its only component. An end that nests deeper than kDeepest or is
/// longer than kMostParts is not taken apart further.
class Components {
 public:
  static constexpr int kDeepest = 1000, kMostParts = 4096;

  explicit Components(const Expression& expression);

  [[nodiscard]] int count() const { return static_cast<int>(leaves_.size()); }
  /// The component whose value f has at p: of two equal ones the first.
  [[nodiscard]] int at(const Double3& p, double time) const;

 private:
  // A node of the formula's end: its operands, and the number of a leaf's tape or of a choice's condition.
  struct Part {
    Op op;
    int a = -1, b = -1, tape = -1;
  };
  struct Value {
    double f;
    int leaf;
  };
  int add(Expression& expression, NodeId node, int depth);
  [[nodiscard]] Value value(int part, const double* inputs) const;

  std::vector<Part> parts_;
  std::vector<Tape> leaves_, conditions_;
  int root_;
};

}  // namespace isocast
