#include "budgets.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <regex>
#include <sstream>

namespace isocast::test {

std::map<std::string, KernelUse> kernels_in(const std::string& log, const std::string& architecture) {
  static const std::regex entry("Compiling entry function '([^']*)' for '([^']*)'"),
      frame("([0-9]+) bytes stack frame, ([0-9]+) bytes spill stores, ([0-9]+) bytes spill loads"),
      used("Used ([0-9]+) registers");
  std::map<std::string, KernelUse> kernels;
  std::istringstream lines(log);
  std::string line, kernel;
  bool has_frame = false;
  for (std::smatch match; std::getline(lines, line);) {
    if (std::regex_search(line, match, entry)) {
      kernel = match[2] == architecture ? match[1].str() : std::string();
      has_frame = false;
    }
    if (kernel.empty()) continue;
    KernelUse& use = kernels[kernel];
    // the entry's own come first; those of functions that it calls follow
    if (!has_frame && std::regex_search(line, match, frame)) {
      use.stack = std::stoi(match[1]);
      use.spills = std::stoi(match[2]) + std::stoi(match[3]);
      has_frame = true;
    }
    if (std::regex_search(line, match, used)) use.registers = std::max(use.registers, std::stoi(match[1]));
  }
  return kernels;
}

std::vector<Budget> read_budgets(const std::string& file) {
  std::ifstream stream(file);
  std::vector<Budget> budgets;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line.front() == '#') continue;
    std::istringstream words(line);
    Budget budget;
    words >> budget.name >> budget.most.registers >> budget.most.stack >> budget.most.spills;
    REQUIRE(words);
    budgets.push_back(budget);
  }
  REQUIRE_FALSE(budgets.empty());
  return budgets;
}

const KernelUse& budget_of(const std::vector<Budget>& budgets, const std::string& kernel) {
  for (const Budget& budget : budgets)
    if (budget.name == kernel ||
        (budget.name.ends_with('*') && kernel.starts_with(budget.name.substr(0, budget.name.size() - 1))))
      return budget.most;
  FAIL("no budget for " << kernel);
  return budgets.front().most;
}

void require_within(const std::vector<Budget>& budgets, const std::string& kernel, const KernelUse& use) {
  const KernelUse& most = budget_of(budgets, kernel);
  INFO(kernel << ": " << use.registers << " registers, " << use.stack << " bytes of stack, " << use.spills
              << " spilled");
  CHECK(use.registers > 0);
  CHECK(use.registers <= most.registers);
  CHECK(use.stack <= most.stack);
  CHECK(use.spills <= most.spills);
}

}  // namespace isocast::test
