// One instruction set (PACK_TEST_ISA) against the scalar: every operation gives the same bits.
#include <isocast/apps/bench/random.h>
#include <math/pack_operations.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <iostream>
#include <limits>
#include <string>

using namespace isocast;
using namespace isocast::test;

namespace {

// The set under test; nothing where this processor lacks it.
const PackOperations* operations_here() {
  for (int i = 0; i < kIsaCount; ++i) {
    const Isa isa = static_cast<Isa>(i);
    if (name_of(isa) != PACK_TEST_ISA) continue;
    if (runs_here(isa)) return &pack_operations(isa);
  }
  std::cout << "skipped: this processor lacks " << PACK_TEST_ISA << "\n";
  return nullptr;
}

void apply(const PackOperations& set, Operation op, const float* a, const float* b, const float* c,
           float* out) {
  set.apply_float(op, a, b, c, out);
}
void apply(const PackOperations& set, Operation op, const double* a, const double* b, const double* c,
           double* out) {
  set.apply_double(op, a, b, c, out);
}
std::uint32_t lanes_of(const PackOperations& set, const float* a, const float* b) {
  return set.lanes_of_float(a, b);
}
std::uint32_t lanes_of(const PackOperations& set, const double* a, const double* b) {
  return set.lanes_of_double(a, b);
}

// Ordinary numbers, and one in four at an end of what there is.
template <class T> T any_number(bench::Random& random) {
  using Limits = std::numeric_limits<T>;
  const T special[] = {0,
                       -T(0),
                       1,
                       -1,
                       Limits::infinity(),
                       -Limits::infinity(),
                       Limits::max(),
                       Limits::min(),
                       Limits::denorm_min(),
                       -Limits::denorm_min(),
                       Limits::epsilon(),
                       Limits::quiet_NaN()};
  if (random.below(4) == 0) return special[random.below(12)];
  return static_cast<T>(random.sign() * std::exp2(random.uniform(-30, 30)));
}

// Bits, but for what a NaN carries.
template <class T> bool same(T a, T b) {
  return (std::isnan(a) && std::isnan(b)) || std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace

TEMPLATE_TEST_CASE("every operation has the scalar's bits", "", float, double) {
  const PackOperations* set = operations_here();
  if (!set) return;
  const PackOperations& scalar = pack_operations(Isa::scalar);
  for (int n = 0; n < 2000; ++n) {
    bench::Random random(1, n);
    TestType a[kLanes], b[kLanes], c[kLanes], expected[kLanes], found[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) {
      a[lane] = any_number<TestType>(random);
      b[lane] = random.below(5) ? any_number<TestType>(random) : a[lane];
      c[lane] = any_number<TestType>(random);
    }
    for (int op = 0; op < kOperationCount; ++op) {
      apply(scalar, static_cast<Operation>(op), a, b, c, expected);
      apply(*set, static_cast<Operation>(op), a, b, c, found);
      for (int lane = 0; lane < kLanes; ++lane) {
        if (same(expected[lane], found[lane])) continue;
        FAIL("operation " << op << " of " << a[lane] << ", " << b[lane] << ", " << c[lane] << ": "
                          << found[lane] << ", not " << expected[lane]);
      }
    }
    REQUIRE(lanes_of(*set, a, b) == lanes_of(scalar, a, b));
    REQUIRE(lanes_of(*set, a, b) >> kLanes == 1);
  }
}
