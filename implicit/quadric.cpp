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
  Quadric quadric;
  quadric.flat_ = *degree < 2;
  quadric.c_ = value(0, 0, 0);
  I ahead[3];
  for (int a = 0; a < 3; ++a) {
    ahead[a] = value(a == 0, a == 1, a == 2);
    const I behind = value(-(a == 0), -(a == 1), -(a == 2));
    quadric.l_[a] = I(0.5) * (ahead[a] - behind);
    quadric.q_[a][a] = I(0.5) * (ahead[a] + behind) - quadric.c_;
    if (!(std::abs(ahead[a].lo) + std::abs(behind.hi) < kInfinity<double>)) return std::nullopt;
  }
  for (int a = 0; a < 3; ++a)
    for (int b = a + 1; b < 3; ++b)
      quadric.q_[a][b] = value(a == 0, a == 1 || b == 1, b == 2) - ahead[a] - ahead[b] + quadric.c_;
  return quadric;
}

LinePart Quadric::inside(const Double3& o, const Double3& d) const {
  // g(o + t d) = a t^2 + b t + c
  I a(0.0), b(0.0), c = c_;
  for (int i = 0; i < 3; ++i) {
    b = b + l_[i] * I(d[i]), c = c + l_[i] * I(o[i]);
    if (flat_) continue;
    for (int j = i; j < 3; ++j) {
      a = a + q_[i][j] * (I(d[i]) * I(d[j]));
      b = b + q_[i][j] * (I(o[i]) * I(d[j]) + I(o[j]) * I(d[i]));
      c = c + q_[i][j] * (I(o[i]) * I(o[j]));
    }
  }
  if (flat_) {
    const I zero = -c / b;
    if (b.lo > 0) return widened(-kInfinity<double>, zero.hi);
    if (b.hi < 0) return widened(zero.lo, kInfinity<double>);
    return b.lo == 0 && b.hi == 0 && c.lo > 0 ? kNone : kAll;
  }
  if (!(a.lo > 0)) return kAll;
  const I discriminant = b * b - I(4.0) * a * c;
  if (discriminant.hi < 0) return kNone;
  const I root = sqrt(I(discriminant.hi)), lo = (-b - root) / (I(2.0) * a), hi = (-b + root) / (I(2.0) * a);
  return widened(lo.lo, hi.hi);
}

}  // namespace isocast
