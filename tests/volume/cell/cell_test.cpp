// The field of a cell and the cubic along a chord.
#include <isocast/apps/bench/cell_families.h>
#include <isocast/apps/bench/random.h>
#include <isocast/math/real.h>
#include <isocast/math/rounding.h>
#include <isocast/volume/cell/cell.h>
#include <isocast/volume/cell/marmitt.h>
#include <volume/cell/diagonal_cell.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace isocast;
using reference::CellChord;

namespace {

template <class T> Cell<T> cell_of(const CellChord& chord) {
  Cell<T> cell{};
  for (int i = 0; i < 8; ++i) cell.f[i] = static_cast<T>(chord.f[i]);
  cell.entry = {static_cast<T>(chord.entry[0]), static_cast<T>(chord.entry[1]),
                static_cast<T>(chord.entry[2])};
  cell.exit = {static_cast<T>(chord.exit[0]), static_cast<T>(chord.exit[1]), static_cast<T>(chord.exit[2])};
  cell.carry = std::numeric_limits<T>::quiet_NaN();
  return cell;
}

template <class T> T largest_corner(const Cell<T>& cell) {
  T largest = 0;
  for (const T f : cell.f) largest = std::max(largest, std::abs(f));
  return largest;
}

constexpr const char* kTameFamilies[] = {"random", "smooth", "thin", "mc-2-face", "close-roots"};

}  // namespace

TEMPLATE_TEST_CASE("f along the chord is a cubic whose coefficients are sums over the corners", "", float,
                   double) {
  for (const char* name : kTameFamilies)
    for (const CellChord& chord :
         bench::make_cells(bench::cell_family(name), 2, 0, 500, bench::Rounding::to_float)) {
      const Cell<TestType> cell = cell_of<TestType>(chord);
      const auto bernstein = cubic_along(cell);
      const auto power = textbook_cubic_along(cell);
      const TestType unit = kUnitRoundoff<TestType> * largest_corner(cell);
      const reference::CellReference truth = reference::solve(chord);
      const TestType c[] = {bernstein.c0, bernstein.c1, bernstein.c2, bernstein.c3};
      for (int i = 0; i < 4; ++i) REQUIRE(std::abs(c[i] - truth.coefficients[i]) <= 8 * unit);
      for (const double s : {0.0, 0.125, 0.4375, 0.75, 1.0}) {
        const double exact = reference::exact_value(chord, s);
        const TestType t = static_cast<TestType>(s);
        REQUIRE(std::abs(eval(bernstein, t) - exact) <= 16 * unit);
        REQUIRE(std::abs(trilinear(cell.f, point_at(cell, t)) - exact) <= 16 * unit);
        REQUIRE(std::abs(eval(power, t) - exact) <= 128 * unit);
      }
    }
}

TEMPLATE_TEST_CASE("entry and exit have the bits of the trilinear value, on a face those of its four corners",
                   "", float, double) {
  for (const char* name : kTameFamilies)
    for (const CellChord& chord :
         bench::make_cells(bench::cell_family(name), 3, 0, 500, bench::Rounding::to_float)) {
      const Cell<TestType> cell = cell_of<TestType>(chord);
      const auto p = cubic_along(cell);
      REQUIRE(p.c0 == trilinear(cell.f, cell.entry));
      REQUIRE(p.c3 == trilinear(cell.f, cell.exit));
      REQUIRE(bilinear_on_face(cell.f, cell.entry) == p.c0);
      REQUIRE(bilinear_on_face(cell.f, cell.exit) == p.c3);
    }
}

TEST_CASE("neighbouring cells agree on the face they share") {
  bench::Random random(4, 0);
  for (int n = 0; n < 1000; ++n) {
    // twelve samples: the middle four belong to both cells
    float samples[3][4];
    for (auto& slice : samples)
      for (float& f : slice) f = static_cast<float>(random.uniform(-1, 1));
    const float y = static_cast<float>(random.uniform()), z = static_cast<float>(random.uniform());
    float left[8], right[8];
    for (int i = 0; i < 8; ++i) {
      left[i] = samples[i & 1][i >> 1];
      right[i] = samples[(i & 1) + 1][i >> 1];
    }
    REQUIRE(trilinear(left, Vec3<float>{1, y, z}) == trilinear(right, Vec3<float>{0, y, z}));
  }
}

TEST_CASE("after isolation the bracket holds one root, the first") {
  for (const bench::CellFamily& family : bench::cell_families()) {
    INFO("family " << family.name);
    int hits = 0;
    for (const CellChord& chord : bench::make_cells(family, 6, 0, 1000, bench::Rounding::none)) {
      const Cell<double> cell = cell_of<double>(chord);
      const reference::CellReference truth = reference::solve(chord);
      // where rounding decides there is nothing to say
      double margin = INFINITY;
      for (int i = 0; i < truth.critical_count; ++i)
        margin = std::min(margin, std::abs(truth.critical[i].value));
      const double unit = std::max(kUnitRoundoff<double> * largest_corner(cell), kSmallest<double>);
      if (margin <= 8 * unit) continue;
      const auto isolated = isolate_first_root(cubic_along(cell), cell, -1.0, true);
      const auto first = first_crossing(truth);
      REQUIRE(isolated.hit == first.has_value());
      if (!isolated.hit) continue;
      const double lo = isolated.bracket.lo, hi = isolated.bracket.hi;
      for (int i = 0; i < truth.root_count; ++i)
        if (truth.roots[i].s != first->s) REQUIRE((truth.roots[i].s < lo || truth.roots[i].s > hi));
      // near a triple root the cut is made where f is zero but for rounding
      if (first->s < lo) REQUIRE(std::abs(reference::exact_value(chord, lo)) <= 8 * unit);
      if (first->s > hi) REQUIRE(std::abs(reference::exact_value(chord, hi)) <= 8 * unit);
      ++hits;
    }
    if (family.name == "random") CHECK(hits > 300);
  }
}
