// The suite `evaluate`: what running a tape costs against the same formula compiled.
#pragma once

#include <isocast/apps/bench/rows.h>
#include <isocast/isa/cpu.h>

#include <string>
#include <vector>

namespace isocast::bench {

/// quick: fewer repetitions. isas: which are timed.
struct EvaluateSuiteOptions {
  bool quick = false;
  std::vector<Isa> isas = available_isas();
};

/// A row for each surface, kind of number (value, interval, affine, gradient), way ("tape", "compiled", and
/// "block" for values on scalars in loops), block size, precision and instruction set. Of a row, `method` is
/// kind and way, `setting` the block; `rays` counts values, and errors are none. Seconds are the processor
/// time of one thread.
[[nodiscard]] std::vector<Row> run_evaluate(const EvaluateSuiteOptions& options);

/// Times of tapes over times of compiled formulas, as a table to read; of all rows of run_evaluate.
[[nodiscard]] std::string evaluate_summary(const std::vector<Row>& rows);

}  // namespace isocast::bench
