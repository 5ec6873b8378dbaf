#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/text.h>
#include <isocast/implicit/expression/infix.h>
#include <isocast/implicit/expression/nearest_name.h>
#include <isocast/implicit/expression/parser.h>

#include <cmath>
#include <utility>

namespace isocast {

Expression Parser::formula() {
  while (at_definition()) definition();
  expression_.set_root(expression());
  if (token().kind != Token::Kind::end) reader_.fail("an operator or the end of the formula");
  return std::move(expression_);
}

NodeId Parser::expression(int level) {
  NodeId left = token().is("not") && level <= kComparisonLevel ? negation() : signed_power();
  bool compared = false;
  for (const Infix* infix; (infix = find_infix(token().text)) && infix->level >= level;) {
    if (compared && infix->level == kComparisonLevel) reader_.fail("'and' or 'or' after a comparison");
    compared = infix->level == kComparisonLevel;
    reader_.advance();
    left = infix->build(expression_, left, expression(infix->level + 1));
  }
  return left;
}

NodeId Parser::negation() {
  std::size_t count = 0;
  for (; token().is("not"); ++count) reader_.advance();
  NodeId node = expression(kComparisonLevel);
  for (; count > 0; --count) node = logical_not(expression_, node);
  return node;
}

NodeId Parser::signed_power() {
  if (++depth_ > kMaxFormulaNesting) reader_.fail(fmt::format("at most {} nested parts", kMaxFormulaNesting));
  NodeId node = 0;
  if (token().is("-") || token().is("+")) {
    const bool negative = reader_.advance().is("-");
    node = signed_power();
    if (negative) node = expression_.unary(Op::negate, node);
  } else {
    node = operand();
    if (token().is("^")) {
      reader_.advance();
      node = expression_.binary(Op::pow, node, signed_power());
    }
  }
  --depth_;
  return node;
}

NodeId Parser::operand() {
  if (token().kind == Token::Kind::number) return literal();
  if (token().kind == Token::Kind::name && !Scope::is_keyword(token().text)) return name();
  reader_.expect("(", "a number, a name or '('");
  const NodeId node = expression();
  reader_.expect(")", "an operator or ')'");
  return node;
}

NodeId Parser::literal() {
  const std::optional<Constant> value = decimal_constant(token().text);
  if (!value) reader_.fail("a number within the range of double precision");
  reader_.advance();
  return expression_.constant(*value);
}

NodeId Parser::name() {
  const Token word = reader_.advance();
  if (const Builtin* function = find_builtin(word.text)) return call(word, *function);
  if (word.is("sum")) return sum();
  if (const std::optional<NodeId> value = scope_.value(expression_, word.text)) return *value;
  if (const UserFunction* function = scope_.function(word.text)) return call(word, *function);
  fail_unknown(word);
}

NodeId Parser::call(const Token& word, const Builtin& function) {
  const std::vector<NodeId> nodes = arguments(word, function.min_arguments, function.max_arguments);
  if (function.degree_first && !is_degree(nodes[0]))
    reader_.fail(word, fmt::format("a degree of {} that is no plain number in range", word.text),
                 fmt::format("a whole number from 0 to {}", kMaxChebyshevDegree));
  return function.build(expression_, nodes);
}

std::vector<NodeId> Parser::arguments(const Token& word, std::size_t at_least, std::size_t at_most) {
  if (!token().is("(")) reader_.fail(fmt::format("'(' after the function {}", word.text));
  std::vector<NodeId> arguments = tuple();
  const std::size_t count = arguments.size();
  if (count < at_least || count > at_most)
    reader_.fail(word, fmt::format("{} argument{} of {}", count, count == 1 ? "" : "s", word.text),
                 fmt::format("{}{}", at_most > at_least ? "at least " : "", at_least));
  return arguments;
}

std::vector<NodeId> Parser::tuple() {
  std::vector<NodeId> numbers;
  do {
    reader_.advance();
    numbers.push_back(expression());
  } while (token().is(","));
  reader_.expect(")", "an operator, ',' or ')'");
  return numbers;
}

bool Parser::is_degree(NodeId id) const {
  if (expression_.node(id).op != Op::constant) return false;
  const Constant& degree = expression_.constant_at(id);
  return degree.exact && degree.value >= 0 && degree.value <= kMaxChebyshevDegree &&
         degree.value == std::floor(degree.value);
}

void Parser::fail_unknown(const Token& word) const {
  if (word.is(being_defined_))
    reader_.fail(word, fmt::format("{} in its own definition", in_quotes(word.text)),
                 "only names that are defined before");
  const std::string nearest = nearest_name(word.text, scope_.known());
  reader_.fail(word, "the unknown name " + in_quotes(word.text),
               "a variable (x y z w), a parameter, a constant (pi e phi) or a function" +
                   (nearest.empty() ? "" : fmt::format("; the nearest is '{}'", nearest)));
}

Expression parse_expression(std::string_view text, const Parameters& parameters, std::string_view source) {
  if (text.size() > kMaxFormulaBytes)
    throw InputError(
        fmt::format("{}: found {} bytes, expected at most {}", source, text.size(), kMaxFormulaBytes));
  return Parser(text, parameters, source).formula();
}

}  // namespace isocast
