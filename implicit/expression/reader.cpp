#include <fmt/format.h>
#include <isocast/implicit/expression/reader.h>

#include <utility>

namespace isocast {

Reader::Reader(std::string_view text, std::string_view source) : place_{Lexer(text, source), {}} {
  place_.token = place_.lexer.next();
}

Token Reader::advance() {
  if (++words_ > kMaxFormulaWords)
    fail(token(), fmt::format("more than {} words with functions and sums written out", kMaxFormulaWords),
         "fewer");
  return std::exchange(place_.token, place_.lexer.next());
}

void Reader::expect(std::string_view symbol, std::string_view expected) {
  if (!token().is(symbol)) fail(expected);
  advance();
}

void Reader::fail(std::string_view expected) const {
  fail(token(), describe(token()), std::string(expected));
}

void Reader::fail(const Token& at, const std::string& found, const std::string& expected) const {
  place_.lexer.fail(at.text, found, expected);
}

}  // namespace isocast
