// One instruction set (INCLUSION_TEST_ISA) against the scalar: every operation of every kind of inclusion
// gives the same bits.
#include <math/inclusion_kernels.h>
#include <math/operands.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <iostream>
#include <string>

using namespace isocast;
using namespace isocast::test;

namespace {

// The set under test; nothing where this processor lacks it.
const InclusionKernels* kernels_here() {
  for (int i = 0; i < kIsaCount; ++i) {
    const Isa isa = static_cast<Isa>(i);
    if (name_of(isa) != INCLUSION_TEST_ISA) continue;
    if (runs_here(isa)) return &inclusion_kernels(isa);
  }
  std::cout << "skipped: this processor lacks " << INCLUSION_TEST_ISA << "\n";
  return nullptr;
}

void apply(const InclusionKernels& set, Kind kind, Inclusion op, int n, const float* a, const float* b,
           float* out) {
  set.apply_float(kind, op, n, a, b, out);
}
void apply(const InclusionKernels& set, Kind kind, Inclusion op, int n, const double* a, const double* b,
           double* out) {
  set.apply_double(kind, op, n, a, b, out);
}

// Intervals, or c, e and r of forms, in all lanes.
template <class T> void fill(bench::Random& random, Kind kind, T* numbers) {
  for (int lane = 0; lane < kInclusionLanes; ++lane) {
    T* const a = numbers + lane;
    const Range<T> range = any_range<T>(random);
    const bool forms = kind == Kind::affine_1 || kind == Kind::affine_3;
    a[0] = forms ? any_finite<T>(random) : range.lo;
    a[kInclusionLanes] = forms ? static_cast<T>(random.uniform(-1, 1)) : range.hi;
    for (int k = 2; k < kNumbersIn; ++k) a[k * kInclusionLanes] = static_cast<T>(random.uniform(0, 0.1));
  }
}

template <class T> bool same(T a, T b) {
  return (std::isnan(a) && std::isnan(b)) || std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace

TEMPLATE_TEST_CASE("every operation of every kind of inclusion has the scalar's bits", "", float, double) {
  const InclusionKernels* set = kernels_here();
  if (!set) return;
  constexpr int kIn = kNumbersIn * kInclusionLanes, kOut = kNumbersOut * kInclusionLanes;
  const int exponents[] = {0, 2, 3, 8, 17, -1, -2};
  for (int n = 0; n < 200; ++n)
    for (int kind = 0; kind < kKindCount; ++kind) {
      bench::Random random(400 + kind, n);
      TestType a[kIn], b[kIn];
      fill(random, static_cast<Kind>(kind), a);
      fill(random, static_cast<Kind>(kind), b);
      const int exponent = exponents[random.below(7)];
      for (int op = 0; op < kInclusionCount; ++op) {
        const Kind k = static_cast<Kind>(kind);
        const Inclusion operation = static_cast<Inclusion>(op);
        TestType expected[kOut] = {}, found[kOut] = {};
        apply(inclusion_kernels(Isa::scalar), k, operation, exponent, a, b, expected);
        apply(*set, k, operation, exponent, a, b, found);
        for (int i = 0; i < kOut; ++i) {
          if (same(expected[i], found[i])) continue;
          const int lane = i % kInclusionLanes;
          FAIL("kind " << kind << ", operation " << op << ", case " << n << ", number " << i / kInclusionLanes
                       << " of " << a[lane] << " " << a[lane + kInclusionLanes] << ": " << found[i]
                       << ", not " << expected[i]);
        }
      }
    }
}
