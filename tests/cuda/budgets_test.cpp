// What the kernels of volumes need of a GPU keeps within cuda/budgets.txt.
#include "budgets.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

using namespace isocast::test;

TEST_CASE("volume kernels keep within their registers and stacks") {
  const std::vector<Budget> budgets = read_budgets(ISO_BUDGETS);
  int kernels = 0;
  for (const char* const name : {"dense_float", "dense_double", "sparse_float", "sparse_double"}) {
    std::ifstream log(std::string(ISO_LOGS "/") + name + ".log");
    REQUIRE(log);
    const std::string text{std::istreambuf_iterator<char>(log), {}};
    for (const auto& [kernel, use] : kernels_in(text, "sm_90")) {
      require_within(budgets, kernel, use);
      ++kernels;
    }
  }
  CHECK(kernels == 36);
}
