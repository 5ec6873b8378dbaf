#include <isocast/apps/reference/exact_line.h>
#include <isocast/apps/reference/whole_numbers.h>

#include <cmath>
#include <limits>

namespace isocast::reference {
namespace {

double rounded(const Fraction& x, double towards) {
  mpq_class q(x.n, x.d);
  q.canonicalize();
  const double truncated = q.get_d();
  const bool beyond = towards < 0 ? truncated > q : truncated < q;
  return beyond ? std::nextafter(truncated, towards) : truncated;
}

}  // namespace

Fraction fraction(double x) {
  const WholeNumbers numbers = whole_numbers({std::span(&x, 1)});
  return {numbers.value[0], mpz_class(1) << -numbers.exponent};
}
double floor_double(const Fraction& x) { return rounded(x, -std::numeric_limits<double>::infinity()); }
double ceil_double(const Fraction& x) { return rounded(x, std::numeric_limits<double>::infinity()); }

Fraction point_of(const LineRange& range, const mpz_class& n, int bits) {
  const auto& [in, out] = range;
  const mpz_class begin = in.n * out.d, end = out.n * in.d;
  return {(begin << bits) + (end - begin) * n, (in.d * out.d) << bits};
}

ExactLine::ExactLine(const Transform& grid_from_world, const Double3& o, const Double3& d) {
  const auto& m = grid_from_world.m;
  const WholeNumbers matrix = whole_numbers({m[0], m[1], m[2]}), ray = whole_numbers({o, d});
  shift_ = -matrix.exponent - ray.exponent;
  for (std::size_t r = 0; r < 3; ++r) {
    o_[r] = matrix.value[4 * r + 3] << -ray.exponent;
    d_[r] = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      o_[r] += matrix.value[4 * r + c] * ray.value[c];
      d_[r] += matrix.value[4 * r + c] * ray.value[3 + c];
    }
  }
}

RoundedLine ExactLine::near(const Double3& center) const {
  const WholeNumbers c = whole_numbers({center});
  // t = n / squared is the nearest point's
  mpz_class n = 0, squared = 0;
  long largest = std::numeric_limits<long>::min();
  for (std::size_t a = 0; a < 3; ++a) {
    n += (((c.value[a] << shift_) >> -c.exponent) - o_[a]) * d_[a];
    squared += d_[a] * d_[a];
    long exponent;
    mpz_get_d_2exp(&exponent, d_[a].get_mpz_t());
    if (d_[a] != 0) largest = std::max(largest, exponent);
  }
  if (squared == 0) squared = 1;
  RoundedLine line;
  for (int a = 0; a < 3; ++a) {
    line.o[a] = ratio(o_[a] * squared + n * d_[a], squared, -shift_);
    line.d[a] = d_[a] == 0 ? 0 : to_double(d_[a], -largest);
  }
  return line;
}

std::optional<LineRange> ExactLine::within(const Cell& cell, const LineRange& range) const {
  LineRange part = range;
  for (int a = 0; a < 3; ++a) {
    const mpz_class low = (mpz_class(cell[a]) << shift_) - o_[a], high = low + (mpz_class(1) << shift_);
    const int side = sgn(d_[a]);
    if (side == 0) {
      if (low > 0 || high < 0) return std::nullopt;
      continue;
    }
    Fraction in = side > 0 ? Fraction{low, d_[a]} : Fraction{-high, -d_[a]},
             out = side > 0 ? Fraction{high, d_[a]} : Fraction{-low, -d_[a]};
    if (part.in < in) part.in = std::move(in);
    if (out < part.out) part.out = std::move(out);
  }
  if (!(part.in < part.out)) return std::nullopt;
  return part;
}

ExactChord ExactLine::chord(const Cell& cell, const LineRange& range) const {
  const auto& [in, out] = range;
  ExactChord chord;
  chord.one = (in.d * out.d) << shift_;
  for (int a = 0; a < 3; ++a) {
    const mpz_class start = o_[a] - (mpz_class(cell[a]) << shift_);
    chord.entry[a] = (start * in.d + d_[a] * in.n) * out.d;
    chord.exit[a] = (start * out.d + d_[a] * out.n) * in.d;
  }
  return chord;
}

}  // namespace isocast::reference
