// .vm files: the operations of fidget, a shape in the manner of the Prospero benchmark, and hostile text.
#include <isocast/implicit/expression/vm_tape.h>
#include <temporary_folder.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

#include "evaluate_text.h"

using namespace isocast;
using namespace isocast::test;

namespace {

double tape_value(std::string_view text, const std::array<double, 4>& at = {}) {
  return run(make_tape(simplify(parse_vm_tape(text))), at);
}

double operation(const std::string& name, double x) { return tape_value("a var-x\nb " + name + " a", {x}); }
double operation(const std::string& name, double x, double y) {
  return tape_value("a var-x\nb var-y\nc " + name + " a b", {x, y});
}

std::string tape_complaint(std::string_view text) {
  try {
    static_cast<void>(parse_vm_tape(text));
    return {};
  } catch (const InputError& error) { return error.what(); }
}

// A rectangle joined with a ring, as text in the benchmark is made.
constexpr const char* kShape = R"(# a letter
_0 const 2.5
_1 var-x
_2 const -0.4

_3 sub _1 _2
_4 const 0.3
_5 sub _4 _1
_6 neg _3
_7 neg _5
_8 max _6 _7
_9 var-y
_a square _1
_b square _9
_c add _a _b
_d sqrt _c
_e const 0.75
_f sub _d _e
_10 const .5
_11 sub _10 _d
_12 max _f _11
_13 min _8 _12
)";

}  // namespace

TEST_CASE("a shape of instructions is the shape of its formula") {
  const std::string_view formula =
      "r = sqrt(x^2 + y^2); min(max(-(x + 0.4), -(0.3 - x)), max(r - 0.75, 0.5 - r))";
  for (double x = -1; x <= 1; x += 0.125)
    for (double y = -1; y <= 1; y += 0.125) CHECK(tape_value(kShape, {x, y}) == value(formula, {x, y}));
  CHECK(parse_vm_tape("a const 0.1").constants()[0].text == "1e-1");
}

TEST_CASE("operations mean what they mean in fidget") {
  CHECK(tape_value("0x600 var-z\r\n", {1, 2, 3}) == 3);
  CHECK(tape_value("a\tvar-x\na add a a\nb mul a a", {3}) == 36);
  CHECK(operation("neg", 3) == -3);
  CHECK(operation("abs", -3) == 3);
  CHECK(operation("recip", 4) == 0.25);
  CHECK(operation("sqrt", 9) == 3);
  CHECK(operation("square", -3) == 9);
  CHECK(operation("floor", -1.5) == -2);
  CHECK(operation("ceil", -1.5) == -1);
  CHECK(operation("round", 2.5) == 3);
  CHECK(operation("sin", 0.5) == Approx(std::sin(0.5)));
  CHECK(operation("cos", 0.5) == Approx(std::cos(0.5)));
  CHECK(operation("tan", 0.5) == Approx(std::tan(0.5)));
  CHECK(operation("asin", 0.5) == Approx(std::asin(0.5)));
  CHECK(operation("acos", 0.5) == Approx(std::acos(0.5)));
  CHECK(operation("atan", 0.5) == Approx(std::atan(0.5)));
  CHECK(operation("exp", 0.5) == Approx(std::exp(0.5)));
  CHECK(operation("ln", 0.5) == Approx(std::log(0.5)));
  CHECK(operation("not", 0) == 1);
  CHECK(operation("not", -2) == 0);
  CHECK(operation("add", 3, 4) == 7);
  CHECK(operation("sub", 3, 4) == -1);
  CHECK(operation("mul", 3, 4) == 12);
  CHECK(operation("div", 3, 4) == 0.75);
  CHECK(operation("min", 3, 4) == 3);
  CHECK(operation("max", 3, 4) == 4);
  CHECK(operation("atan2", 3, -4) == Approx(std::atan2(3, -4)));
  CHECK(operation("mod", -7, 3) == 2);
  CHECK(operation("mod", -7, -3) == 2);
  CHECK(operation("compare", 1, 2) == -1);
  CHECK(operation("compare", 2, 2) == 0);
  CHECK(operation("compare", 3, 2) == 1);
  CHECK(std::isnan(operation("compare", std::nan(""), 2)));
  CHECK(operation("and", 0, 7) == 0);
  CHECK(operation("and", 3, 7) == 7);
  CHECK(operation("or", 0, 7) == 7);
  CHECK(operation("or", 3, 7) == 3);
}

TEST_CASE("a tape that cannot be read is named by its line") {
  CHECK(tape_complaint("") == "tape: found no instruction, expected at least one");
  CHECK(tape_complaint("# nothing\n\n").starts_with("tape: found no instruction"));
  CHECK(tape_complaint("a") == "tape:1: found 'a' alone, expected a name and an operation");
  CHECK(tape_complaint("a var-x\n\nb add a") == "tape:3: found 1 operands of 'add', expected 2");
  CHECK(tape_complaint("a var-x 3") == "tape:1: found 1 operands of 'var-x', expected 0");
  CHECK(tape_complaint("b neg a") ==
        "tape:1: found the unknown operand 'a', expected the name of an earlier line");
  CHECK(tape_complaint("a neg a").starts_with("tape:1: found the unknown operand 'a'"));
  CHECK(
      tape_complaint("a frob") ==
      "tape:1: found the unknown operation 'frob', expected const, var-x, add or another one of a .vm tape");
  for (const char* number : {"nan", "inf", "1e999", "x", "--1"})
    CHECK(tape_complaint(std::string("a const ") + number) ==
          "tape:1: found '" + std::string(number) +
              "', expected a number within the range of double precision");
}

TEST_CASE("a deep tape is no deep recursion, and a long one is refused") {
  std::string deep = "a var-x\n";
  for (int i = 0; i < 200000; ++i) deep += "a sin a\n";
  CHECK(std::isfinite(tape_value(deep, {1})));
  std::string doubling = "a var-x\n";
  for (int i = 0; i < 1000; ++i) doubling += "a add a a\n";
  CHECK(tape_value(doubling, {0}) == 0);
  std::string lines;
  for (int i = 0; i < (1 << 20) + 1; ++i) lines += "a var-x\n";
  CHECK(tape_complaint(lines) == "tape:1048577: found more than 1048576 instructions, expected fewer");
  CHECK(tape_complaint(std::string(kMaxVmBytes + 1, '#')) ==
        "tape: found 67108865 bytes, expected at most 67108864");
}

TEST_CASE("a tape is read from a file, which messages name") {
  const TemporaryFolder folder;
  const auto path = folder / "shape.vm";
  std::ofstream(path) << kShape;
  CHECK(run(make_tape(read_vm_file(path)), {0.6, 0, 0, 0}) == tape_value(kShape, {0.6}));
  std::ofstream(path) << "a frob";
  CHECK_THROWS_WITH(read_vm_file(path), Catch::StartsWith(path.string() + ":1: found the unknown operation"));
  CHECK_THROWS_AS(read_vm_file(folder / "none.vm"), InputError);
}
