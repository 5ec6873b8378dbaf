#include <fmt/format.h>
#include <isocast/apps/bench/stress_texts.h>
#include <isocast/implicit/expression/polynomial.h>

#include <cstdint>
#include <vector>

namespace isocast::bench {
namespace {

// Highest powers first, those from `least` on.
std::string powers(const std::vector<std::int64_t>& c, const std::string& base, std::size_t least) {
  std::string text;
  for (std::size_t k = c.size(); k-- > least;)
    if (c[k] != 0) text += fmt::format("{}{}*{}^{}", c[k] < 0 || text.empty() ? "" : "+", c[k], base, k);
  return text;
}

}  // namespace

std::string chebyshev_powers(const char* variable) { return powers(chebyshev_coefficients(50), variable, 1); }

std::string wilkinson_factors(int n) {
  std::string text;
  for (int k = 1; k <= n; ++k) text += fmt::format("{}({}*x-{})", text.empty() ? "" : "*", n, k);
  return text;
}

std::string wilkinson_powers(int n) {
  // in u = n x, a factor u - k at a time
  std::vector<std::int64_t> c = {1};
  for (int k = 1; k <= n; ++k) {
    c.insert(c.begin(), 0);
    for (std::size_t i = 0; i + 1 < c.size(); ++i) c[i] -= k * c[i + 1];
  }
  return powers(c, fmt::format("({}*x)", n), 0);
}

}  // namespace isocast::bench
