// docs/formulas.md has a row for every function, and for nothing else.
#include <isocast/implicit/expression/builtins.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <set>
#include <string>

using namespace isocast;

namespace {

// The rows of the table of functions, "| `name(arguments)` | derivative | interval | affine | decoration |".
std::multiset<std::string> documented_functions() {
  std::ifstream file(FORMULAS_DOC);
  REQUIRE(file);
  std::multiset<std::string> names;
  bool in_table = false;
  for (std::string line; std::getline(file, line);) {
    in_table |= line.starts_with("| function |");
    if (!in_table || !line.starts_with("| `")) continue;
    INFO(line);
    names.insert(line.substr(3, line.find('(') - 3));
    CHECK(std::ranges::count(line, '|') == 6);
    CHECK(line.find("| |") == std::string::npos);
  }
  return names;
}

}  // namespace

TEST_CASE("the table of functions and the documentation are in step") {
  std::multiset<std::string> expected = {"sum"};
  for (const Builtin& function : builtins()) expected.emplace(function.name);
  CHECK(documented_functions() == expected);
}
