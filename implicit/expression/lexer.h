// Text of a formula to words, and errors that say where.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace isocast {

/// A word of a formula; `text` is a part of the formula, empty at its end. Symbols are + - * / ^ ( ) [ ] , ;
/// = < > <= >= == !=.
struct Token {
  enum class Kind { number, name, symbol, end };
  Kind kind;
  std::string_view text;
  [[nodiscard]] bool is(std::string_view word) const { return text == word; }
};

/// Cuts a formula into words. Blanks and line ends separate and mean nothing else.
class Lexer {
 public:
  /// `source` names the formula in messages. Both must outlive the lexer and its tokens.
  Lexer(std::string_view text, std::string_view source) : text_(text), source_(source) {}

  /// The next word; throws InputError at a character that no formula has.
  Token next();

  /// Throws InputError "source:line:column: found ..., expected ..." at the beginning of `at`; columns count
  /// characters.
  [[noreturn]] void fail(std::string_view at, const std::string& found, const std::string& expected) const;

 private:
  std::string_view take(std::size_t length);

  std::string_view text_, source_;
  std::size_t position_ = 0;
};

/// How a word is called in a message: in quotes, or "the end".
[[nodiscard]] std::string describe(const Token& token);

}  // namespace isocast
