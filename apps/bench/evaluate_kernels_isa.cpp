// Compiled once per instruction set: tapes and compiled formulas over every kind of number.
#include <isocast/apps/bench/compiled_surfaces.h>
#include <isocast/apps/bench/evaluate_kernels.h>
#include <isocast/math/pack.h>

namespace isocast::inline ISO_ISA {

extern const bench::EvaluateKernels evaluate_kernel_table;

namespace {

using bench::Evaluation, bench::Evaluators, bench::kEvaluatedValues, bench::kMostRegisters;

// An argument around x, on which the symbol of an affine form acts.
template <Real R> void set_argument(R x, R, int, R& a) { a = x; }
template <Real R> void set_argument(R x, R width, int, Interval<R>& a) {
  a = Interval<R>(x - width, x + width);
}
template <Real R> void set_argument(R x, R width, int, AffineForm<R, 1>& a) {
  a = AffineForm<R, 1>(x);
  a.e[0] = width;
}
template <Real R> void set_argument(R x, R, int axis, Gradient<R>& a) {
  a = {x, R(Scalar<R>(axis == 0)), R(Scalar<R>(axis == 1)), R(Scalar<R>(axis == 2))};
}

// Two numbers that tell results apart.
template <Real R> struct Digest { R first, second; };
template <Real R> Digest<R> digest(const R& f) { return {f, f}; }
template <Real R> Digest<R> digest(const Interval<R>& f) { return {f.lo, f.hi}; }
template <Real R> Digest<R> digest(const AffineForm<R, 1>& f) { return digest(interval_of(f)); }
template <Real R> Digest<R> digest(const Gradient<R>& f) { return {f.value, f.dx + f.dy + f.dz}; }

// Keeps the compiler from taking work out of the loop over repetitions.
void forget_memory() { asm volatile("" ::: "memory"); }

// Values in packs of F, the arguments x, y, z and w of each block in a row.
template <class F, Real R> struct Arguments {
  static constexpr int kWide = kWidth<R>, kPacks = kEvaluatedValues / kWide;

  alignas(64) F inputs[4 * kPacks];
  int packs;  // of a block

  Arguments(const Evaluation<Scalar<R>>& e) : packs(e.block > kWide ? e.block / kWide : 1) {
    for (int n = 0; n < kPacks; ++n)
      for (int a = 0; a < 3; ++a)
        set_argument(load<R>(e.points[a] + n * kWide), R(e.width), a, block(n)[a * packs + n % packs]);
    for (int n = 0; n < kPacks; ++n) block(n)[3 * packs + n % packs] = F(Scalar<R>(0));
  }
  // The inputs of the block of pack n.
  F* block(int n) { return inputs + n / packs * 4 * packs; }
  void write(const Evaluation<Scalar<R>>& e, int n, const F& f) const {
    const Digest<R> found = digest(f);
    store(e.results + n * kWide, found.first);
    store(e.results + kEvaluatedValues + n * kWide, found.second);
  }
};

// A tape over all blocks.
template <class F, Real R> struct TapeRun {
  using Args = Arguments<F, R>;
  template <int kStride> static void run(const Evaluation<Scalar<R>>& e) {
    Args arguments(e);
    alignas(64) F registers[kMostRegisters * kStride];
    for (int repeat = 0; repeat < e.repeats; ++repeat) {
      const bool last = repeat + 1 == e.repeats;
      for (int n = 0; n < Args::kPacks; n += kStride) {
        const F* const f = evaluate_some<kStride>(e.tape, arguments.block(n), registers, arguments.packs);
        for (int k = 0; last && k < kStride; ++k) arguments.write(e, n + k, f[k]);
      }
      forget_memory();
    }
  }
  static void any_block(const Evaluation<Scalar<R>>& e) {
    constexpr int kWide = kWidth<R>;
    if (e.block == 16) run<16 / kWide>(e);
    else if (e.block == 64) run<64 / kWide>(e);
    else run<256 / kWide>(e);
  }
};

// The same formula compiled, over all values.
template <class Surface, class F, Real R> void run_compiled(const Evaluation<Scalar<R>>& e) {
  using Args = Arguments<F, R>;
  Args arguments(e);
  alignas(64) F f[Args::kPacks];
  for (int repeat = 0; repeat < e.repeats; ++repeat) {
    for (int n = 0; n < Args::kPacks; n += arguments.packs) {
      const F* const in = arguments.block(n);
      const int packs = arguments.packs;
      for (int k = 0; k < packs; ++k) f[n + k] = Surface::value(in[k], in[packs + k], in[2 * packs + k]);
    }
    forget_memory();
  }
  for (int n = 0; n < Args::kPacks; ++n) arguments.write(e, n, f[n]);
}

template <class T> void run_block(const Evaluation<T>& e) {
  alignas(64) T registers[kMostRegisters * kBlockPoints];
  const T zero[kBlockPoints] = {};
  const int points = e.block < kBlockPoints ? e.block : kBlockPoints;
  for (int repeat = 0; repeat < e.repeats; ++repeat) {
    for (int n = 0; n < kEvaluatedValues; n += points) {
      const T* const inputs[4] = {e.points[0] + n, e.points[1] + n, e.points[2] + n, zero};
      const T* const f = evaluate_block(e.tape, inputs, points, registers);
      if (repeat + 1 < e.repeats) continue;
      for (int k = 0; k < points; ++k) e.results[n + k] = e.results[kEvaluatedValues + n + k] = f[k];
    }
    forget_memory();
  }
}

template <class T> constexpr Evaluators<T> evaluators() {
  using R = Native<T>;
  using I = Interval<R>;
  using A = AffineForm<R, 1>;
  using G = Gradient<R>;
  return {{TapeRun<R, R>::any_block, TapeRun<I, R>::any_block, TapeRun<A, R>::any_block,
           TapeRun<G, R>::any_block},
          {{run_compiled<CompiledTangle, R, R>, run_compiled<CompiledTangle, I, R>,
            run_compiled<CompiledTangle, A, R>, run_compiled<CompiledTangle, G, R>},
           {run_compiled<CompiledBarthDecic, R, R>, run_compiled<CompiledBarthDecic, I, R>,
            run_compiled<CompiledBarthDecic, A, R>, run_compiled<CompiledBarthDecic, G, R>}},
          run_block<T>};
}

}  // namespace

const bench::EvaluateKernels evaluate_kernel_table = {evaluators<float>(), evaluators<double>()};

}  // namespace isocast::inline ISO_ISA
