// Random formulas of two numbers, for any kind of number that has the operations.
#pragma once

#include <math/ball.h>
#include <math/inclusion_operations.h>
#include <math/operands.h>

#include <vector>

namespace isocast::test {

/// A tape: step i makes number i + 2 of earlier ones, numbers 0 and 1 being the arguments; the last is f.
struct RandomExpression {
  struct Step {
    Inclusion operation;
    int a, b, n;
  };
  std::vector<Step> steps;

  explicit RandomExpression(bench::Random& random) {
    const int exponents[] = {0, 2, 3, 4, 7, -1, -2};
    const int length = 2 + random.below(8);
    for (int i = 0; i < length; ++i) {
      // half of the operations are the common ones: sums, products, squares
      const int common[] = {static_cast<int>(Inclusion::add), static_cast<int>(Inclusion::subtract),
                            static_cast<int>(Inclusion::multiply), static_cast<int>(Inclusion::square)};
      const int operation = random.below(2) ? common[random.below(4)] : random.below(kInclusionCount);
      const int newest = i + 1 - random.below(2);
      steps.push_back(
          {static_cast<Inclusion>(operation), newest, random.below(i + 2), exponents[random.below(7)]});
    }
  }

  /// operation(step's operation, a, b, n) in turn.
  template <class F, class Operation> F evaluate(const F& x, const F& y, Operation operation) const {
    std::vector<F> numbers = {x, y};
    for (const Step& step : steps)
      numbers.push_back(operation(step.operation, numbers[step.a], numbers[step.b], step.n));
    return numbers.back();
  }
  [[nodiscard]] Ball truth_at(const Ball& x, const Ball& y) const { return evaluate(x, y, truth); }
  template <class F> F value(const F& x, const F& y) const { return evaluate(x, y, apply<F>); }
};

/// A range as formulas meet it: half of them narrow and near the origin.
template <class T> Range<T> moderate_range(bench::Random& random) {
  if (random.below(2)) return any_range<T>(random);
  const double middle = random.uniform(-2, 2), half = std::exp2(random.uniform(-20, 0));
  return {static_cast<T>(middle - half), static_cast<T>(middle + half)};
}

}  // namespace isocast::test
