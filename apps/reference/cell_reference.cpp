#include <isocast/apps/reference/cell_reference.h>
#include <isocast/apps/reference/chord_cubic.h>
#include <isocast/apps/reference/whole_numbers.h>
#include <isocast/base/interrupt.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace isocast::reference {
namespace {

long double to_long_double(const ExactRoot& root) {
  // at most 63 bits, so that the half fits too
  const int dropped = std::max(0, root.bits - kRootBits);
  const mpz_class kept = root.numerator >> dropped;
  const long double n = static_cast<long double>(mpz_get_ui(kept.get_mpz_t()));
  return std::ldexp(root.exact && dropped == 0 ? n : n + 0.5L, dropped - root.bits);
}

// f along the chord, times 2^exponent.
struct ScaledCubic {
  ChordCubic cubic;
  long exponent;
};

ScaledCubic scaled_cubic(const CellChord& chord) {
  const WholeNumbers f = whole_numbers({chord.f});
  const WholeNumbers points = whole_numbers({chord.entry, chord.exit});
  ExactChord exact;
  std::copy(f.value.begin(), f.value.end(), exact.f);
  std::copy_n(points.value.begin(), 3, exact.entry);
  std::copy_n(points.value.begin() + 3, 3, exact.exit);
  exact.one = mpz_class(1) << -points.exponent;
  return {cubic_along(exact), long(f.exponent) + 3 * long(points.exponent)};
}

double value_at(const ScaledCubic& scaled, const ExactRoot& s) {
  return to_double(scaled_value(scaled.cubic.power, s.numerator, s.bits), scaled.exponent - 3 * long(s.bits));
}

void list_roots(const ExactCubic& p, CellReference& reference) {
  for (const SidedRoot& root : sided_roots(p))
    reference.roots[reference.root_count++] = {to_long_double(root.s), root.s.multiplicity,
                                               root.negative_before != root.negative_behind,
                                               root.negative_behind};
}

void list_critical_points(const ScaledCubic& scaled, CellReference& reference) {
  const auto add = [&](const ExactRoot& s) {
    reference.critical[reference.critical_count++] = {static_cast<double>(to_long_double(s)),
                                                      value_at(scaled, s)};
  };
  const ExactRoot entry{0, 0, true, 1}, exit{1, 0, true, 1};
  const ExactCubic& p = scaled.cubic.power;
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
  const ScaledCubic scaled = scaled_cubic(chord);
  const ChordCubic& cubic = scaled.cubic;
  CellReference reference{};
  reference.zero = is_zero(cubic.power);
  for (int i = 0; i < 4; ++i) {
    const double weight = i == 1 || i == 2 ? 3 : 1;
    reference.coefficients[i] = to_double(cubic.bernstein[i], scaled.exponent) / weight;
  }
  if (!reference.zero) list_roots(cubic.power, reference);
  list_critical_points(scaled, reference);
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
  const WholeNumbers at = whole_numbers({std::span(&s, 1)});
  return value_at(scaled_cubic(chord), {at.value[0], -at.exponent, true, 1});
}

}  // namespace isocast::reference
