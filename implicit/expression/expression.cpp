#include <isocast/implicit/expression/expression.h>

namespace isocast {

std::size_t Expression::NodeHash::operator()(const Node& node) const {
  std::uint64_t hash = static_cast<std::uint64_t>(node.op);
  for (const std::uint64_t part : {std::uint64_t{node.a}, std::uint64_t{node.b}, std::uint64_t{node.c},
                                   static_cast<std::uint64_t>(node.n)}) {
    hash = (hash ^ part) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 32;
  }
  return hash;
}

NodeId Expression::constant(const Constant& value) {
  const auto [place, is_new] =
      known_constants_.try_emplace(value.text, static_cast<NodeId>(constants_.size()));
  if (is_new) constants_.push_back(value);
  return add({Op::constant, place->second});
}

NodeId Expression::add(const Node& node) {
  const auto [place, is_new] = known_.try_emplace(node, static_cast<NodeId>(nodes_.size()));
  if (is_new) nodes_.push_back(node);
  return place->second;
}

}  // namespace isocast
