// A tape without what it does not need inside a box.
#pragma once

#include <isocast/implicit/expression/registers.h>
#include <isocast/implicit/expression/tape.h>
#include <isocast/math/interval.h>

#include <span>

namespace isocast {

/// What is known of the value of one instruction over the box.
///
/// made      its operands are places in the list of values, not registers
/// constant  the number, where made.op is `constant`
/// range     if `sure`, all that is computed or true: finite and never NaN
/// same      the place of the earlier value that stands for this one, else its own
/// lo, hi    its readers only ask on which side of numbers from lo to hi it lies: all numbers, if they ask
///           for the value itself; lo > hi without readers
/// last      place of its last reader
/// held      its register in the pruned tape
template <class T> struct PrunedValue {
  Instruction made;
  TapeConstant constant;
  Interval<T> range;
  bool sure;
  T lo, hi;
  std::uint32_t same, last, held;
};

/// Prunes tapes, in time linear in their length; keeps its memory from call to call. T: float, whose ranges
/// hold for both precisions, or double, narrower, for tapes that are run in double only.
///
/// source  M. J. Keeter: Massively parallel rendering of complex closed-form implicit surfaces, ACM
/// Transactions
///         on Graphics 39(4), 2020; T. Duff: Interval arithmetic and recursive subdivision for implicit
///         functions and constructive solid geometry, SIGGRAPH 1992
template <class T> class Pruner {
 public:
  /// The tape with each min, max, abs, sign, step and choose that is decided all over the box replaced by
  /// what it is there; order and registers (as many or fewer) as make_tape's. Nothing is decided where an
  /// operand may be undefined, NaN or infinite.
  ///
  /// box      x, y and z, all of them over which the pruned tape is run; `time` is w
  /// levels   none: wherever in the box, values have the bits of the whole tape's, and inclusions hold the
  ///          true values. Else only f < level, f = level and f > level are those of the whole tape, for
  ///          each level: a union's part above all levels is left out, and what lies below them stands alone
  /// returns  good until the next call
  [[nodiscard]] const Tape& prune(const Tape& tape, const Interval<double> (&box)[3], double time,
                                  std::span<const double> levels = {});

 private:
  void inspect(const Tape& tape, const Interval<double> (&box)[3], double time);
  void ask_for(std::uint32_t result, std::span<const double> levels);
  void lay_out(std::uint32_t result);

  std::vector<PrunedValue<T>> values_;
  std::vector<std::uint32_t> writers_;  // the value that each register of the whole tape holds
  Registers registers_;
  Tape pruned_;
};

}  // namespace isocast
