// The words of a formula one after the other, from any place again.
#pragma once

#include <isocast/implicit/expression/lexer.h>

#include <string>
#include <string_view>

namespace isocast {

/// Words that a formula may have when its functions and sums are written out.
inline constexpr int kMaxFormulaWords = 1 << 20;

/// Where reading goes on: `token` is the next word, `lexer` has the ones after it.
struct Place {
  Lexer lexer;
  Token token;
};

/// Reads on from a place, and throws InputError "source:line:column: found ..., expected ..." for what should
/// not be there, and after kMaxFormulaWords words.
class Reader {
 public:
  Reader(std::string_view text, std::string_view source);

  [[nodiscard]] const Token& token() const { return place_.token; }
  [[nodiscard]] const Place& place() const { return place_; }
  void go_to(const Place& place) { place_ = place; }

  /// Goes on by a word and returns the one that was passed.
  Token advance();
  /// Passes `symbol`, or fails with what was `expected`.
  void expect(std::string_view symbol, std::string_view expected);

  /// Fails at the next word, which is what was found, or at another word.
  [[noreturn]] void fail(std::string_view expected) const;
  [[noreturn]] void fail(const Token& at, const std::string& found, const std::string& expected) const;

 private:
  Place place_;
  int words_ = 0;
};

}  // namespace isocast
