#include <fmt/format.h>
#include <isocast/cuda/expression_source.h>
#include <isocast/implicit/expression/evaluate.h>

#include <cmath>

namespace isocast {
namespace {

// A kind of number whose operations write themselves down: the tape is run on it.
struct Text {
  std::string name;
};

thread_local std::string* written = nullptr;
thread_local int values = 0;

Text value(const std::string& expression) {
  Text text{fmt::format("v{}", values++)};
  *written += fmt::format("  const R {} = {};\n", text.name, expression);
  return text;
}
std::string literal(double number) {
  if (std::isnan(number)) return "__builtin_nan(\"\")";
  if (std::isinf(number)) return number < 0 ? "-__builtin_inf()" : "__builtin_inf()";
  return fmt::format("{:a}", number);
}

Text constant_as(TapeConstant constant, const Text&) {
  return value(
      fmt::format("constant_as(TapeConstant{{{}, {}}}, R{{}})", literal(constant.value), constant.exact));
}

Text operator-(const Text& a) { return value(fmt::format("-{}", a.name)); }
Text operator+(const Text& a, const Text& b) { return value(fmt::format("{} + {}", a.name, b.name)); }
Text operator-(const Text& a, const Text& b) { return value(fmt::format("{} - {}", a.name, b.name)); }
Text operator*(const Text& a, const Text& b) { return value(fmt::format("{} * {}", a.name, b.name)); }
Text operator/(const Text& a, const Text& b) { return value(fmt::format("{} / {}", a.name, b.name)); }

#define ISO_UNARY(f) \
  Text f(const Text& a) { return value(fmt::format(#f "({})", a.name)); }
#define ISO_WHOLE(f) \
  Text f(const Text& a, int n) { return value(fmt::format(#f "({}, {})", a.name, n)); }
#define ISO_BINARY(f) \
  Text f(const Text& a, const Text& b) { return value(fmt::format(#f "({}, {})", a.name, b.name)); }
ISO_UNARY(abs)
ISO_UNARY(sign)
ISO_UNARY(square)
ISO_UNARY(sqrt)
ISO_UNARY(cbrt)
ISO_UNARY(exp)
ISO_UNARY(log)
ISO_UNARY(log10)
ISO_UNARY(sin)
ISO_UNARY(cos)
ISO_UNARY(tan)
ISO_UNARY(asin)
ISO_UNARY(acos)
ISO_UNARY(atan)
ISO_UNARY(sinh)
ISO_UNARY(cosh)
ISO_UNARY(tanh)
ISO_UNARY(floor)
ISO_UNARY(ceil)
ISO_UNARY(round)
ISO_WHOLE(power)
ISO_WHOLE(chebyshev)
ISO_BINARY(min)
ISO_BINARY(max)
ISO_BINARY(pow)
ISO_BINARY(atan2)
ISO_BINARY(step)
#undef ISO_UNARY
#undef ISO_WHOLE
#undef ISO_BINARY
Text choose(const Text& a, const Text& b, const Text& c) {
  return value(fmt::format("choose({}, {}, {})", a.name, b.name, c.name));
}

constexpr const char* kBefore = R"(// One formula in the tape's place.
#pragma once

#include <isocast/implicit/expression/instruction.h>
#include <isocast/implicit/expression/operations.h>

namespace isocast::inline ISO_ISA {

template <Real R> ISO_HD inline R constant_as(TapeConstant constant, R) {
  return R(static_cast<Scalar<R>>(constant.value));
}

template <class R>
ISO_HD inline void the_formula([[maybe_unused]] const R& x, [[maybe_unused]] const R& y, [[maybe_unused]] const R& z,
                               [[maybe_unused]] const R& w, R* registers) {
)";
constexpr const char* kAfter = R"(}

template <int kStride, class R>
ISO_HD inline const R* evaluate_some(const TapeView&, const R* inputs, R* registers, int count) {
  if constexpr (kStride == 1) the_formula(inputs[0], inputs[1], inputs[2], inputs[3], registers);
  else
    for (int k = 0; k < count; ++k)
      the_formula(inputs[k], inputs[kStride + k], inputs[2 * kStride + k], inputs[3 * kStride + k], registers + k);
  return registers;
}

}  // namespace isocast::inline ISO_ISA
)";

}  // namespace

std::string expression_body(const Tape& tape) {
  std::string body;
  written = &body;
  values = 0;
  const Text inputs[4] = {{"x"}, {"y"}, {"z"}, {"w"}};
  std::vector<Text> registers(tape.registers);
  const Text result = *evaluate_some<1>(tape.view(), inputs, registers.data(), 1);
  written = nullptr;
  return fmt::format("{}  *registers = {};\n", body, result.name);
}

std::string expression_header(const Tape& tape) { return kBefore + expression_body(tape) + kAfter; }

}  // namespace isocast
