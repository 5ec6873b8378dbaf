#include <isocast/implicit/expression/tape.h>

#include <algorithm>

namespace isocast {
namespace {

// The registers that each node needs were it a tree: R. Sethi, J. D. Ullman: The generation of optimal code
// for arithmetic expressions, J. ACM 17(4), 1970.
std::vector<std::uint32_t> register_needs(const std::vector<Node>& nodes) {
  std::vector<std::uint32_t> needs;
  needs.reserve(nodes.size());
  for (const Node& node : nodes) {
    const int operands = operand_count(node.op);
    if (operands == 0) needs.push_back(1);
    else if (operands == 1 || node.a == node.b) needs.push_back(needs[node.a]);
    else
      needs.push_back(std::max({needs[node.a], needs[node.b], std::min(needs[node.a], needs[node.b]) + 1}));
  }
  return needs;
}

// What the root needs, operands first; without recursion, since a long sum is a deep graph.
std::vector<NodeId> schedule(const Expression& expression) {
  const std::vector<std::uint32_t> needs = register_needs(expression.nodes());
  enum class State : std::uint8_t { unseen, opened, done };
  std::vector<State> state(expression.nodes().size(), State::unseen);
  std::vector<NodeId> order, stack = {expression.root()};
  while (!stack.empty()) {
    const NodeId id = stack.back();
    const Node& node = expression.node(id);
    if (state[id] == State::unseen) {
      // what is pushed last is done first
      state[id] = State::opened;
      const int operands = operand_count(node.op);
      const bool b_first = operands == 2 && needs[node.b] > needs[node.a];
      if (b_first) stack.push_back(node.a);
      if (operands == 2) stack.push_back(node.b);
      if (operands > 0 && !b_first) stack.push_back(node.a);
    } else {
      stack.pop_back();
      if (state[id] == State::opened) order.push_back(id);
      state[id] = State::done;
    }
  }
  return order;
}

// Hands out registers, those given back first.
class Registers {
 public:
  std::uint32_t take() {
    if (free_.empty()) return count_++;
    const std::uint32_t taken = free_.back();
    free_.pop_back();
    return taken;
  }
  void give_back(std::uint32_t one) { free_.push_back(one); }
  [[nodiscard]] std::uint32_t count() const { return count_; }

 private:
  std::vector<std::uint32_t> free_;
  std::uint32_t count_ = 0;
};

}  // namespace

Tape make_tape(const Expression& expression) {
  const std::vector<NodeId> order = schedule(expression);

  // count the readers of each node; whoever asked for the tape reads the root
  std::vector<std::uint32_t> readers(expression.nodes().size(), 0);
  readers[expression.root()] = 1;
  for (const NodeId id : order) {
    const Node& node = expression.node(id);
    if (operand_count(node.op) >= 1) ++readers[node.a];
    if (operand_count(node.op) == 2) ++readers[node.b];
  }

  // one instruction a node; its operands' registers are free for its result when it is their last reader
  Tape tape;
  Registers registers;
  std::vector<std::uint32_t> place(expression.nodes().size(), 0);
  const auto read = [&](NodeId id) {
    if (--readers[id] == 0) registers.give_back(place[id]);
    return place[id];
  };
  tape.code.reserve(order.size());
  for (const NodeId id : order) {
    const Node& node = expression.node(id);
    Instruction instruction = {node.op, 0, 0, 0, node.n};
    if (node.op == Op::variable) instruction.a = node.a;
    if (node.op == Op::constant) {
      instruction.a = static_cast<std::uint32_t>(tape.constants.size());
      tape.constants.push_back({expression.constant_at(id).value, expression.constant_at(id).exact});
    }
    if (operand_count(node.op) >= 1) instruction.a = read(node.a);
    if (operand_count(node.op) == 2) instruction.b = read(node.b);
    instruction.out = place[id] = registers.take();
    tape.code.push_back(instruction);
  }
  tape.registers = registers.count();
  tape.result = place[expression.root()];
  return tape;
}

}  // namespace isocast
