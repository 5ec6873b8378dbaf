#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/apps/reference/formula_ray_reference.h>
#include <isocast/implicit/expression/evaluate.h>
#include <isocast/implicit/expression/simplify.h>
#include <isocast/implicit/solve/inclusion.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isocast::reference {
namespace {

// The tape along a ray, by value and slope in t.
class RaySlope {
 public:
  RaySlope(const Tape& tape, const Double3& o, const Double3& d, double time)
      : tape_(tape), o_(o), d_(d), time_(time), registers_(tape.registers) {}

  struct Value {
    double f, slope;
  };
  [[nodiscard]] Value at(double t) {
    using F = Gradient<double>;
    const Double3 p = o_ + t * d_;
    const F inputs[4] = {{p[0], 1, 0, 0}, {p[1], 0, 1, 0}, {p[2], 0, 0, 1}, F(time_)};
    const F f = evaluate(tape_.view(), inputs, registers_.data());
    return {f.value, dot({f.dx, f.dy, f.dz}, d_)};
  }

 private:
  const Tape& tape_;
  Double3 o_, d_;
  double time_;
  std::vector<Gradient<double>> registers_;
};

double scale_along(RaySlope& ray, double iso, double t0, double t1) {
  constexpr int kPoints = 64;
  double scale = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double value = std::abs(ray.at(t0 + i / (kPoints - 1.0) * (t1 - t0)).f - iso);
    if (std::isfinite(value)) scale = std::max(scale, value);
  }
  return scale;
}

std::string text_of(const Expression& expression) {
  std::string text = fmt::format("root {}", expression.root());
  for (const Node& n : expression.nodes())
    text += fmt::format(" {},{},{},{},{}", static_cast<int>(n.op), n.a, n.b, n.c, n.n);
  for (const Constant& constant : expression.constants()) text += " " + constant.text;
  return text;
}

}  // namespace

FormulaRayReference::FormulaRayReference(const Expression& expression, const Domain& domain, double time,
                                         std::vector<double> iso, const ReferenceOptions& options)
    : domain_(domain),
      time_(time),
      unit_(0),
      iso_(std::move(iso)),
      options_(options),
      tape_(make_tape(simplify(expression))) {
  for (const double value : iso_) references_.emplace_back(expression, value, time);
  for (std::size_t a = 0; a < 3; ++a) unit_ = std::max(unit_, domain.hi[a] - domain.lo[a]);
  identity_ = fmt::format("formula {} time {:a} domain {:a} {:a} iso {:a} bits {} operations {}",
                          text_of(expression), time, fmt::join(domain.lo, " "), fmt::join(domain.hi, " "),
                          fmt::join(iso_, " "), options.max_bits, options.max_operations);
}

RayTruth FormulaRayReference::solve(const Double3& o, const Double3& d, double t0, double t1) const {
  require_ray(o, d, t0, t1);
  for (std::size_t a = 0; a < 3; ++a) {
    if (d[a] == 0) {
      if (!(o[a] >= domain_.lo[a] && o[a] <= domain_.hi[a])) return {};
      continue;
    }
    const double low = (domain_.lo[a] - o[a]) / d[a], high = (domain_.hi[a] - o[a]) / d[a];
    t0 = std::max(t0, std::min(low, high));
    t1 = std::min(t1, std::max(low, high));
  }
  if (!(t0 < t1)) return {};

  RayTruth truth;
  const double units_per_t = length(d) / unit_;
  RaySlope slope(tape_, o, d, time_);
  ReferenceOptions options = options_;
  options.width = 1e-12 / units_per_t;
  for (std::size_t i = 0; i < iso_.size(); ++i) {
    const FormulaRoots found = references_[i].solve(o, d, t0, t1, options);
    const double scale = found.roots.empty() ? 0 : scale_along(slope, iso_[i], t0, t1);
    for (const FormulaRoot& root : found.roots) {
      const double steepness = std::abs(slope.at(0.5 * (root.lo + root.hi)).slope),
                   condition = root.crossing && steepness > 0 ? scale / steepness * units_per_t
                                                              : std::numeric_limits<double>::infinity();
      truth.roots.push_back({root.lo, root.hi, root.crossing, condition,
                             std::numeric_limits<double>::infinity(), static_cast<int>(i)});
    }
    truth.doubts.insert(truth.doubts.end(), found.doubts.begin(), found.doubts.end());
    truth.bits = std::max(truth.bits, found.bits);
  }
  finish(truth, units_per_t);
  return truth;
}

}  // namespace isocast::reference
