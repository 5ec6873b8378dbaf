#include <isocast/implicit/expression/polynomial.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isocast {
namespace {

// Polynomials that are remembered, which bounds time and memory for formulas of a million parts.
constexpr std::size_t kMaxKnown = 20000;

bool share_base(const Polynomial& a, const Polynomial& b) {
  return a.base == b.base || a.base == Polynomial::kNoBase || b.base == Polynomial::kNoBase;
}

Polynomial trimmed(Polynomial a) {
  while (!a.c.empty() && a.c.back() == 0) a.c.pop_back();
  return a;
}

// a + sign b; nothing when they have no common base or a coefficient is too large.
std::optional<Polynomial> sum(const Polynomial& a, const Polynomial& b, int sign) {
  if (!share_base(a, b)) return std::nullopt;
  Polynomial result{std::min(a.base, b.base), a.c};
  result.c.resize(std::max(a.c.size(), b.c.size()), 0);
  for (std::size_t k = 0; k < b.c.size(); ++k) {
    std::int64_t term;
    if (__builtin_mul_overflow(b.c[k], sign, &term) ||
        __builtin_add_overflow(result.c[k], term, &result.c[k]))
      return std::nullopt;
  }
  return trimmed(std::move(result));
}

std::optional<Polynomial> product(const Polynomial& a, const Polynomial& b) {
  if (!share_base(a, b) || a.c.size() + b.c.size() > Polynomials::kMaxDegree + 2) return std::nullopt;
  Polynomial result{std::min(a.base, b.base), {}};
  if (a.c.empty() || b.c.empty()) return result;
  result.c.resize(a.c.size() + b.c.size() - 1, 0);
  for (std::size_t i = 0; i < a.c.size(); ++i)
    for (std::size_t k = 0; k < b.c.size(); ++k) {
      std::int64_t term;
      if (__builtin_mul_overflow(a.c[i], b.c[k], &term) ||
          __builtin_add_overflow(result.c[i + k], term, &result.c[i + k]))
        return std::nullopt;
    }
  return result;
}

std::optional<Polynomial> power(const Polynomial& a, int n) {
  if (n < 0 || n > Polynomials::kMaxDegree) return std::nullopt;
  std::optional<Polynomial> result = Polynomial{Polynomial::kNoBase, {1}};
  for (int i = 0; i < n && result; ++i) result = product(*result, a);
  return result;
}

}  // namespace

std::vector<std::int64_t> chebyshev_coefficients(int n) {
  std::vector<std::int64_t> before, now = {1};
  for (int k = 0; k < n; ++k) {
    // 2 x T_k - T_(k-1), but T_1 = x
    std::vector<std::int64_t> next(now.size() + 1, 0);
    for (std::size_t i = 0; i < now.size(); ++i) next[i + 1] = (k == 0 ? 1 : 2) * now[i];
    for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
    before = std::exchange(now, std::move(next));
  }
  return now;
}

std::optional<Polynomials::Chebyshev> Polynomials::as_chebyshev(NodeId id) {
  // once a node
  auto place = known_.find(id);
  if (place == known_.end()) {
    if (known_.size() >= kMaxKnown) return std::nullopt;
    std::optional<Polynomial> polynomial = computed(graph_.node(id));
    if (!polynomial || polynomial->base == Polynomial::kNoBase) return std::nullopt;
    place = known_.emplace(id, std::move(*polynomial)).first;
  }

  // the highest coefficient first, which nearly no other polynomial has
  const std::vector<std::int64_t>& c = place->second.c;
  const int degree = static_cast<int>(c.size()) - 1;
  if (degree < 3 || c.back() != std::int64_t{1} << (degree - 1) || c != chebyshev_coefficients(degree))
    return std::nullopt;
  return Chebyshev{place->second.base, degree};
}

Polynomial Polynomials::of(NodeId id) const {
  if (const auto found = known_.find(id); found != known_.end()) return found->second;
  const Node& node = graph_.node(id);
  if (node.op == Op::chebyshev && node.n <= kMaxDegree) return {node.a, chebyshev_coefficients(node.n)};
  if (node.op == Op::constant) {
    const Constant& number = graph_.constant_at(id);
    if (number.exact && std::abs(number.value) < 0x1p62 && number.value == std::floor(number.value))
      return trimmed({Polynomial::kNoBase, {static_cast<std::int64_t>(number.value)}});
  }
  return {id, {0, 1}};
}

std::optional<Polynomial> Polynomials::computed(const Node& node) const {
  switch (node.op) {
    case Op::negate: return sum({}, of(node.a), -1);
    case Op::add: return sum(of(node.a), of(node.b), 1);
    case Op::subtract: return sum(of(node.a), of(node.b), -1);
    case Op::multiply: return product(of(node.a), of(node.b));
    case Op::square: return power(of(node.a), 2);
    case Op::power: return power(of(node.a), node.n);
    default: return std::nullopt;
  }
}

}  // namespace isocast
