#include <isocast/implicit/expression/degree.h>
#include <isocast/implicit/quadric.h>
#include <isocast/implicit/solve/inclusion.h>

#include <cmath>
#include <vector>

namespace isocast {
namespace {

using I = Interval<double>;

constexpr LinePart kAll = {-kInfinity<double>, kInfinity<double>},
                   kNone = {kInfinity<double>, -kInfinity<double>};

LinePart widened(double lo, double hi) {
  const auto room = [](double t) { return std::abs(t) < kInfinity<double> ? 0x1p-40 * std::abs(t) : 0.0; };
  return {lo - room(lo), hi + room(hi)};
}

// A sum of products, and how far the true one may be: more than all roundings on the way.
struct Sum {
  double value = 0, error = 0;
  void add(double coefficient, double off, double x) {
    value += coefficient * x;
    error += (off + 0x1p-47 * std::abs(coefficient)) * std::abs(x);
  }
  [[nodiscard]] double lo() const { return value - error; }
  [[nodiscard]] double hi() const { return value + error; }
};

// The least and the largest of n / d, d from d_lo > 0 to d_hi.
double least(double n, double d_lo, double d_hi) { return n / (n < 0 ? d_lo : d_hi); }
double most(double n, double d_lo, double d_hi) { return n / (n < 0 ? d_hi : d_lo); }

}  // namespace

std::optional<Quadric> Quadric::of(const Tape& g, double time) {
  const auto degree = polynomial_degree(g).degree;
  if (!degree || *degree > 2) return std::nullopt;
  std::vector<I> registers(g.registers);
  const auto value = [&](int x, int y, int z) {
    const I point[4] = {I(x), I(y), I(z), I(time)};
    return evaluate(g.view(), point, registers.data());
  };
  // values that decide a polynomial of degree 2: at 0, +-e_i and e_i + e_j
  bool finite = true;
  const auto coefficient = [&finite](const I& a) {
    finite = finite && std::abs(a.lo) + std::abs(a.hi) < kInfinity<double>;
    return Coefficient{0.5 * (a.lo + a.hi), a.hi - a.lo};
  };
  Quadric quadric;
  quadric.flat_ = *degree < 2;
  const I middle = value(0, 0, 0);
  quadric.c_ = coefficient(middle);
  I ahead[3];
  for (int a = 0; a < 3; ++a) {
    ahead[a] = value(a == 0, a == 1, a == 2);
    const I behind = value(-(a == 0), -(a == 1), -(a == 2));
    quadric.l_[a] = coefficient(I(0.5) * (ahead[a] - behind));
    quadric.q_[a][a] = coefficient(I(0.5) * (ahead[a] + behind) - middle);
  }
  for (int a = 0; a < 3; ++a)
    for (int b = a + 1; b < 3; ++b)
      quadric.q_[a][b] = coefficient(value(a == 0, a == 1 || b == 1, b == 2) - ahead[a] - ahead[b] + middle);
  if (!finite) return std::nullopt;
  return quadric;
}

LinePart Quadric::inside(const Double3& o, const Double3& d) const {
  // g(o + t d) = a t^2 + b t + c
  Sum a, b, c;
  c.add(c_.value, c_.error, 1);
  for (int i = 0; i < 3; ++i) {
    const auto [l, l_off] = l_[i];
    b.add(l, l_off, d[i]), c.add(l, l_off, o[i]);
    for (int j = i; j < 3 && !flat_; ++j) {
      const auto [q, q_off] = q_[i][j];
      a.add(q, q_off, d[i] * d[j]), c.add(q, q_off, o[i] * o[j]);
      b.add(q, q_off, o[i] * d[j]), b.add(q, q_off, o[j] * d[i]);
    }
  }
  if (flat_) {
    if (b.lo() > 0) return widened(-kInfinity<double>, most(-c.lo(), b.lo(), b.hi()));
    if (b.hi() < 0) return widened(least(c.lo(), -b.hi(), -b.lo()), kInfinity<double>);
    return b.value == 0 && b.error == 0 && c.lo() > 0 ? kNone : kAll;
  }
  if (!(a.lo() > 0)) return kAll;
  const double b_most = std::abs(b.value) + b.error, ac_least = c.lo() * (c.lo() < 0 ? a.hi() : a.lo());
  const double discriminant =
      b_most * b_most - 4 * ac_least + 0x1p-47 * (b_most * b_most + 4 * std::abs(ac_least));
  if (discriminant < 0) return kNone;
  const double root = std::sqrt(discriminant) * (1 + 0x1p-47);
  return widened(0.5 * least(-b.hi() - root, a.lo(), a.hi()), 0.5 * most(-b.lo() + root, a.lo(), a.hi()));
}

}  // namespace isocast
