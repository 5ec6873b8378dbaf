#include <fmt/format.h>
#include <isocast/apps/reference/ball_search.h>
#include <isocast/apps/reference/formula_polynomial.h>
#include <isocast/apps/reference/formula_reference.h>
#include <isocast/apps/reference/polynomial_roots.h>
#include <isocast/apps/reference/ray_reference.h>
#include <isocast/base/error.h>

#include <algorithm>
#include <cmath>

namespace isocast::reference {
namespace {

// In s: far below what doubles tell apart.
constexpr double kLeastWidth = 0x1p-100;

void require_finite(const char* name, double x) {
  if (!std::isfinite(x))
    throw InputError(fmt::format("{} of the reference is {}, expected a finite number", name, x));
}

// s from 0 to 1 along x0 + t dx, t from t0 to t1.
RayAxis ray_axis(double x0, double dx, double t0, double t1) {
  RayAxis axis = {Ball(x0), Ball(t1)};
  const Ball direction(dx), begin(t0);
  arb_sub(axis.span.set(), axis.span.get(), begin.get(), ARF_PREC_EXACT);
  arb_mul(axis.span.set(), axis.span.get(), direction.get(), ARF_PREC_EXACT);
  arb_addmul(axis.start.set(), direction.get(), begin.get(), ARF_PREC_EXACT);
  return axis;
}
RationalAxis rational_axis(const RayAxis& axis) {
  RationalAxis rational;
  arf_get_fmpq(rational.start.set(), arb_midref(axis.start.get()));
  arf_get_fmpq(rational.span.set(), arb_midref(axis.span.get()));
  return rational;
}

// The doubles at and beside t0 + s (t1 - t0).
struct Times {
  Ball t0, t1;
  [[nodiscard]] double at(const Ball& s, arf_rnd_t rounding) const {
    Ball t;
    arb_sub(t.set(), t1.get(), t0.get(), ARF_PREC_EXACT);
    arb_mul(t.set(), t.get(), s.get(), ARF_PREC_EXACT);
    arb_add(t.set(), t.get(), t0.get(), ARF_PREC_EXACT);
    return arf_get_d(arb_midref(t.get()), rounding);
  }
  [[nodiscard]] double lo(const Bracket& s) const { return at(s.lo, ARF_RND_FLOOR); }
  [[nodiscard]] double hi(const Bracket& s) const { return at(s.hi, ARF_RND_CEIL); }
};

}  // namespace

FormulaReference::FormulaReference(const Expression& expression, double iso, double time) {
  require_finite("the iso-value", iso);
  require_finite("the time", time);
  formula_ = exact_formula(expression, iso, time);
  polynomial_ = is_polynomial(formula_);
}

FormulaRoots FormulaReference::solve(const Double3& o, const Double3& d, double t0, double t1,
                                     const ReferenceOptions& options) const {
  require_ray(o, d, t0, t1);
  const RayAxis axes[3] = {ray_axis(o[0], d[0], t0, t1), ray_axis(o[1], d[1], t0, t1),
                           ray_axis(o[2], d[2], t0, t1)};
  const double width = options.width > 0 ? std::max(options.width / (t1 - t0), kLeastWidth) : 1e-12;
  const Times times = {Ball(t0), Ball(t1)};
  FormulaRoots found;
  if (polynomial_ && options.exact) {
    const WholePolynomial p =
        polynomial_along(formula_, {rational_axis(axes[0]), rational_axis(axes[1]), rational_axis(axes[2])});
    if (fmpz_poly_is_zero(p.get())) found.doubts.push_back({t0, t1, Doubt::zero});
    else
      for (const PolynomialRoot& root : roots_in_unit_interval(p, width, options.max_roots))
        found.roots.push_back({times.lo(root.s), times.hi(root.s), root.crossing});
  } else {
    FormulaBalls balls(formula_, axes);
    const SearchResult result = search(balls, width, options);
    for (const SearchRoot& root : result.roots)
      found.roots.push_back({times.lo(root.s), times.hi(root.s), root.crossing});
    for (const SearchDoubt& doubt : result.doubts)
      found.doubts.push_back({times.lo(doubt.s), times.hi(doubt.s), doubt.doubt});
    found.bits = static_cast<int>(result.bits);
  }
  found.end = found.roots.size() >= options.max_roots && !found.roots.empty() ? found.roots.back().hi : t1;
  return found;
}

}  // namespace isocast::reference
