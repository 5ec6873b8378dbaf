// Reads a formula by recursive descent.
#pragma once

#include <isocast/implicit/expression/builtins.h>
#include <isocast/implicit/expression/reader.h>
#include <isocast/implicit/expression/scope.h>

#include <string_view>
#include <vector>

namespace isocast {

/// The grammar of parse.h, a function a rule; each begins at its first word, ends after its last one and
/// throws InputError at what does not belong there.
class Parser {
 public:
  Parser(std::string_view text, const Parameters& parameters, std::string_view source)
      : reader_(text, source), scope_(parameters) {}

  Expression formula();

 private:
  using Names = std::vector<std::string_view>;

  // parse.cpp: operators between signed powers of operands
  NodeId expression(int level = 0);  // operators of this level or a tighter one
  NodeId negation();
  NodeId signed_power();  // every nested part passes here once, which bounds the depth of the recursion
  NodeId operand();
  NodeId literal();
  NodeId name();
  NodeId call(const Token& word, const Builtin& function);
  std::vector<NodeId> arguments(const Token& word, std::size_t at_least, std::size_t at_most);
  std::vector<NodeId> tuple();  // (expression, expression, ...)
  bool is_degree(NodeId id) const;

  // parse_bodies.cpp: what the formula defines, and the bodies that are read again and again
  bool at_definition() const;  // whether "let", "name =" or "name(name, ...) =" comes next
  void definition();
  NodeId call(const Token& word, const UserFunction& function);
  NodeId sum();  // from the parenthesis on
  Names sum_names();
  std::vector<NodeId> elements(std::size_t size);  // [element, ...], the numbers of all one after the other
  std::vector<NodeId> element(std::size_t size);
  Names name_list();  // (name, name, ...), each of them once
  Token free_name();

  [[noreturn]] void fail_taken(const Token& word) const;
  [[noreturn]] void fail_unknown(const Token& word) const;
  const Token& token() const { return reader_.token(); }

  Reader reader_;
  Scope scope_;
  Expression expression_;
  std::string_view being_defined_;
  int depth_ = 0;
};

}  // namespace isocast
