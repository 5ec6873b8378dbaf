#include <isocast/apps/bench/cell_families.h>
#include <isocast/apps/bench/stress_case.h>

#include <map>

namespace isocast::bench {
namespace {

using enum Counted;

// What neubauer and linear miss by design is in no expectation but where it is much.
const std::map<std::string_view, std::vector<Expectation>>& expectations() {
  const Expectation right = {wrong, 0, 0.1, "marmitt"},
                    right_in_double = {wrong, 0, 0.1, "marmitt", "double"};
  const Expectation decides = {undecided, 0, 0.1, "certified"},
                    decides_in_double = {undecided, 0, 0.5, "certified", "double"};
  static const std::map<std::string_view, std::vector<Expectation>> all = {
      {"random", {{wrong, 30, 100, "midpoint"}, {wrong, 1, 10, "neubauer"}, right, decides}},
      {"smooth", {{wrong, 0, 0.1, "neubauer"}, right, decides}},
      {"quadratic", {right, decides}},
      {"affine", {{wrong, 0, 0, "linear"}, {wrong, 0, 0, "schwarze"}, right, decides}},
      {"constant", {{wrong, 0, 0}, {undecided, 20, 30, "certified"}}},
      {"double-root",
       {{wrong, 30, 100, "neubauer"},
        {wrong, 20, 100, "schwarze", "float"},
        {wrong, 10, 40, "marmitt", "float"},
        right_in_double,
        decides_in_double}},
      {"triple-root", {right, {undecided, 90, 100, "certified", "float"}}},
      {"root-at-end", {{wrong, 20, 100, "schwarze"}, {wrong, 50, 100, "neubauer"}, right}},
      {"root-at-extremum", {{wrong, 30, 100, "schwarze"}, {wrong, 0, 50, "marmitt"}}},
      {"close-roots",
       {{wrong, 40, 100, "neubauer"},
        {wrong, 10, 100, "schwarze", "float"},
        right_in_double,
        decides_in_double}},
      {"mixed-scales", {{wrong, 5, 100, "schwarze"}, right}},
      {"iso-at-corner", {{wrong, 5, 100, "schwarze"}, right}},
      {"thin", {{wrong, 0, 5, "marmitt", "float"}, right_in_double, decides_in_double}},
      {"mc-1-corner", {right, decides}},
      {"mc-2-edge", {right, decides}},
      {"mc-2-face", {right, decides}},
      {"mc-2-cube", {right, decides}},
      {"mc-3-face", {right, decides}},
      {"mc-4-face", {right, decides}},
      {"mc-4-cube", {{wrong, 30, 100, "neubauer"}, right, decides_in_double}},
      {"plateau", {{wrong, 10, 100, "schwarze"}, right}},
      {"checkerboard", {right, decides_in_double}},
      {"denormal",
       {right_in_double, {wrong, 0, 10, "marmitt", "float"}, {undecided, 90, 100, "certified", "float"}}},
      {"any-scale", {right, decides}},
      {"steps", {right}},
      {"axis-aligned", {{wrong, 0, 0, "linear"}, right, decides}},
      {"in-face", {right, decides}},
  };
  return all;
}

}  // namespace

std::vector<StressFamily> stress_families() {
  std::vector<StressFamily> families;
  for (const CellFamily& family : cell_families()) {
    const auto found = expectations().find(family.name);
    families.push_back(
        {family.name, found == expectations().end() ? std::vector<Expectation>() : found->second});
  }
  return families;
}

}  // namespace isocast::bench
