#include <fmt/format.h>
#include <isocast/apps/bench/evaluate.h>
#include <isocast/apps/bench/evaluate_kernels.h>
#include <isocast/apps/bench/random.h>
#include <isocast/apps/bench/timing.h>
#include <isocast/base/progress.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/expression/simplify.h>
#include <isocast/implicit/expression/tape.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

namespace isocast::bench {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr int kBlocks[] = {16, 64, 256};
constexpr const char* kKinds[kNumberKinds] = {"value", "interval", "affine", "gradient"};

template <class T> constexpr const char* kPrecision = sizeof(T) == sizeof(float) ? "float" : "double";

// Points of the domain, parts around them as wide as a bisection's, and room for what is found there.
template <class T> struct Points {
  std::vector<T> coordinates[3], results;
  T width;

  explicit Points(const Domain& domain) : results(2 * kEvaluatedValues) {
    for (std::size_t a = 0; a < 3; ++a)
      for (int n = 0; n < kEvaluatedValues; ++n) {
        Random random(kSeed + a, static_cast<std::uint64_t>(n));
        coordinates[a].push_back(static_cast<T>(random.uniform(domain.lo[a], domain.hi[a])));
      }
    width = static_cast<T>(0x1p-8 * (domain.hi[0] - domain.lo[0]));
  }
  Evaluation<T> evaluation(const Tape& tape, int block, int repeats) {
    assert(tape.registers <= kMostRegisters);
    return {tape.view(), {coordinates[0].data(), coordinates[1].data(), coordinates[2].data()},
            width,       block,
            repeats,     results.data()};
  }
};

struct Candidates {
  std::vector<Row> rows;
  std::vector<std::function<void()>> runs;
};

// All ways of one surface in one precision on one instruction set.
template <class T>
void add_ways(int surface, const Tape& tape, Points<T>& points, Isa isa, int repeats, Candidates& into) {
  const Evaluators<T>& evaluators = evaluate_kernels(isa).evaluators<T>();
  const auto add = [&](const std::string& method, int block, typename Evaluators<T>::Run* run) {
    Row row;
    row.suite = "evaluate";
    row.case_name = kCompiledSurfaces[surface];
    row.method = method;
    row.isa = name_of(isa);
    row.precision = kPrecision<T>;
    row.setting = fmt::format("block={}", block);
    row.proves = "nothing";
    row.rays = std::int64_t{kEvaluatedValues} * repeats;
    into.rows.push_back(row);
    into.runs.push_back([run, evaluation = points.evaluation(tape, block, repeats)] {
      const DefaultFloatEnvironment environment;
      run(evaluation);
    });
  };
  for (const int block : kBlocks) {
    for (int kind = 0; kind < kNumberKinds; ++kind) {
      add(fmt::format("{} tape", kKinds[kind]), block, evaluators.tape[kind]);
      add(fmt::format("{} compiled", kKinds[kind]), block, evaluators.compiled[surface][kind]);
    }
    add("value block", block, evaluators.block_of_points);
  }
}

}  // namespace

std::vector<Row> run_evaluate(const EvaluateSuiteOptions& options) {
  const int repeats = options.quick ? 4 : 64, repetitions = options.quick ? 5 : 21;
  std::vector<Row> rows;
  Progress progress("bench evaluate", std::int64_t{kCompiledCount} * std::ssize(options.isas));
  for (int surface = 0; surface < kCompiledCount; ++surface) {
    const CatalogueSurface& record = require_surface(kCompiledSurfaces[surface]);
    const Tape tape = make_tape(simplify(surface_expression(record)));
    Points<float> floats(record.domain);
    Points<double> doubles(record.domain);
    for (const Isa isa : options.isas) {
      Candidates candidates;
      add_ways(surface, tape, floats, isa, repeats, candidates);
      add_ways(surface, tape, doubles, isa, repeats, candidates);
      const std::vector<Timing> timings = time_interleaved(candidates.runs, repetitions, Clock::thread);
      for (std::size_t i = 0; i < timings.size(); ++i) {
        set_timing(candidates.rows[i], timings[i]);
        rows.push_back(candidates.rows[i]);
      }
      progress.add();
    }
  }
  return rows;
}

std::string evaluate_summary(const std::vector<Row>& rows) {
  const auto seconds = [&rows](const Row& like, const std::string& method) {
    const auto found = std::ranges::find_if(rows, [&](const Row& row) {
      return row.case_name == like.case_name && row.isa == like.isa && row.precision == like.precision &&
             row.setting == like.setting && row.method == method;
    });
    return found == rows.end() ? std::nan("") : found->seconds;
  };
  std::string text =
      "Time of the tape over that of compiled code (values: of the scalar block over it too)\n";
  for (const Row& row : rows) {
    if (row.method != "value tape") continue;
    text += fmt::format("{:11} {:6} {:6} {:9}", row.case_name, row.precision, row.isa, row.setting);
    for (const std::string kind : kKinds)
      text +=
          fmt::format("  {} {:.2f}", kind, seconds(row, kind + " tape") / seconds(row, kind + " compiled"));
    text += fmt::format("  block {:.2f}\n", seconds(row, "value block") / seconds(row, "value compiled"));
  }
  return text;
}

}  // namespace isocast::bench
