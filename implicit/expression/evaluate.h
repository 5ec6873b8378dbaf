// Runs a tape: on one R (a number, several lanes, later an interval), or on a block of points.
#pragma once

#include <isocast/implicit/expression/instruction.h>
#include <isocast/implicit/expression/operations.h>

namespace isocast::inline ISO_ISA {

/// A constant of a tape as an R. Kinds of R that enclose have their own, which widens what is not exact.
template <Real R> inline R constant_as(TapeConstant constant, R) {
  return R(static_cast<Scalar<R>>(constant.value));
}

/// f, which is worth inlining with all that it calls: a sum or product of inclusions is many times as fast as
/// a function that takes and returns them in memory.
template <class F> struct Inlined : F {};
template <class F> Inlined<F> inlined(F f) { return {f}; }
template <class F> inline constexpr bool kInlined = false;
template <class F> inline constexpr bool kInlined<Inlined<F>> = true;

/// Calls of `run`, for each instruction i in order, that one which fits: run.constant(i), run.variable(i),
/// run.unary(i, f), run.binary(i, f), run.ternary(i, f) or run.whole(i, f), where f takes i.n beside the
/// operand. The only place that knows what the operations mean.
template <class Run> inline void run_tape(const TapeView& tape, Run run) {
  for (const Instruction *at = tape.code, *end = tape.code + tape.length; at != end; ++at) {
    const Instruction& i = *at;
    switch (i.op) {
      case Op::constant: run.constant(i); break;
      case Op::variable: run.variable(i); break;
      case Op::negate: run.unary(i, inlined([](const auto& a) { return -a; })); break;
      case Op::abs: run.unary(i, [](const auto& a) { return abs(a); }); break;
      case Op::sign: run.unary(i, [](const auto& a) { return sign(a); }); break;
      case Op::square: run.unary(i, inlined([](const auto& a) { return square(a); })); break;
      case Op::power:
        if (i.n == 3) run.unary(i, inlined([](const auto& a) { return power(a, 3); }));
        else if (i.n == 4) run.unary(i, inlined([](const auto& a) { return power(a, 4); }));
        else run.whole(i, [](const auto& a, int n) { return power(a, n); });
        break;
      case Op::chebyshev: run.whole(i, [](const auto& a, int n) { return chebyshev(a, n); }); break;
      case Op::sqrt: run.unary(i, [](const auto& a) { return sqrt(a); }); break;
      case Op::cbrt: run.unary(i, [](const auto& a) { return cbrt(a); }); break;
      case Op::exp: run.unary(i, [](const auto& a) { return exp(a); }); break;
      case Op::log: run.unary(i, [](const auto& a) { return log(a); }); break;
      case Op::log10: run.unary(i, [](const auto& a) { return log10(a); }); break;
      case Op::sin: run.unary(i, [](const auto& a) { return sin(a); }); break;
      case Op::cos: run.unary(i, [](const auto& a) { return cos(a); }); break;
      case Op::tan: run.unary(i, [](const auto& a) { return tan(a); }); break;
      case Op::asin: run.unary(i, [](const auto& a) { return asin(a); }); break;
      case Op::acos: run.unary(i, [](const auto& a) { return acos(a); }); break;
      case Op::atan: run.unary(i, [](const auto& a) { return atan(a); }); break;
      case Op::sinh: run.unary(i, [](const auto& a) { return sinh(a); }); break;
      case Op::cosh: run.unary(i, [](const auto& a) { return cosh(a); }); break;
      case Op::tanh: run.unary(i, [](const auto& a) { return tanh(a); }); break;
      case Op::floor: run.unary(i, [](const auto& a) { return floor(a); }); break;
      case Op::ceil: run.unary(i, [](const auto& a) { return ceil(a); }); break;
      case Op::round: run.unary(i, [](const auto& a) { return round(a); }); break;
      case Op::add: run.binary(i, inlined([](const auto& a, const auto& b) { return a + b; })); break;
      case Op::subtract: run.binary(i, inlined([](const auto& a, const auto& b) { return a - b; })); break;
      case Op::multiply: run.binary(i, inlined([](const auto& a, const auto& b) { return a * b; })); break;
      case Op::divide: run.binary(i, [](const auto& a, const auto& b) { return a / b; }); break;
      case Op::min: run.binary(i, [](const auto& a, const auto& b) { return min(a, b); }); break;
      case Op::max: run.binary(i, [](const auto& a, const auto& b) { return max(a, b); }); break;
      case Op::pow: run.binary(i, [](const auto& a, const auto& b) { return pow(a, b); }); break;
      case Op::atan2: run.binary(i, [](const auto& a, const auto& b) { return atan2(a, b); }); break;
      case Op::step: run.binary(i, [](const auto& a, const auto& b) { return step(a, b); }); break;
      case Op::choose:
        run.ternary(i, [](const auto& a, const auto& b, const auto& c) { return choose(a, b, c); });
        break;
    }
  }
}

/// `count` <= kStride of R at a time: an operation on all before the next one.
template <class R, int kStride> struct RunSome {
  const TapeConstant* constants;
  const R* inputs;
  R* registers;
  int count;
  template <class F> void each(const Instruction& i, F f) {
    R* const out = registers + std::size_t{i.out} * kStride;
    if constexpr (Real<R>) {
#pragma GCC unroll 4
      for (int k = 0; k < count; ++k) out[k] = f(k);
    } else
      for (int k = 0; k < count; ++k) out[k] = f(k);
  }
  template <class F> [[gnu::flatten]] void each_inlined(const Instruction& i, F f) { each(i, f); }
  /// The same of g, an operation F on its operands.
  template <class F, class G> void each_of(const Instruction& i, G g) {
    if constexpr (kInlined<F>) each_inlined(i, g);
    else each(i, g);
  }
  const R* at(std::uint32_t index) const { return registers + std::size_t{index} * kStride; }
  void constant(const Instruction& i) {
    each(i, [value = constant_as(constants[i.a], R{})](int) { return value; });
  }
  void variable(const Instruction& i) {
    each(i, [in = inputs + i.a * kStride](int k) { return in[k]; });
  }
  template <class F> void unary(const Instruction& i, F f) {
    each_of<F>(i, [f, a = at(i.a)](int k) { return f(a[k]); });
  }
  template <class F> void binary(const Instruction& i, F f) {
    each_of<F>(i, [f, a = at(i.a), b = at(i.b)](int k) { return f(a[k], b[k]); });
  }
  template <class F> void ternary(const Instruction& i, F f) {
    each(i, [f, a = at(i.a), b = at(i.b), c = at(i.c)](int k) { return f(a[k], b[k], c[k]); });
  }
  template <class F> void whole(const Instruction& i, F f) {
    each(i, [f, n = i.n, a = at(i.a)](int k) { return f(a[k], n); });
  }
};

/// f at `count` <= kStride points, inclusions or lanes of them: inputs[v * kStride + k] is variable v (0..3
/// for x y z w) of the k-th. `registers` has room for Tape::registers * kStride; the values are `count` of
/// them from the returned one.
template <int kStride, class R>
inline const R* evaluate_some(const TapeView& tape, const R* inputs, R* registers, int count) {
  RunSome<R, kStride> run{tape.constants, inputs, registers, count};
  run_tape(tape, run);
  return run.at(tape.result);
}

/// f at inputs[0..3] = x, y, z, w. `registers` has room for Tape::registers and is left with garbage.
template <class R> inline R evaluate(const TapeView& tape, const R* inputs, R* registers) {
  return *evaluate_some<1>(tape, inputs, registers, 1);
}

/// Points that a block holds; a register of a block is so many numbers.
inline constexpr int kBlockPoints = 128;

/// One instruction at a time over many points, in loops that the compiler vectorises.
template <ScalarReal T> struct RunBlock {
  const TapeConstant* constants;
  const T* const* inputs;
  int count;
  T* registers;

  T* place(std::uint32_t index) { return registers + std::size_t{index} * kBlockPoints; }
  template <class F> void fill(const Instruction& i, F value) {
    T* const out = place(i.out);
#pragma GCC ivdep
    for (int k = 0; k < count; ++k) out[k] = value(k);
  }
  void constant(const Instruction& i) {
    fill(i, [value = constant_as(constants[i.a], T{})](int) { return value; });
  }
  void variable(const Instruction& i) {
    fill(i, [in = inputs[i.a]](int k) { return in[k]; });
  }
  template <class F> void unary(const Instruction& i, F f) {
    fill(i, [f, a = place(i.a)](int k) { return f(a[k]); });
  }
  template <class F> void binary(const Instruction& i, F f) {
    fill(i, [f, a = place(i.a), b = place(i.b)](int k) { return f(a[k], b[k]); });
  }
  template <class F> void ternary(const Instruction& i, F f) {
    fill(i, [f, a = place(i.a), b = place(i.b), c = place(i.c)](int k) { return f(a[k], b[k], c[k]); });
  }
  // A loop inside f keeps the compiler from vectorising: lanes by hand.
  template <class F> void whole(const Instruction& i, F f) {
    using Lanes = Pack<T, 16 / sizeof(T)>;
    const T* const a = place(i.a);
    T* const out = place(i.out);
    int k = 0;
    for (; k + kWidth<Lanes> <= count; k += kWidth<Lanes>) store(out + k, f(load<Lanes>(a + k), i.n));
    for (; k < count; ++k) out[k] = f(a[k], i.n);
  }
};

/// f at `count` <= kBlockPoints points, inputs[0..3] being their x, y, z, w. `registers` has room for
/// Tape::registers * kBlockPoints numbers; the values, the same bits as one at a time, are `count` of them
/// from the returned one.
template <ScalarReal T>
inline const T* evaluate_block(const TapeView& tape, const T* const (&inputs)[4], int count, T* registers) {
  RunBlock<T> run{tape.constants, inputs, count, registers};
  run_tape(tape, run);
  return run.place(tape.result);
}

}  // namespace isocast::inline ISO_ISA
