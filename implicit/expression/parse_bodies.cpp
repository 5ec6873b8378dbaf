#include <fmt/format.h>
#include <isocast/base/text.h>
#include <isocast/implicit/expression/parser.h>

#include <algorithm>
#include <utility>

namespace isocast {
namespace {

constexpr std::size_t kMaxLocals = 64, kMaxNameBytes = 64;
constexpr const char* kTooManyLocals = "at most 64 names in one place";

}  // namespace

bool Parser::at_definition() const {
  if (token().is("let")) return true;
  if (token().kind != Token::Kind::name) return false;
  Lexer ahead = reader_.place().lexer;
  Token next = ahead.next();
  if (next.is("(")) {
    do {
      next = ahead.next();
      if (next.kind == Token::Kind::name) next = ahead.next();
    } while (next.is(","));
    if (!next.is(")")) return false;
    next = ahead.next();
  }
  return next.is("=");
}

void Parser::definition() {
  if (token().is("let")) reader_.advance();
  const Token word = free_name();
  if (!scope_.is_new(word.text)) fail_taken(word);
  being_defined_ = word.text;
  if (token().is("(")) {
    Names parameters = name_list();
    reader_.expect("=", "'='");

    // read the body once now, for its end and its mistakes, with 1 for each parameter
    const Place body = reader_.place();
    for (const std::string_view name : parameters)
      scope_.locals.push_back({name, expression_.constant(exact_constant(1))});
    expression();
    scope_.locals.clear();
    scope_.define(word.text, UserFunction{std::move(parameters), body});
  } else {
    reader_.expect("=", "'=' or '('");
    scope_.define(word.text, expression());
  }
  being_defined_ = {};
  reader_.expect(";", "an operator or ';'");
}

NodeId Parser::call(const Token& word, const UserFunction& function) {
  const Names& names = function.parameters;
  const std::vector<NodeId> nodes = arguments(word, names.size(), names.size());
  Locals locals;
  for (std::size_t i = 0; i < names.size(); ++i) locals.push_back({names[i], nodes[i]});
  const Place after = reader_.place();
  reader_.go_to(function.body);
  std::swap(scope_.locals, locals);
  const NodeId node = expression();
  std::swap(scope_.locals, locals);
  reader_.go_to(after);
  return node;
}

NodeId Parser::sum() {
  if (!token().is("(")) reader_.fail("'(' after the function sum");
  const Names names = sum_names();
  reader_.expect("in", "'in'");
  const std::vector<NodeId> list = elements(names.size());
  reader_.expect(",", "','");
  const Place body = reader_.place();
  const std::size_t outer = scope_.locals.size();
  std::optional<NodeId> total;
  for (std::size_t i = 0; i < list.size();) {
    for (const std::string_view name : names) scope_.locals.push_back({name, list[i++]});
    if (scope_.locals.size() > kMaxLocals) reader_.fail(kTooManyLocals);
    reader_.go_to(body);
    const NodeId term = expression();
    total = total ? expression_.binary(Op::add, *total, term) : term;
    scope_.locals.resize(outer);
  }
  reader_.expect(")", "an operator or ')'");
  return *total;
}

Parser::Names Parser::sum_names() {
  reader_.advance();
  return token().is("(") ? name_list() : Names{free_name().text};
}

std::vector<NodeId> Parser::elements(std::size_t size) {
  if (!token().is("[")) reader_.fail("'['");
  std::vector<NodeId> list;
  do {
    reader_.advance();
    if (size == 1) list.push_back(expression());
    else
      for (const NodeId number : element(size)) list.push_back(number);
  } while (token().is(","));
  reader_.expect("]", "an operator, ',' or ']'");
  return list;
}

std::vector<NodeId> Parser::element(std::size_t size) {
  const Token parenthesis = token();
  if (!parenthesis.is("(")) reader_.fail(fmt::format("'(' and {} numbers", size));
  std::vector<NodeId> numbers = tuple();
  if (numbers.size() != size)
    reader_.fail(parenthesis, fmt::format("an element of {}", numbers.size()),
                 fmt::format("{} numbers, one for each name", size));
  return numbers;
}

Parser::Names Parser::name_list() {
  Names names;
  do {
    reader_.advance();
    const Token word = free_name();
    if (std::ranges::count(names, word.text) != 0) fail_taken(word);
    if (names.size() == kMaxLocals) reader_.fail(word, describe(word), kTooManyLocals);
    names.push_back(word.text);
  } while (token().is(","));
  reader_.expect(")", "',' or ')'");
  return names;
}

Token Parser::free_name() {
  const Token word = token();
  if (word.kind != Token::Kind::name) reader_.fail("a new name");
  if (word.text.size() > kMaxNameBytes)
    reader_.fail(fmt::format("a name of at most {} characters", kMaxNameBytes));
  if (!Scope::is_free(word.text)) fail_taken(word);
  return reader_.advance();
}

void Parser::fail_taken(const Token& word) const {
  reader_.fail(word, fmt::format("the name {}, which is taken", in_quotes(word.text)), "a new name");
}

}  // namespace isocast
