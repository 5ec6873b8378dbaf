// A formula as a graph whose equal parts are one node.
#pragma once

#include <isocast/implicit/expression/constant.h>
#include <isocast/implicit/expression/instruction.h>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace isocast {

using NodeId = std::uint32_t;

/// Degrees above this are refused; the polynomial takes a step a degree.
inline constexpr int kMaxChebyshevDegree = 1024;

/// a, b and c are operands; of a constant, a is its place among constants(); of a variable, a is 0..3 for x y
/// z w; n is the exponent of `power` and the degree of `chebyshev`. What an operation does not use is 0.
struct Node {
  Op op;
  NodeId a = 0, b = 0, c = 0;
  std::int32_t n = 0;
  bool operator==(const Node&) const = default;
};

/// A directed acyclic graph: operands come before what uses them, and a node that is there already is not
/// made again.
class Expression {
 public:
  NodeId constant(const Constant& value);
  NodeId variable(int index) { return add({Op::variable, static_cast<NodeId>(index)}); }
  NodeId unary(Op op, NodeId a) { return add({op, a}); }
  NodeId binary(Op op, NodeId a, NodeId b) { return add({op, a, b}); }
  NodeId power(NodeId a, std::int32_t n) { return add({.op = Op::power, .a = a, .n = n}); }
  /// The Chebyshev polynomial of the first kind T_n at a, 0 <= n <= kMaxChebyshevDegree.
  NodeId chebyshev(NodeId a, std::int32_t n) { return add({.op = Op::chebyshev, .a = a, .n = n}); }
  /// a where `condition` is not 0, else b; undefined where the condition is.
  NodeId choose(NodeId condition, NodeId a, NodeId b) { return add({Op::choose, condition, a, b}); }
  void set_root(NodeId root) { root_ = root; }

  [[nodiscard]] NodeId root() const { return root_; }
  [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const Node& node(NodeId id) const { return nodes_[id]; }
  [[nodiscard]] const std::vector<Constant>& constants() const { return constants_; }
  /// The number at a node of kind `constant`.
  [[nodiscard]] const Constant& constant_at(NodeId id) const { return constants_[nodes_[id].a]; }

 private:
  struct NodeHash {
    std::size_t operator()(const Node& node) const;
  };
  NodeId add(const Node& node);

  std::vector<Node> nodes_;
  std::vector<Constant> constants_;
  std::unordered_map<Node, NodeId, NodeHash> known_;
  std::unordered_map<std::string, NodeId> known_constants_;
  NodeId root_ = 0;
};

}  // namespace isocast
