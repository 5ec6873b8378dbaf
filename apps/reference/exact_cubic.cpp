#include <isocast/apps/reference/exact_cubic.h>

#include <algorithm>
#include <utility>

namespace isocast::reference {
namespace {

// Bernstein coefficients on an interval, times any positive number.
using Bernstein = std::array<mpz_class, 4>;

Bernstein bernstein_of(const ExactCubic& p) {
  return {3 * p[0], 3 * p[0] + p[1], 3 * p[0] + 2 * p[1] + p[2], 3 * (p[0] + p[1] + p[2] + p[3])};
}

int variations(const Bernstein& b) {
  int count = 0, last = 0;
  for (const mpz_class& c : b) {
    if (sgn(c) * last < 0) ++count;
    if (sgn(c) != 0) last = sgn(c);
  }
  return count;
}

// Sign just behind the lower end.
int sign_behind(const Bernstein& b) {
  for (const mpz_class& c : b)
    if (sgn(c) != 0) return sgn(c);
  return 0;
}

// Both halves of the interval, by de Casteljau's construction without its divisions.
std::pair<Bernstein, Bernstein> halves(const Bernstein& b) {
  const mpz_class x = b[0] + b[1], y = b[1] + b[2], z = b[2] + b[3], u = x + y, v = y + z, m = u + v;
  return {Bernstein{8 * b[0], 4 * x, 2 * u, m}, Bernstein{m, 2 * v, 4 * z, 8 * b[3]}};
}

// Narrows the interval of a simple root in the open interval (n, n+1)/2^bits, where p has sign `below` just
// behind n.
ExactRoot refine(const ExactCubic& p, mpz_class n, int bits, int below) {
  for (int step = 1; bits < kRootBits;) {
    // guess by the chord in which of 2^step parts the root lies, and ask the sign at a point next to it
    step = std::min(step, kRootBits - bits);
    const mpz_class f_lo = scaled_value(p, n, bits), f_hi = scaled_value(p, n + 1, bits), span = f_lo - f_hi;
    const mpz_class parts = mpz_class(1) << step, first = n << step, last = first + parts;
    mpz_class part = span == 0 ? mpz_class(1) : mpz_class((f_lo << step) / span);
    part = std::max(mpz_class(1), std::min(mpz_class(parts - 1), part));
    const mpz_class a = first + part;
    const int sign_a = sgn(scaled_value(p, a, bits + step));
    if (sign_a == 0) return {a, bits + step, true, 1};

    // right guess: the part's other end has the other sign; wrong: try with fewer parts
    const mpz_class b = sign_a == below ? mpz_class(a + 1) : mpz_class(a - 1);
    const int sign_b = b == first ? below : b == last ? -below : sgn(scaled_value(p, b, bits + step));
    if (sign_b == 0) return {b, bits + step, true, 1};
    if (sign_a != sign_b) {
      n = std::min(a, b);
      bits += step;
      step *= 2;
    } else {
      step = std::max(1, step / 2);
    }
  }
  return {std::move(n), bits, false, 1};
}

// Appends the roots in the open interval (n, n+1)/2^bits, all of them simple.
void isolate(const ExactCubic& p, const Bernstein& b, const mpz_class& n, int bits,
             std::vector<ExactRoot>& roots) {
  const int count = variations(b);
  if (count == 0) return;
  if (count == 1) {
    roots.push_back(refine(p, n, bits, sign_behind(b)));
    return;
  }
  const auto [left, right] = halves(b);
  const mpz_class middle = 2 * n + 1;
  isolate(p, left, 2 * n, bits + 1, roots);
  if (sgn(left[3]) == 0) roots.push_back({middle, bits + 1, true, 1});
  isolate(p, right, middle, bits + 1, roots);
}

struct RationalRoot {
  mpq_class s;
  int multiplicity;
};

// All roots of a p that has a multiple one, in order; nothing if all are simple.
std::vector<RationalRoot> rational_roots(const ExactCubic& p) {
  const mpz_class &d = p[0], &c = p[1], &b = p[2], &a = p[3];
  const auto ratio = [](const mpz_class& x, const mpz_class& y) {
    mpq_class q(x, y);
    q.canonicalize();
    return q;
  };
  if (a == 0) {
    if (b == 0 || c * c != 4 * b * d) return {};
    return {{ratio(-c, 2 * b), 2}};
  }
  if (b * b * c * c - 4 * a * c * c * c - 4 * b * b * b * d - 27 * a * a * d * d + 18 * a * b * c * d != 0)
    return {};
  const mpz_class e = b * b - 3 * a * c;
  if (e == 0) return {{ratio(-b, 3 * a), 3}};
  const RationalRoot twice{ratio(9 * a * d - b * c, 2 * e), 2},
      once{ratio(4 * a * b * c - 9 * a * a * d - b * b * b, a * e), 1};
  if (twice.s < once.s) return {twice, once};
  return {once, twice};
}

ExactRoot interval_of(const RationalRoot& root) {
  const mpz_class scaled = root.s.get_num() << kRootBits;
  return {scaled / root.s.get_den(), kRootBits, scaled % root.s.get_den() == 0, root.multiplicity};
}

}  // namespace

bool is_zero(const ExactCubic& p) {
  return std::all_of(p.begin(), p.end(), [](const mpz_class& c) { return c == 0; });
}

mpz_class scaled_value(const ExactCubic& p, const mpz_class& n, int bits) {
  return ((p[3] * n + (p[2] << bits)) * n + (p[1] << (2 * bits))) * n + (p[0] << (3 * bits));
}

std::vector<ExactRoot> roots_in_unit_interval(const ExactCubic& p) {
  std::vector<ExactRoot> roots;
  const Bernstein b = bernstein_of(p);

  // multiple roots leave at least two changes of sign, or zeros at an end
  const bool root_at_end = sgn(b[0]) == 0 || sgn(b[3]) == 0;
  if (root_at_end || variations(b) > 1) {
    const std::vector<RationalRoot> rational = rational_roots(p);
    for (const RationalRoot& root : rational)
      if (sgn(root.s) >= 0 && root.s <= 1) roots.push_back(interval_of(root));
    if (!rational.empty()) return roots;
  }

  if (sgn(b[0]) == 0) roots.push_back({0, 0, true, 1});
  isolate(p, b, 0, 0, roots);
  if (sgn(b[3]) == 0) roots.push_back({1, 0, true, 1});
  return roots;
}

}  // namespace isocast::reference
