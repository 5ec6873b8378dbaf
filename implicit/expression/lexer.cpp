#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/text.h>
#include <isocast/implicit/expression/lexer.h>
#include <isocast/implicit/expression/nearest_name.h>

#include <algorithm>

namespace isocast {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

std::size_t count_digits(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::find_if_not(text, is_digit) - text.begin());
}

// Length of digits[.digits][e[sign]digits] at the beginning of `text`; an 'e' without digits is not part of
// it.
std::size_t number_length(std::string_view text) {
  std::size_t length = count_digits(text);
  if (length < text.size() && text[length] == '.') length += 1 + count_digits(text.substr(length + 1));
  if (length < text.size() && (text[length] == 'e' || text[length] == 'E')) {
    const bool has_sign = length + 1 < text.size() && (text[length + 1] == '-' || text[length + 1] == '+');
    const std::size_t exponent = length + 1 + has_sign;
    if (const std::size_t digits = count_digits(text.substr(std::min(exponent, text.size()))))
      length = exponent + digits;
  }
  return length;
}

std::size_t symbol_length(std::string_view text) {
  if (text.size() > 1 && text[1] == '=' && std::string_view("<>=!").find(text[0]) != std::string_view::npos)
    return 2;
  return std::string_view("+-*/^()[],;=<>").find(text[0]) != std::string_view::npos ? 1 : 0;
}

// The character at the beginning of `text` for a message: itself when it is printable UTF-8, else its first
// byte.
std::string describe_character(std::string_view text) {
  const unsigned char lead = static_cast<unsigned char>(text[0]);
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : lead >= 0xc2 ? 2 : 1;
  const bool ascii = lead >= ' ' && lead < 0x7f;
  const bool sequence = length > 1 && text.size() >= length && lead < 0xf5 &&
                        std::ranges::all_of(text.substr(1, length - 1), is_continuation);
  if (ascii || sequence) return fmt::format("the character '{}'", text.substr(0, length));
  return fmt::format("the byte 0x{:02X}", lead);
}

}  // namespace

Token Lexer::next() {
  while (position_ < text_.size() && is_blank(text_[position_])) ++position_;
  const std::string_view rest = text_.substr(position_);
  if (rest.empty()) return {Token::Kind::end, rest};
  if (is_digit(rest[0]) || (rest[0] == '.' && rest.size() > 1 && is_digit(rest[1])))
    return {Token::Kind::number, take(number_length(rest))};
  if (is_letter(rest[0])) {
    const auto end = std::ranges::find_if_not(rest, [](char c) { return is_letter(c) || is_digit(c); });
    return {Token::Kind::name, take(static_cast<std::size_t>(end - rest.begin()))};
  }
  if (const std::size_t length = symbol_length(rest)) return {Token::Kind::symbol, take(length)};
  fail(rest, describe_character(rest), "a number, a name, an operator or a parenthesis");
}

std::string_view Lexer::take(std::size_t length) {
  const std::string_view word = text_.substr(position_, length);
  position_ += length;
  return word;
}

void Lexer::fail(std::string_view at, const std::string& found, const std::string& expected) const {
  const std::string_view before = text_.substr(0, static_cast<std::size_t>(at.data() - text_.data()));
  const auto line = 1 + std::ranges::count(before, '\n');
  const std::string_view line_before = before.substr(before.rfind('\n') + 1);
  const auto column = 1 + std::ranges::count_if(line_before, [](char c) { return !is_continuation(c); });
  throw InputError(fmt::format("{}:{}:{}: found {}, expected {}", source_, line, column, found, expected));
}

std::string describe(const Token& token) {
  return token.kind == Token::Kind::end ? "the end of the formula" : in_quotes(token.text);
}

}  // namespace isocast
