// What kernels use, as the compiler says, and what they may use.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace isocast::test {

/// Of a thread: registers, bytes of stack, bytes spilled to it.
struct KernelUse {
  int registers = 0, stack = 0, spills = 0;
};
/// Of every kernel in a log of ptxas -v that was compiled for `architecture`.
[[nodiscard]] std::map<std::string, KernelUse> kernels_in(const std::string& log,
                                                          const std::string& architecture);

/// A line of cuda/budgets.txt; a name that ends with * stands for all that begin so.
struct Budget {
  std::string name;
  KernelUse most;
};
[[nodiscard]] std::vector<Budget> read_budgets(const std::string& file);
/// The first that fits; fails the test where there is none.
[[nodiscard]] const KernelUse& budget_of(const std::vector<Budget>& budgets, const std::string& kernel);
void require_within(const std::vector<Budget>& budgets, const std::string& kernel, const KernelUse& use);

}  // namespace isocast::test
