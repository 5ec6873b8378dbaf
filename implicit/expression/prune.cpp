#include <isocast/implicit/expression/evaluate.h>
#include <isocast/implicit/expression/prune.h>
#include <isocast/math/interval_angles.h>
#include <isocast/math/interval_powers.h>
#include <isocast/math/interval_steps.h>

#include <algorithm>
#include <cmath>

namespace isocast {
namespace {

template <class T> bool is_sure(const Interval<T>& a) {
  return a.defined && !a.empty && a.lo >= -kLargest<T> && a.hi <= kLargest<T>;
}

// The smallest T-interval around a.
template <class T> Interval<T> rounded(const Interval<double>& a) {
  Interval<T> y(enclosed<T>(a.lo, true).lo, enclosed<T>(a.hi, true).hi);
  y.defined = y.defined && a.defined;
  y.empty = a.empty;
  return y;
}

// Numbers that stay the same bits in every precision under operations that round correctly.
bool is_small_integer(double a) { return std::abs(a) <= 1024 && a == std::floor(a); }
bool rounds_correctly(Op op) {
  return op < Op::power || op == Op::sqrt || (op >= Op::floor && op <= Op::max) || op >= Op::step;
}

// Ranges hold what is computed by operations that rise and fall with their operands and round correctly, as
// their ends are found in the same way. The others may be off by their errors, at the place and at the ends.
template <class T> Interval<T> with_errors(const Instruction& i, const Interval<T>& a) {
  if (rounds_correctly(i.op) || i.op == Op::power) return a;
  T lo = std::abs(a.lo), hi = std::abs(a.hi), errors = 4 * kSpacing<T>;
  if (i.op == Op::chebyshev) {
    lo = hi = std::max({lo, hi, T(1)});
    errors *= T(i.n + 1);
  }
  return decorated_as(a, a.lo - errors * lo, a.hi + errors * hi);
}

// Runs a tape over a box and decides its choices.
template <class T> struct Inspection {
  using Value = PrunedValue<T>;

  const TapeConstant* constants;
  const Interval<T> (&inputs)[4];
  std::uint32_t* writers;
  Value* values;
  std::uint32_t& count;

  std::uint32_t place(std::uint32_t reg) const { return values[writers[reg]].same; }
  const Value& at(std::uint32_t reg) const { return values[place(reg)]; }
  static bool known(const Value& a) {
    return a.made.op == Op::constant && a.constant.exact && is_small_integer(a.constant.value);
  }

  // Field by field and in place: to copy what was written in parts just before stalls.
  [[gnu::always_inline]] Value& add(const Instruction& i, const Interval<T>& range, bool sure) {
    Value& v = values[count];
    v.made = i;
    v.range.lo = range.lo, v.range.hi = range.hi;
    v.range.defined = range.defined, v.range.continuous = range.continuous, v.range.empty = range.empty;
    v.sure = sure && is_sure(range);
    v.lo = kInfinity<T>, v.hi = -kInfinity<T>;
    v.same = count;
    v.last = v.held = 0;
    writers[i.out] = count++;
    return v;
  }
  [[gnu::always_inline]] void add_operation(const Instruction& i, const Interval<T>& range, bool sure) {
    const int operands = operand_count(i.op);
    std::uint32_t operand[3] = {i.a, i.b, i.c};
    for (int k = 0; k < operands; ++k) operand[k] = place(operand[k]);
    Instruction& made = add(i, with_errors(i, range), sure).made;
    made.a = operand[0], made.b = operand[1], made.c = operand[2];
  }
  void add_number(const Instruction& i, double number) {
    Value& v = add({Op::constant, i.out, 0, 0, 0, 0}, Interval<T>(T(number)), true);
    v.constant = {number, true};
  }
  void add_same(const Instruction& i, std::uint32_t reg) { writers[i.out] = place(reg); }

  // A result that is known and the same in every precision.
  bool folds(const Instruction& i, double number) {
    if (!rounds_correctly(i.op) || !is_small_integer(number)) return false;
    add_number(i, number);
    return true;
  }

  void constant(const Instruction& i) {
    const TapeConstant c = constants[i.a];
    add(i, enclosed<T>(c.value, c.exact), true).constant = c;
  }
  void variable(const Instruction& i) { add(i, inputs[i.a], true); }

  template <class F> void unary(const Instruction& i, F f) {
    const Value& a = at(i.a);
    if (known(a) && folds(i, f(a.constant.value))) return;
    const bool positive = a.sure && a.range.lo > 0, negative = a.sure && a.range.hi < 0;
    if (i.op == Op::abs && positive) add_same(i, i.a);
    else if (i.op == Op::abs && negative) add_operation({Op::negate, i.out, i.a, 0, 0, 0}, -a.range, true);
    else if (i.op == Op::sign && (positive || negative)) add_number(i, positive ? 1 : -1);
    else add_operation(i, f(a.range), a.sure);
  }
  template <class F> void whole(const Instruction& i, F f) {
    const Value& a = at(i.a);
    add_operation(i, f(a.range, i.n), a.sure);
  }
  template <class F> void binary(const Instruction& i, F f) {
    const Value &a = at(i.a), &b = at(i.b);
    if (known(a) && known(b) && folds(i, f(a.constant.value, b.constant.value))) return;
    bool sure = a.sure && b.sure;
    const bool less = sure && a.range.hi < b.range.lo, more = sure && a.range.lo > b.range.hi;
    if (less || more) {
      if (i.op == Op::min) return add_same(i, less ? i.a : i.b);
      if (i.op == Op::max) return add_same(i, more ? i.a : i.b);
      if (i.op == Op::step) return add_number(i, less ? 1 : 0);
    }
    // the angle at a computed -0 lies on the other side of the cut
    if (i.op == Op::atan2 && holds_zero(a.range)) sure = false;
    add_operation(i, f(a.range, b.range), sure);
  }
  template <class F> void ternary(const Instruction& i, F f) {
    const Value &c = at(i.a), &a = at(i.b), &b = at(i.c);
    if (c.sure && (c.range.lo > 0 || c.range.hi < 0)) add_same(i, i.b);
    else if (c.sure && c.range.lo == 0 && c.range.hi == 0) add_same(i, i.c);
    else add_operation(i, f(c.range, a.range, b.range), c.sure && a.sure && b.sure);
  }
};

// The operand that alone has the sides of min(a, b) or max(a, b), or neither.
template <class T>
const std::uint32_t* decisive(const PrunedValue<T>& v, const PrunedValue<T>& a, const PrunedValue<T>& b) {
  if (!a.sure || !b.sure) return nullptr;
  const auto above = [&v](const PrunedValue<T>& x) { return x.range.lo > v.hi; };
  const auto below = [&v](const PrunedValue<T>& x) { return x.range.hi < v.lo; };
  const bool least = v.made.op == Op::min;
  if (least ? above(b) || below(a) : below(b) || above(a)) return &v.made.a;
  if (least ? above(a) || below(b) : below(a) || above(b)) return &v.made.b;
  return nullptr;
}

}  // namespace

template <class T> void Pruner<T>::inspect(const Tape& tape, const Interval<double> (&box)[3], double time) {
  const Interval<T> inputs[4] = {rounded<T>(box[0]), rounded<T>(box[1]), rounded<T>(box[2]),
                                 enclosed<T>(time, true)};
  values_.resize(tape.code.size());
  writers_.resize(tape.registers);
  std::uint32_t count = 0;
  run_tape(tape.view(), Inspection<T>{tape.constants.data(), inputs, writers_.data(), values_.data(), count});
  values_.resize(count);
}

template <class T> void Pruner<T>::ask_for(std::uint32_t result, std::span<const double> levels) {
  constexpr T all = kInfinity<T>;
  T lo = all, hi = -all;
  for (const double level : levels) {
    const Interval<T> exact = enclosed<T>(level, true);
    lo = std::min(lo, exact.lo), hi = std::max(hi, exact.hi);
  }
  if (levels.empty()) lo = -all, hi = all;

  const auto ask = [this](std::uint32_t place, T from, T to, std::uint32_t reader) {
    PrunedValue<T>& v = values_[place];
    v.lo = std::min(v.lo, from), v.hi = std::max(v.hi, to);
    v.last = std::max(v.last, reader);
  };
  ask(result, lo, hi, static_cast<std::uint32_t>(values_.size()));
  for (std::uint32_t k = result + 1; k-- > 0;) {
    PrunedValue<T>& v = values_[k];
    const Instruction& made = v.made;
    const int operands = operand_count(made.op);
    if (v.lo > v.hi || operands == 0) continue;
    const bool least_or_most = made.op == Op::min || made.op == Op::max;
    if (least_or_most)
      if (const std::uint32_t* const one = decisive(v, values_[made.a], values_[made.b])) {
        v.same = *one;
        ask(v.same, v.lo, v.hi, v.last);
        continue;
      }
    // the sides of these follow from those of their operands
    const bool chooses = made.op == Op::choose, passes = least_or_most || made.op == Op::negate;
    const T a_lo = made.op == Op::negate ? -v.hi : v.lo, a_hi = made.op == Op::negate ? -v.lo : v.hi;
    ask(made.a, passes ? a_lo : -all, passes ? a_hi : all, k);
    if (operands >= 2) ask(made.b, passes || chooses ? v.lo : -all, passes || chooses ? v.hi : all, k);
    if (operands >= 3) ask(made.c, v.lo, v.hi, k);
  }
}

template <class T> void Pruner<T>::lay_out(std::uint32_t result) {
  pruned_.code.clear();
  pruned_.constants.clear();
  registers_.clear();
  for (std::uint32_t k = 0; k <= result; ++k) {
    PrunedValue<T>& v = values_[k];
    if (v.lo > v.hi) continue;
    v.same = values_[v.same].same;
    if (v.same != k) continue;

    // registers of operands are free for the result when this is their last reader
    Instruction i = v.made;
    const int operands = operand_count(i.op);
    const auto replace = [&](std::uint32_t& operand) { operand = values_[values_[operand].same].held; };
    const auto release = [&](std::uint32_t operand) {
      PrunedValue<T>& read = values_[values_[operand].same];
      if (read.last != k) return;
      registers_.give_back(read.held);
      read.last = 0;
    };
    if (operands >= 1) replace(i.a), release(v.made.a);
    if (operands >= 2) replace(i.b), release(v.made.b);
    if (operands >= 3) replace(i.c), release(v.made.c);
    if (i.op == Op::constant) {
      i.a = static_cast<std::uint32_t>(pruned_.constants.size());
      pruned_.constants.push_back(v.constant);
    }
    i.out = v.held = registers_.take();
    pruned_.code.push_back(i);
  }
  pruned_.registers = registers_.count();
  pruned_.result = values_[values_[result].same].held;
}

template <class T>
const Tape& Pruner<T>::prune(const Tape& tape, const Interval<double> (&box)[3], double time,
                             std::span<const double> levels) {
  inspect(tape, box, time);
  const std::uint32_t result = values_[writers_[tape.result]].same;
  ask_for(result, levels);
  lay_out(result);
  return pruned_;
}

template class Pruner<float>;
template class Pruner<double>;

}  // namespace isocast
