// A formula's source text, compiled, has the bits of its tape, for every kind of number and every surface of
// the catalogue.
#include "expressions.h"

#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/expression/simplify.h>
#include <isocast/implicit/expression/tape.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <random>

using namespace isocast;
using namespace isocast::test;

namespace {

bool same(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b));
}
bool same(float a, float b) { return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b)); }
bool same(const Interval<float>& a, const Interval<float>& b) {
  return same(a.lo, b.lo) && same(a.hi, b.hi) && a.defined == b.defined && a.continuous == b.continuous &&
         a.empty == b.empty;
}
bool same(const AffineForm<float, 1>& a, const AffineForm<float, 1>& b) {
  return same(a.c, b.c) && same(a.e[0], b.e[0]) && same(a.r, b.r) && a.defined == b.defined &&
         a.continuous == b.continuous && a.empty == b.empty;
}
bool same(const Gradient<Interval<float>>& a, const Gradient<Interval<float>>& b) {
  return same(a.value, b.value) && same(a.dx, b.dx) && same(a.dy, b.dy) && same(a.dz, b.dz);
}

template <class R>
void require_same(const Tape& tape, WrittenFunction<R>* written, const R (&inputs)[4], const char* id) {
  std::vector<R> registers(tape.registers);
  R result;
  written(inputs[0], inputs[1], inputs[2], inputs[3], &result);
  INFO(id);
  REQUIRE(same(result, evaluate(tape.view(), inputs, registers.data())));
}

}  // namespace

TEST_CASE("a formula's source text has the bits of its tape") {
  std::mt19937_64 random(51);
  REQUIRE(kWrittenCount == static_cast<int>(catalogue().size()));
  for (int n = 0; n < kWrittenCount; ++n) {
    const WrittenSurface& written = kWrittenSurfaces[n];
    const CatalogueSurface& surface = catalogue()[static_cast<std::size_t>(n)];
    REQUIRE(surface.id == written.id);
    const Tape tape = make_tape(simplify(surface_expression(surface)));
    for (int round = 0; round < 50; ++round) {
      double number[4];
      Interval<float> interval[4];
      AffineForm<float, 1> affine[4];
      Gradient<Interval<float>> gradient[4];
      for (int v = 0; v < 4; ++v) {
        const double lo = v < 3 ? surface.domain.lo[std::size_t(v)] : 0,
                     hi = v < 3 ? surface.domain.hi[std::size_t(v)] : 1;
        number[v] = std::uniform_real_distribution<double>(lo, hi)(random);
        const RayPart<float> part(0, round % 2 ? 0.125f : 1.0f);
        const auto at = static_cast<float>(number[v]), along = static_cast<float>(hi - lo);
        part.coordinate(at, along, 1e-6f, v, interval[v]);
        part.coordinate(at, along, 1e-6f, v, affine[v]);
        part.coordinate(at, along, 1e-6f, v, gradient[v]);
      }
      require_same(tape, written.number, number, written.id);
      require_same(tape, written.interval, interval, written.id);
      require_same(tape, written.affine, affine, written.id);
      require_same(tape, written.gradient, gradient, written.id);
    }
  }
}
