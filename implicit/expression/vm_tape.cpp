#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>
#include <isocast/base/text.h>
#include <isocast/implicit/expression/vm_tape.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <unordered_map>
#include <vector>

namespace isocast {
namespace {

// An operation on one or two operands; of one, the second is the first again.
struct Operation {
  std::string_view name;
  std::size_t operands;
  NodeId (*build)(Expression&, NodeId a, NodeId b);
};

template <Op op> NodeId one(Expression& e, NodeId a, NodeId) { return e.unary(op, a); }
template <Op op> NodeId two(Expression& e, NodeId a, NodeId b) { return e.binary(op, a, b); }

NodeId number(Expression& e, double value) { return e.constant(exact_constant(value)); }
NodeId reciprocal(Expression& e, NodeId a, NodeId) { return e.binary(Op::divide, number(e, 1), a); }
NodeId opposite(Expression& e, NodeId a, NodeId) { return e.choose(a, number(e, 0), number(e, 1)); }
NodeId both(Expression& e, NodeId a, NodeId b) { return e.choose(a, b, a); }
NodeId either(Expression& e, NodeId a, NodeId b) { return e.choose(a, a, b); }
NodeId compare(Expression& e, NodeId a, NodeId b) {
  return e.binary(Op::subtract, e.binary(Op::step, b, a), e.binary(Op::step, a, b));
}
NodeId remainder(Expression& e, NodeId a, NodeId b) {
  const NodeId size = e.unary(Op::abs, b), whole = e.unary(Op::floor, e.binary(Op::divide, a, size));
  return e.binary(Op::subtract, a, e.binary(Op::multiply, size, whole));
}

constexpr Operation kOperations[] = {
    {"abs", 1, one<Op::abs>},
    {"acos", 1, one<Op::acos>},
    {"add", 2, two<Op::add>},
    {"and", 2, both},
    {"asin", 1, one<Op::asin>},
    {"atan", 1, one<Op::atan>},
    {"atan2", 2, two<Op::atan2>},
    {"ceil", 1, one<Op::ceil>},
    {"compare", 2, compare},
    {"cos", 1, one<Op::cos>},
    {"div", 2, two<Op::divide>},
    {"exp", 1, one<Op::exp>},
    {"floor", 1, one<Op::floor>},
    {"ln", 1, one<Op::log>},
    {"max", 2, two<Op::max>},
    {"min", 2, two<Op::min>},
    {"mod", 2, remainder},
    {"mul", 2, two<Op::multiply>},
    {"neg", 1, one<Op::negate>},
    {"not", 1, opposite},
    {"or", 2, either},
    {"recip", 1, reciprocal},
    {"round", 1, one<Op::round>},
    {"sin", 1, one<Op::sin>},
    {"sqrt", 1, one<Op::sqrt>},
    {"square", 1, one<Op::square>},
    {"sub", 2, two<Op::subtract>},
    {"tan", 1, one<Op::tan>},
};

constexpr std::string_view kVariables[] = {"var-x", "var-y", "var-z"};

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\r";
  std::vector<std::string_view> words;
  for (std::size_t at; (at = line.find_first_not_of(kBlanks)) != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    line.remove_prefix(end);
  }
  return words;
}

class TapeReader {
 public:
  explicit TapeReader(std::string_view source) : source_(source) {}

  Expression read(std::string_view text) {
    while (!text.empty()) {
      ++line_;
      const std::size_t end = std::min(text.find('\n'), text.size());
      instruction(words_of(text.substr(0, end)));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (count_ == 0)
      throw InputError(fmt::format("{}: found no instruction, expected at least one", source_));
    return std::move(expression_);
  }

 private:
  void instruction(const std::vector<std::string_view>& words) {
    if (words.empty() || words[0].starts_with('#')) return;
    if (++count_ > kMaxVmInstructions)
      fail(fmt::format("more than {} instructions", kMaxVmInstructions), "fewer");
    if (words.size() < 2) fail(in_quotes(words[0]) + " alone", "a name and an operation");
    const NodeId node = value(words);
    nodes_[words[0]] = node;
    expression_.set_root(node);
  }

  NodeId value(const std::vector<std::string_view>& words) {
    const std::string_view name = words[1];
    if (name == "const") {
      require_operands(words, 1);
      const std::optional<Constant> constant = decimal_constant(words[2]);
      if (!constant) fail(in_quotes(words[2]), "a number within the range of double precision");
      return expression_.constant(*constant);
    }
    if (const auto place = std::ranges::find(kVariables, name); place != std::end(kVariables)) {
      require_operands(words, 0);
      return expression_.variable(static_cast<int>(place - std::begin(kVariables)));
    }
    const auto operation = std::ranges::find(kOperations, name, &Operation::name);
    if (operation == std::end(kOperations))
      fail("the unknown operation " + in_quotes(name), "const, var-x, add or another one of a .vm tape");
    require_operands(words, operation->operands);
    return operation->build(expression_, operand(words[2]), operand(words.back()));
  }

  NodeId operand(std::string_view name) const {
    const auto found = nodes_.find(name);
    if (found == nodes_.end()) fail("the unknown operand " + in_quotes(name), "the name of an earlier line");
    return found->second;
  }

  void require_operands(const std::vector<std::string_view>& words, std::size_t count) const {
    if (words.size() - 2 != count)
      fail(fmt::format("{} operands of {}", words.size() - 2, in_quotes(words[1])), std::to_string(count));
  }

  [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
    throw InputError(fmt::format("{}:{}: found {}, expected {}", source_, line_, found, expected));
  }

  std::string_view source_;
  Expression expression_;
  std::unordered_map<std::string_view, NodeId> nodes_;
  std::size_t line_ = 0, count_ = 0;
};

}  // namespace

Expression parse_vm_tape(std::string_view text, std::string_view source) {
  if (text.size() > kMaxVmBytes)
    throw InputError(
        fmt::format("{}: found {} bytes, expected at most {}", source, text.size(), kMaxVmBytes));
  return TapeReader(source).read(text);
}

Expression read_vm_file(const std::filesystem::path& path) {
  const MappedFile file = map_file(path);
  const std::string_view text(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size());
  Expression expression = parse_vm_tape(text, path.string());
  check_mapped_files();
  return expression;
}

}  // namespace isocast
