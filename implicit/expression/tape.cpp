#include <isocast/implicit/expression/registers.h>
#include <isocast/implicit/expression/tape.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace isocast {
namespace {

// A node's operands, each once, those that need more registers first.
struct Operands {
  std::array<NodeId, 3> id;
  int count = 0;

  Operands(const Node& node, const std::vector<std::uint32_t>& needs) {
    const std::array<NodeId, 3> all = {node.a, node.b, node.c};
    for (int i = 0; i < operand_count(node.op); ++i)
      if (std::find(begin(), end(), all[i]) == end()) id[count++] = all[i];
    std::stable_sort(begin(), end(), [&](NodeId a, NodeId b) { return needs[a] > needs[b]; });
  }
  NodeId* begin() { return id.data(); }
  NodeId* end() { return id.data() + count; }
};

// The registers that each node needs were it a tree: R. Sethi, J. D. Ullman: The generation of optimal code
// for arithmetic expressions, J. ACM 17(4), 1970.
std::vector<std::uint32_t> register_needs(const std::vector<Node>& nodes) {
  std::vector<std::uint32_t> needs;
  needs.reserve(nodes.size());
  for (const Node& node : nodes) {
    std::uint32_t need = 1, held = 0;
    for (const NodeId operand : Operands(node, needs)) need = std::max(need, needs[operand] + held++);
    needs.push_back(need);
  }
  return needs;
}

// What the root needs, operands first; without recursion, since a long sum is a deep graph.
std::vector<NodeId> schedule(const Expression& expression, const std::vector<std::uint32_t>& needs) {
  enum class State : std::uint8_t { unseen, opened, done };
  std::vector<State> state(expression.nodes().size(), State::unseen);
  std::vector<NodeId> order, stack = {expression.root()};
  while (!stack.empty()) {
    const NodeId id = stack.back();
    if (state[id] == State::unseen) {
      // what is pushed last is done first
      state[id] = State::opened;
      Operands operands(expression.node(id), needs);
      stack.insert(stack.end(), std::reverse_iterator(operands.end()),
                   std::reverse_iterator(operands.begin()));
    } else {
      stack.pop_back();
      if (state[id] == State::opened) order.push_back(id);
      state[id] = State::done;
    }
  }
  return order;
}

}  // namespace

Tape make_tape(const Expression& expression) {
  const std::vector<std::uint32_t> needs = register_needs(expression.nodes());
  const std::vector<NodeId> order = schedule(expression, needs);

  // count the readers of each node; whoever asked for the tape reads the root
  std::vector<std::uint32_t> readers(expression.nodes().size(), 0);
  readers[expression.root()] = 1;
  for (const NodeId id : order)
    for (const NodeId operand : Operands(expression.node(id), needs)) ++readers[operand];

  // one instruction a node; its operands' registers are free for its result when it is their last reader
  Tape tape;
  Registers registers;
  std::vector<std::uint32_t> place(expression.nodes().size(), 0);
  tape.code.reserve(order.size());
  for (const NodeId id : order) {
    const Node& node = expression.node(id);
    const int operands = operand_count(node.op);
    Instruction instruction = {node.op, 0, 0, 0, 0, node.n};
    if (node.op == Op::variable) instruction.a = node.a;
    if (node.op == Op::constant) {
      instruction.a = static_cast<std::uint32_t>(tape.constants.size());
      tape.constants.push_back({expression.constant_at(id).value, expression.constant_at(id).exact});
    }
    if (operands >= 1) instruction.a = place[node.a];
    if (operands >= 2) instruction.b = place[node.b];
    if (operands >= 3) instruction.c = place[node.c];
    for (const NodeId operand : Operands(node, needs))
      if (--readers[operand] == 0) registers.give_back(place[operand]);
    instruction.out = place[id] = registers.take();
    tape.code.push_back(instruction);
  }
  tape.registers = registers.count();
  tape.result = place[expression.root()];
  return tape;
}

}  // namespace isocast
