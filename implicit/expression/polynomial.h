// Which nodes of a graph are Chebyshev polynomials of another node.
#pragma once

#include <isocast/implicit/expression/expression.h>

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace isocast {

/// A polynomial in one node with whole coefficients, c[k] of the power k; the last one is not 0 but for the
/// polynomial 0 itself, which has none. A number has kNoBase.
struct Polynomial {
  static constexpr NodeId kNoBase = ~NodeId{0};
  NodeId base = kNoBase;
  std::vector<std::int64_t> c;
};

/// The coefficients of the Chebyshev polynomial T_n, n <= Polynomials::kMaxDegree.
[[nodiscard]] std::vector<std::int64_t> chebyshev_coefficients(int n);

/// What is known of the nodes of a growing graph.
class Polynomials {
 public:
  /// The largest degree whose coefficients, those of T_50 among them, fit into 64 bits.
  static constexpr int kMaxDegree = 50;

  explicit Polynomials(const Expression& graph) : graph_(graph) {}

  /// The base u and n when the node `id` is exactly T_n(u), 3 <= n <= kMaxDegree, however it is written: by
  /// powers, Horner's rule, the recurrence or the composition of smaller ones. u is no polynomial with whole
  /// coefficients itself, so T_3(x - 1) written by powers is not found. Only nodes that were asked for are
  /// known as parts of later ones.
  struct Chebyshev {
    NodeId base;
    int degree;
  };
  [[nodiscard]] std::optional<Chebyshev> as_chebyshev(NodeId id);

 private:
  /// A node that is no other polynomial is one in itself.
  [[nodiscard]] Polynomial of(NodeId id) const;
  [[nodiscard]] std::optional<Polynomial> computed(const Node& node) const;

  const Expression& graph_;
  std::unordered_map<NodeId, Polynomial> known_;
};

}  // namespace isocast
