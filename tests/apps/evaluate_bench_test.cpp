// The suite `evaluate`: what is compared computes the same, and every row is there.
#include <isocast/apps/bench/evaluate.h>
#include <isocast/apps/bench/evaluate_kernels.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/expression/simplify.h>
#include <isocast/implicit/expression/tape.h>

#include <catch2/catch.hpp>
#include <random>

using namespace isocast;
using namespace isocast::bench;

TEMPLATE_TEST_CASE("tapes and compiled formulas have the same bits, whatever the block", "", float, double) {
  using T = TestType;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<T> coordinate(T(-1.5), T(1.5));
  std::vector<T> points[3];
  for (std::vector<T>& axis : points)
    for (int n = 0; n < kEvaluatedValues; ++n) axis.push_back(coordinate(random));
  for (int surface = 0; surface < kCompiledCount; ++surface) {
    const Tape tape = make_tape(simplify(surface_expression(require_surface(kCompiledSurfaces[surface]))));
    REQUIRE(tape.registers <= kMostRegisters);
    for (int kind = 0; kind < kNumberKinds; ++kind) {
      std::vector<T> first;
      for (const Isa isa : available_isas()) {
        const Evaluators<T>& evaluators = evaluate_kernels(isa).evaluators<T>();
        const auto check = [&](typename Evaluators<T>::Run* run, int block) {
          std::vector<T> results(2 * kEvaluatedValues);
          run({tape.view(),
               {points[0].data(), points[1].data(), points[2].data()},
               T(0.01),
               block,
               2,
               results.data()});
          if (first.empty()) first = results;
          INFO(kCompiledSurfaces[surface] << " kind " << kind << " " << name_of(isa) << " " << block);
          REQUIRE(results == first);
        };
        for (const int block : {16, 64, 256}) {
          check(evaluators.tape[kind], block);
          check(evaluators.compiled[surface][kind], block);
          if (kind == 0) check(evaluators.block_of_points, block);
        }
      }
    }
  }
}

TEST_CASE("the suite `evaluate` has a row for every way, and its ratios are numbers") {
  const std::vector<Row> rows = run_evaluate({.quick = true, .isas = {widest_isa()}});
  CHECK(rows.size() == 2 * 2 * 3 * (2 * 4 + 1));
  for (const Row& row : rows) CHECK(row.seconds > 0);
  const std::string summary = evaluate_summary(rows);
  CHECK_THAT(summary,
             Catch::Contains("tangle") && Catch::Contains("barth_decic") && Catch::Contains("block=256"));
  CHECK_THAT(summary, !Catch::Contains("nan"));
}
