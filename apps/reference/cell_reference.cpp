#include <isocast/apps/reference/cell_reference.h>
#include <isocast/apps/reference/exact_cubic.h>
#include <isocast/base/interrupt.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace isocast::reference {
namespace {

// Doubles as integers times one power of two, which is at most 1.
struct Integers {
  std::vector<mpz_class> value;
  int exponent = 0;
};

Integers integers_of(std::initializer_list<std::span<const double>> lists) {
  // the unit in the last place of x, as an exponent
  const auto unit = [](double x) { return x == 0 ? 0 : std::max(std::ilogb(x), -1022) - 52; };
  Integers result;
  for (const auto& list : lists)
    for (const double x : list) result.exponent = std::min(result.exponent, unit(x));
  for (const auto& list : lists)
    for (const double x : list)
      result.value.push_back(mpz_class(std::ldexp(x, -unit(x))) << (unit(x) - result.exponent));
  return result;
}

double to_double(const mpz_class& value, long exponent) {
  long own;
  const double mantissa = mpz_get_d_2exp(&own, value.get_mpz_t());
  return std::ldexp(mantissa, static_cast<int>(own + exponent));
}

long double to_long_double(const ExactRoot& root) {
  // at most 63 bits, so that the half fits too
  const int dropped = std::max(0, root.bits - kRootBits);
  const mpz_class kept = root.numerator >> dropped;
  const long double n = static_cast<long double>(mpz_get_ui(kept.get_mpz_t()));
  return std::ldexp(root.exact && dropped == 0 ? n : n + 0.5L, dropped - root.bits);
}

// f along the chord: Bernstein coefficients times (1, 3, 3, 1), and powers of s, as integers times
// 2^exponent.
struct ChordCubic {
  ExactCubic bernstein, power;
  long exponent;
};

ChordCubic cubic_along(const CellChord& chord) {
  const Integers f = integers_of({chord.f});
  const Integers points = integers_of({chord.entry, chord.exit});
  const mpz_class one = mpz_class(1) << -points.exponent;
  const auto lerp = [&](const mpz_class& a, const mpz_class& b, const mpz_class& t) {
    return mpz_class(a * (one - t) + b * t);
  };

  // the field is affine in each coordinate: f at (x of P or Q, y of P or Q, z of P or Q), index by bits, x
  // lowest
  mpz_class blossom[8];
  for (int x = 0; x < 2; ++x) {
    mpz_class edges[4];
    for (int e = 0; e < 4; ++e) edges[e] = lerp(f.value[2 * e], f.value[2 * e + 1], points.value[3 * x]);
    for (int y = 0; y < 2; ++y) {
      const mpz_class near = lerp(edges[0], edges[1], points.value[3 * y + 1]);
      const mpz_class far = lerp(edges[2], edges[3], points.value[3 * y + 1]);
      for (int z = 0; z < 2; ++z) blossom[x + 2 * y + 4 * z] = lerp(near, far, points.value[3 * z + 2]);
    }
  }
  const ExactCubic b = {blossom[0], blossom[1] + blossom[2] + blossom[4],
                        blossom[3] + blossom[5] + blossom[6], blossom[7]};
  return {b,
          {b[0], b[1] - 3 * b[0], 3 * b[0] - 2 * b[1] + b[2], b[3] - b[2] + b[1] - b[0]},
          long(f.exponent) + 3 * long(points.exponent)};
}

bool is_zero(const ExactCubic& p) {
  return std::all_of(p.begin(), p.end(), [](const mpz_class& c) { return c == 0; });
}

double value_at(const ChordCubic& cubic, const ExactRoot& s) {
  return to_double(scaled_value(cubic.power, s.numerator, s.bits), cubic.exponent - 3 * long(s.bits));
}

// Walks over the roots with the sign of f, which turns at odd ones.
void list_roots(const ExactCubic& p, CellReference& reference) {
  int sign = 0;
  for (int i = 0; sign == 0; ++i) sign = sgn(p[i]);
  for (const ExactRoot& exact : roots_in_unit_interval(p)) {
    CellRoot& root = reference.roots[reference.root_count++];
    root.s = to_long_double(exact);
    root.multiplicity = exact.multiplicity;
    const bool at_entry = exact.exact && exact.numerator == 0,
               at_exit = exact.exact && exact.numerator == mpz_class(1) << exact.bits;
    const bool negative_before = !at_entry && sign < 0;
    if (!at_entry && exact.multiplicity % 2 == 1) sign = -sign;
    root.negative_behind = !at_exit && sign < 0;
    root.crossing = negative_before != root.negative_behind;
  }
}

void list_critical_points(const ChordCubic& cubic, CellReference& reference) {
  const auto add = [&](const ExactRoot& s) {
    reference.critical[reference.critical_count++] = {static_cast<double>(to_long_double(s)),
                                                      value_at(cubic, s)};
  };
  const ExactRoot entry{0, 0, true, 1}, exit{1, 0, true, 1};
  const ExactCubic& p = cubic.power;
  const ExactCubic derivative = {p[1], 2 * p[2], 3 * p[3], 0};
  add(entry);
  if (!is_zero(derivative))
    for (const ExactRoot& s : roots_in_unit_interval(derivative))
      if (s.multiplicity == 1 && !(s.exact && (s.numerator == 0 || s.numerator == mpz_class(1) << s.bits)))
        add(s);
  add(exit);
}

}  // namespace

CellReference solve(const CellChord& chord) {
  const ChordCubic cubic = cubic_along(chord);
  CellReference reference{};
  reference.zero = is_zero(cubic.power);
  for (int i = 0; i < 4; ++i) {
    const double weight = i == 1 || i == 2 ? 3 : 1;
    reference.coefficients[i] = to_double(cubic.bernstein[i], cubic.exponent) / weight;
  }
  if (!reference.zero) list_roots(cubic.power, reference);
  list_critical_points(cubic, reference);
  return reference;
}

std::vector<CellReference> solve(std::span<const CellChord> chords) {
  std::vector<CellReference> references(chords.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chords.size(), 1024), [&](const auto& range) {
    throw_if_interrupted();
    for (std::size_t i = range.begin(); i < range.end(); ++i) references[i] = solve(chords[i]);
  });
  return references;
}

std::optional<CellRoot> first_crossing(const CellReference& reference, double begin) {
  for (int i = 0; i < reference.root_count; ++i) {
    const CellRoot& root = reference.roots[i];
    if (root.crossing && (root.s > begin || begin == 0)) return root;
  }
  return std::nullopt;
}

double exact_value(const CellChord& chord, double s) {
  const Integers at = integers_of({std::span(&s, 1)});
  return value_at(cubic_along(chord), {at.value[0], -at.exponent, true, 1});
}

}  // namespace isocast::reference
