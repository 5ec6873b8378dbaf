#include <arb_fmpz_poly.h>
#include <flint/nmod_poly.h>
#include <isocast/apps/reference/polynomial_roots.h>

#include <utility>

namespace isocast::reference {
namespace {

constexpr ulong kPrime = (ulong{1} << 61) - 1;

// No multiple root modulo a prime: none at all. The reverse is not certain.
bool is_surely_square_free(const WholePolynomial& p) {
  if (fmpz_fdiv_ui(fmpz_poly_lead(p.get()), kPrime) == 0) return false;
  nmod_poly_t image;
  nmod_poly_init(image, kPrime);
  fmpz_poly_get_nmod_poly(image, p.get());
  const bool square_free = nmod_poly_is_squarefree(image);
  nmod_poly_clear(image);
  return square_free;
}

WholePolynomial square_free_part(const WholePolynomial& p) {
  WholePolynomial derivative, common, part;
  fmpz_poly_derivative(derivative.set(), p.get());
  fmpz_poly_gcd(common.set(), p.get(), derivative.get());
  fmpz_poly_div(part.set(), p.get(), common.get());
  return part;
}

// At an exact point; the sign is always known.
Ball value_at(const WholePolynomial& p, const Ball& s) {
  Ball value;
  for (slong bits = 128; value.sign() == 0; bits *= 2) {
    arb_fmpz_poly_evaluate_arb(value.set(), p.get(), s.get(), bits);
    if (arb_is_exact(value.get())) break;
  }
  return value;
}

// The sign just behind (side 1) or just before (side -1) a point.
int sign_beside(const WholePolynomial& p, const Ball& s, int side) {
  WholePolynomial derivative = p;
  for (int sign = 1;; sign *= side) {
    const Ball value = value_at(derivative, s);
    if (!value.is_zero()) return sign * value.sign();
    fmpz_poly_derivative(derivative.set(), derivative.get());
  }
}

// Bernstein coefficients on a part [n, n + 1] / 2^depth of [0, 1], times any positive number. `begins`:
// whether its left end was no end of a part before.
struct Part {
  WholePolynomial b;
  Rational n;
  slong depth;
  bool begins;
};
fmpz* coefficient(WholePolynomial& b, slong i) { return b.set()->coeffs + i; }

// sum of C(i, j) / C(degree, j) c[j], times what makes it whole
WholePolynomial bernstein_of(const WholePolynomial& p) {
  const slong degree = fmpz_poly_degree(p.get());
  Rational scale, binomial;
  fmpz* const all = fmpq_numref(scale.set());
  fmpz* const one = fmpq_numref(binomial.set());
  fmpz_one(all);
  for (slong j = 0; j <= degree; ++j) {
    fmpz_bin_uiui(one, static_cast<ulong>(degree), static_cast<ulong>(j));
    fmpz_lcm(all, all, one);
  }
  WholePolynomial b = p;
  for (slong j = 0; j <= degree; ++j) {
    fmpz_bin_uiui(one, static_cast<ulong>(degree), static_cast<ulong>(j));
    fmpz_mul(coefficient(b, j), coefficient(b, j), all);
    fmpz_divexact(coefficient(b, j), coefficient(b, j), one);
  }
  for (slong k = 1; k <= degree; ++k)
    for (slong i = degree; i >= k; --i) fmpz_add(coefficient(b, i), coefficient(b, i), coefficient(b, i - 1));
  return b;
}

int variations(const WholePolynomial& b, slong degree) {
  int count = 0, last = 0;
  for (slong i = 0; i <= degree; ++i) {
    const int sign = fmpz_sgn(b.get()->coeffs + i);
    if (sign * last < 0) ++count;
    if (sign != 0) last = sign;
  }
  return count;
}

// Both halves, by de Casteljau's construction without its divisions.
std::pair<WholePolynomial, WholePolynomial> halves(WholePolynomial right, slong degree) {
  WholePolynomial left;
  fmpz_poly_fit_length(left.set(), degree + 1);
  fmpz_poly_set_coeff_ui(left.set(), degree, 1);
  for (slong k = 0; k <= degree; ++k) {
    const auto shift = static_cast<ulong>(degree - k);
    fmpz_mul_2exp(coefficient(left, k), coefficient(right, 0), shift);
    for (slong i = 0; i < degree - k; ++i)
      fmpz_add(coefficient(right, i), coefficient(right, i), coefficient(right, i + 1));
    fmpz_mul_2exp(coefficient(right, degree - k), coefficient(right, degree - k), shift);
  }
  return {std::move(left), std::move(right)};
}

Ball point(const Rational& n, slong depth) {
  Ball s;
  arb_set_fmpz(s.set(), fmpq_numref(n.get()));
  arb_mul_2exp_si(s.set(), s.get(), -depth);
  return s;
}

// The root in the open part, all of whose inner points are told apart by signs.
Bracket refined(const WholePolynomial& p, Part& part, slong degree, double width) {
  Bracket root = {point(part.n, part.depth), Ball()};
  Rational next = part.n;
  fmpz_add_ui(fmpq_numref(next.set()), fmpq_numref(next.get()), 1);
  root.hi = point(next, part.depth);
  // the coefficients at the ends are values there, or tell the sign beside a root there
  const auto end_value = [&](slong first, slong step) {
    Ball value;
    for (slong i = first; value.is_zero(); i += step) arb_set_fmpz(value.set(), coefficient(part.b, i));
    return value;
  };
  return refine([&](const Ball& s) { return value_at(p, s); }, std::move(root), end_value(0, 1),
                end_value(degree, -1), width);
}

}  // namespace

std::vector<PolynomialRoot> roots_in_unit_interval(const WholePolynomial& p, double width,
                                                   std::size_t max_roots) {
  const bool simple = is_surely_square_free(p);
  const WholePolynomial q = simple ? p : square_free_part(p);
  const slong degree = fmpz_poly_degree(q.get());
  std::vector<PolynomialRoot> roots;
  const auto add = [&](Bracket s) {
    const bool exact = arb_equal(s.lo.get(), s.hi.get());
    const bool crossing =
        simple || sign_beside(p, s.lo, exact ? -1 : 1) != sign_beside(p, s.hi, exact ? 1 : -1);
    roots.push_back({std::move(s), crossing});
  };

  // from left to right; a part lists the root at its left end, and one within
  std::vector<Part> parts = {{bernstein_of(q), Rational(), 0, true}};
  while (!parts.empty() && roots.size() < max_roots) {
    Part part = std::move(parts.back());
    parts.pop_back();
    if (part.begins && fmpz_is_zero(coefficient(part.b, 0))) {
      const Ball s = point(part.n, part.depth);
      add({s, s});
      if (roots.size() >= max_roots) break;
    }
    const int count = variations(part.b, degree);
    if (count == 1) add(refined(q, part, degree, width));
    if (count < 2) continue;
    auto [left, right] = halves(std::move(part.b), degree);
    fmpz* const n = fmpq_numref(part.n.set());
    fmpz_mul_2exp(n, n, 1);
    Rational next = part.n;
    fmpz_add_ui(fmpq_numref(next.set()), fmpq_numref(next.get()), 1);
    parts.push_back({std::move(right), std::move(next), part.depth + 1, true});
    parts.push_back({std::move(left), std::move(part.n), part.depth + 1, false});
  }
  const Ball one(1);
  if (roots.size() < max_roots && value_at(q, one).is_zero()) add({one, one});
  return roots;
}

}  // namespace isocast::reference
