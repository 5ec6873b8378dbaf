#include <isocast/implicit/frustum/rounding_bound.h>
#include <isocast/implicit/solve/inclusion.h>

#include <cmath>
#include <vector>

namespace isocast {
namespace {

using Range = Interval<double>;

// What a register may hold, and how far it may be from what it should.
struct Rounded {
  Range range;
  double error = 0;
};

double size_of(const Range& a) { return std::max(std::abs(a.lo), std::abs(a.hi)); }

// A little more than the sums below round.
constexpr double kUnit = 0x1.01p-53;

Rounded rounded(const Range& range, double error) {
  return {range, error + kUnit * (size_of(range) + error)};
}

// What becomes of a number that no point decides.
Rounded exact_to_width(const Range& range) {
  return {range, (range.hi - range.lo) + 4 * kUnit * size_of(range)};
}

// |T_n'| over a range: n U_(n-1), at most n^2 inside [-1, 1].
double chebyshev_slope(const Range& a, int n) {
  const double x = size_of(a);
  if (x <= 1) return double(n) * n;
  const double growth = x + std::sqrt(x * x - 1);
  return 1.001 * double(n) * n * std::pow(growth, n - 1);
}

// Runs the tape on Rounded: the operations that polynomials have, and any on numbers.
class Run {
 public:
  Run(const Tape& tape, const Box& box, double time, double slack)
      : tape_(tape), box_(box), time_(time), slack_(slack), registers_(tape.registers) {}

  double error() {
    run_tape<Run&>(tape_.view(), *this);
    const double error = registers_[tape_.result].error;
    return error < Box::inf ? error : Box::inf;
  }

  void constant(const Instruction& i) {
    registers_[i.out] = rounded(constant_as(tape_.constants[i.a], Range{}), 0);
  }
  void variable(const Instruction& i) {
    if (i.a == 3) registers_[i.out] = {Range(time_, time_), 0};
    else registers_[i.out] = {Range(box_.lo[i.a], box_.hi[i.a]), slack_};
  }
  template <class F> void unary(const Instruction& i, F f) {
    const Rounded& a = registers_[i.a];
    Rounded y = exact_to_width(f(a.range));
    if (i.op == Op::negate) y = {y.range, a.error};
    if (i.op == Op::square) y = rounded(y.range, (2 * size_of(a.range) + a.error) * a.error);
    if (i.op == Op::power) y = powered(a, i.n, y.range);
    registers_[i.out] = y;
  }
  template <class F> void whole(const Instruction& i, F f) {
    const Rounded& a = registers_[i.a];
    const Range range = f(a.range, i.n);
    if (i.op == Op::power) registers_[i.out] = powered(a, i.n, range);
    else {
      const double size = std::max(1.0, size_of(range));
      registers_[i.out] = {range, chebyshev_slope(a.range, i.n) * a.error + 4 * i.n * kUnit * size};
    }
  }
  template <class F> void binary(const Instruction& i, F f) {
    const Rounded &a = registers_[i.a], &b = registers_[i.b];
    const Range range = f(a.range, b.range);
    const double sa = size_of(a.range), sb = size_of(b.range);
    Rounded y = exact_to_width(range);
    if (i.op == Op::add || i.op == Op::subtract) y = rounded(range, a.error + b.error);
    if (i.op == Op::multiply) y = rounded(range, sa * b.error + sb * a.error + a.error * b.error);
    if (i.op == Op::divide) {
      const double least = std::min(std::abs(b.range.lo), std::abs(b.range.hi)) - b.error;
      y = rounded(range, least > 0 ? (a.error + size_of(range) * b.error) / least : Box::inf);
    }
    registers_[i.out] = y;
  }
  template <class F> void ternary(const Instruction& i, F f) {
    registers_[i.out] =
        exact_to_width(f(registers_[i.a].range, registers_[i.b].range, registers_[i.c].range));
  }

 private:
  // By repeated products, of which there are no more than n.
  static Rounded powered(const Rounded& a, int n, const Range& range) {
    if (n < 0) return exact_to_width(range);
    const double size = size_of(a.range) + a.error;
    return rounded(range, n * std::pow(size, n - 1) * a.error + n * kUnit * std::pow(size, n));
  }

  const Tape& tape_;
  const Box& box_;
  double time_, slack_;
  std::vector<Rounded> registers_;
};

}  // namespace

double rounding_bound(const Tape& tape, const Box& box, double time, double slack) {
  return Run(tape, box, time, slack).error();
}

}  // namespace isocast
