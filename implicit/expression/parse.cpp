#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/text.h>
#include <isocast/implicit/expression/builtins.h>
#include <isocast/implicit/expression/lexer.h>
#include <isocast/implicit/expression/nearest_name.h>
#include <isocast/implicit/expression/parse.h>

#include <algorithm>

namespace isocast {
namespace {

constexpr std::string_view kVariables[] = {"x", "y", "z", "w"};
constexpr std::string_view kOperand = "a number, a name or '('";

// Recursive descent: sum of products of signed powers of operands.
class Parser {
 public:
  Parser(std::string_view text, const Parameters& parameters, std::string_view source)
      : lexer_(text, source), parameters_(parameters), token_(lexer_.next()) {}

  Expression formula() {
    expression_.set_root(sum());
    if (token_.kind != Token::Kind::end) fail("an operator or the end of the formula");
    return std::move(expression_);
  }

 private:
  NodeId sum() {
    NodeId left = product();
    while (token_.is('+') || token_.is('-')) {
      const Op op = advance().is('+') ? Op::add : Op::subtract;
      left = expression_.binary(op, left, product());
    }
    return left;
  }

  NodeId product() {
    NodeId left = signed_power();
    while (token_.is('*') || token_.is('/')) {
      const Op op = advance().is('*') ? Op::multiply : Op::divide;
      left = expression_.binary(op, left, signed_power());
    }
    return left;
  }

  // Every nested part passes here once, which bounds the depth of the recursion.
  NodeId signed_power() {
    if (++depth_ > kMaxFormulaNesting)
      lexer_.fail(token_.text, describe(token_), fmt::format("at most {} nested parts", kMaxFormulaNesting));
    NodeId node = 0;
    if (token_.is('-') || token_.is('+')) {
      const bool negative = advance().is('-');
      node = signed_power();
      if (negative) node = expression_.unary(Op::negate, node);
    } else {
      node = operand();
      if (token_.is('^')) {
        advance();
        node = expression_.binary(Op::pow, node, signed_power());
      }
    }
    --depth_;
    return node;
  }

  NodeId operand() {
    if (token_.kind == Token::Kind::number) return number();
    if (token_.kind == Token::Kind::name) return name();
    if (!token_.is('(')) fail(kOperand);
    advance();
    const NodeId node = sum();
    if (!token_.is(')')) fail("an operator or ')'");
    advance();
    return node;
  }

  NodeId number() {
    const std::optional<Constant> value = decimal_constant(token_.text);
    if (!value) fail("a number within the range of double precision");
    advance();
    return expression_.constant(*value);
  }

  // A function's call, else a variable, a parameter, a constant, in this order.
  NodeId name() {
    const Token word = advance();
    if (const Builtin* function = find_builtin(word.text)) return call(word, *function);
    if (const auto place = std::ranges::find(kVariables, word.text); place != std::end(kVariables))
      return expression_.variable(static_cast<int>(place - std::begin(kVariables)));
    const auto is_named = [&](const Parameter& parameter) { return parameter.name == word.text; };
    if (const auto found = std::find_if(parameters_.rbegin(), parameters_.rend(), is_named);
        found != parameters_.rend())
      return expression_.constant(found->value);
    if (const std::optional<Constant> constant = named_constant(word.text))
      return expression_.constant(*constant);
    fail_unknown(word);
  }

  NodeId call(const Token& word, const Builtin& function) {
    if (!token_.is('(')) fail(fmt::format("'(' after the function {}", word.text));
    std::vector<NodeId> arguments;
    do {
      advance();
      arguments.push_back(sum());
    } while (token_.is(','));
    if (!token_.is(')')) fail("an operator, ',' or ')'");
    advance();
    if (arguments.size() < function.min_arguments || arguments.size() > function.max_arguments)
      lexer_.fail(word.text, fmt::format("{} of {}", plural(arguments.size()), word.text),
                  fmt::format("{}{}", function.max_arguments > 3 ? "at least " : "", function.min_arguments));
    return function.build(expression_, arguments);
  }

  static std::string plural(std::size_t count) {
    return fmt::format("{} argument{}", count, count == 1 ? "" : "s");
  }

  Token advance() {
    const Token passed = token_;
    token_ = lexer_.next();
    return passed;
  }

  [[noreturn]] void fail(std::string_view expected) const {
    lexer_.fail(token_.text, describe(token_), std::string(expected));
  }

  [[noreturn]] void fail_unknown(const Token& word) const {
    std::vector<std::string> known(std::begin(kVariables), std::end(kVariables));
    for (const Parameter& parameter : parameters_) known.push_back(parameter.name);
    for (const Builtin& function : builtins()) known.emplace_back(function.name);
    known.insert(known.end(), {"pi", "e", "phi"});
    const std::string nearest = nearest_name(word.text, known);
    lexer_.fail(word.text, "the unknown name " + in_quotes(word.text),
                "a variable (x y z w), a parameter, a constant (pi e phi) or a function" +
                    (nearest.empty() ? "" : fmt::format("; the nearest is '{}'", nearest)));
  }

  Lexer lexer_;
  const Parameters& parameters_;
  Expression expression_;
  Token token_;
  int depth_ = 0;
};

void check_parameters(const Parameters& parameters) {
  for (const Parameter& parameter : parameters)
    if (find_builtin(parameter.name) || std::ranges::count(kVariables, std::string_view(parameter.name)))
      throw InputError(
          fmt::format("the parameter {} has the name of a variable or a function, expected a name of its own",
                      in_quotes(parameter.name)));
}

}  // namespace

Expression parse_expression(std::string_view text, const Parameters& parameters, std::string_view source) {
  if (text.size() > kMaxFormulaBytes)
    throw InputError(
        fmt::format("{}: found {} bytes, expected at most {}", source, text.size(), kMaxFormulaBytes));
  check_parameters(parameters);
  return Parser(text, parameters, source).formula();
}

}  // namespace isocast
