// Where rays are in trees of operands.
#include <isocast/ray/csg_sides.h>

#include "csg_parts.h"

using namespace isocast;
using namespace isocast::test;

namespace {

// Four rays, in none of two operands, in the first, in the second and in both.
struct Two {
  explicit Two(CsgOperation operation, bool above = false)
      : part(join(operation, {CsgPart(), CsgPart()})),
        operands{{nullptr, 1, above}, {nullptr, 1, above}},
        sides(part, operands) {
    for (int i = 0; i < 4; ++i)
      for (const std::size_t k : {0u, 1u}) sides.set(k, i, (i >> k & 1) != int(above));
  }
  [[nodiscard]] std::string inside() const { return sides.inside().to_string().substr(kStreamSize - 4); }
  [[nodiscard]] std::string settled() const { return sides.settled().to_string().substr(kStreamSize - 4); }

  CsgPart part;
  std::vector<CsgOperand> operands;
  CsgSides sides;
};

}  // namespace

TEST_CASE("rays are in a solid as its operation says") {
  // the ray in both is the first letter
  for (const bool above : {false, true}) {
    CHECK(Two(CsgOperation::unite, above).inside() == "1110");
    CHECK(Two(CsgOperation::intersect, above).inside() == "1000");
    CHECK(Two(CsgOperation::subtract, above).inside() == "0010");
  }
}

TEST_CASE("a solid is left out of one operand at a time") {
  Two two(CsgOperation::subtract);
  CHECK(two.sides.inside_without(1).to_string().substr(kStreamSize - 4) == "1010");
  CHECK(two.sides.inside_without(0).none());
  CHECK(two.inside() == "0010");
}

TEST_CASE("several iso-values of an operand: the outermost bounds it") {
  const CsgPart part;
  const std::vector<CsgOperand> below = {{nullptr, 2, false}}, above = {{nullptr, 2, true}};
  CsgSides of_below(part, below), of_above(part, above);
  for (int i = 0; i < 4; ++i) {
    const auto sides = static_cast<std::uint32_t>(i);
    of_below.set(0, i, sides), of_above.set(0, i, sides);
    CHECK(of_below.inside()[i] == (sides != 0));
    CHECK(of_above.inside()[i] == (sides != 3));
    CHECK(of_below.of(0, i) == sides);
  }
}

TEST_CASE("a ray is settled when the operands in which it stays decide") {
  const auto with_first = [](CsgOperation operation) {
    Two two(operation);
    for (int i = 0; i < 4; ++i) two.sides.stay(0, i);
    return two.settled();
  };
  CHECK(with_first(CsgOperation::unite) == "1010");
  CHECK(with_first(CsgOperation::intersect) == "0101");
  CHECK(with_first(CsgOperation::subtract) == "0101");
  Two two(CsgOperation::subtract);
  for (int i = 0; i < 4; ++i) two.sides.stay(1, i);
  CHECK(two.settled() == "1100");
}
