// The reference itself, against cells whose roots are known in closed form.
#include <isocast/apps/bench/cell_families.h>
#include <isocast/apps/reference/cell_reference.h>
#include <volume/cell/diagonal_cell.h>

#include <catch2/catch.hpp>
#include <cmath>

using namespace isocast;
using namespace isocast::reference;
using test::diagonal_cell, test::diagonal_cell_with_roots;

namespace {

void check_root(const CellRoot& root, long double s, int multiplicity, bool crossing, bool negative_behind) {
  CHECK(std::abs(root.s - s) <= 0x1p-60L);
  CHECK(root.multiplicity == multiplicity);
  CHECK(root.crossing == crossing);
  CHECK(root.negative_behind == negative_behind);
}

}  // namespace

TEST_CASE("three simple roots") {
  const CellReference r = solve(diagonal_cell_with_roots(1, 0.125, 0.5, 0.75));
  REQUIRE(r.root_count == 3);
  check_root(r.roots[0], 0.125L, 1, true, false);
  check_root(r.roots[1], 0.5L, 1, true, true);
  check_root(r.roots[2], 0.75L, 1, true, false);
  CHECK(first_crossing(r)->s == 0.125L);
  CHECK(first_crossing(r, 0.125)->s == 0.5L);
  CHECK(first_crossing(r, 0.6)->s == 0.75L);
  CHECK_FALSE(first_crossing(r, 0.75));
  // entry, both extrema, exit
  REQUIRE(r.critical_count == 4);
  CHECK(r.critical[0].value == -3 * 0.125 * 0.5 * 0.75);
  CHECK(r.critical[3].value == 3 * 0.875 * 0.5 * 0.25);
  const double e = (2.75 - std::sqrt(1.1875)) / 6;
  CHECK(r.critical[1].s == Approx(e).epsilon(1e-15));
  CHECK(r.critical[1].value == Approx(3 * (e - 0.125) * (e - 0.5) * (e - 0.75)).epsilon(1e-14));
}

TEST_CASE("an irrational root of a quadratic") {
  // 3/4 s^2 - 1/2
  const CellReference r = solve(diagonal_cell(-0.5, -0.5, -0.25, 0.25));
  REQUIRE(r.root_count == 1);
  check_root(r.roots[0], std::sqrt(2.0L / 3), 1, true, false);
}

TEST_CASE("double roots touch, triple roots cross") {
  const CellReference touch = solve(diagonal_cell_with_roots(1, 0.25, 0.5, 0.5));
  REQUIRE(touch.root_count == 2);
  check_root(touch.roots[0], 0.25L, 1, true, false);
  check_root(touch.roots[1], 0.5L, 2, false, false);
  const CellReference from_below = solve(diagonal_cell_with_roots(-1, 1.5, 0.25, 0.25));
  REQUIRE(from_below.root_count == 1);
  check_root(from_below.roots[0], 0.25L, 2, false, false);
  const CellReference below = solve(diagonal_cell_with_roots(1, 1.5, 0.25, 0.25));
  REQUIRE(below.root_count == 1);
  check_root(below.roots[0], 0.25L, 2, false, true);
  CHECK_FALSE(first_crossing(below));
  const CellReference triple = solve(diagonal_cell_with_roots(-1, 0.375, 0.375, 0.375));
  REQUIRE(triple.root_count == 1);
  check_root(triple.roots[0], 0.375L, 3, true, true);
  // the derivative's double root is no extremum
  CHECK(triple.critical_count == 2);
}

TEST_CASE("a double root of a quadratic") {
  // (s - 1/2)^2
  const CellReference r = solve(diagonal_cell(3 * 0.25, 3 * 0.25 - 1, 3 * 0.25 - 1, 3 * 0.25));
  REQUIRE(r.root_count == 1);
  check_root(r.roots[0], 0.5L, 2, false, false);
  REQUIRE(r.critical_count == 3);
  CHECK(r.critical[1].s == 0.5);
  CHECK(r.critical[1].value == 0);
}

TEST_CASE("zero at the ends counts as positive") {
  const CellReference falling_entry = solve(diagonal_cell_with_roots(1, 0, 1.5, 2)),
                      rising_exit = solve(diagonal_cell_with_roots(1, 1, 1.5, 2));
  REQUIRE(falling_entry.root_count == 1);
  check_root(falling_entry.roots[0], 0, 1, false, false);
  check_root(solve(diagonal_cell_with_roots(-1, 0, 1.5, 2)).roots[0], 0, 1, true, true);
  REQUIRE(rising_exit.root_count == 1);
  check_root(rising_exit.roots[0], 1, 1, true, false);
  check_root(solve(diagonal_cell_with_roots(-1, 1, 1.5, 2)).roots[0], 1, 1, false, false);
  // touching at entry from below leads from the zero back to negative
  check_root(solve(diagonal_cell_with_roots(1, 0, 0, 2)).roots[0], 0, 2, true, true);
}

TEST_CASE("lines, constants and nothing at all") {
  const CellReference line = solve(diagonal_cell(-1, 0, 1, 2));
  REQUIRE(line.root_count == 1);
  check_root(line.roots[0], 1.0L / 3, 1, true, false);
  CHECK(line.critical_count == 2);
  const CellReference constant = solve(diagonal_cell(2, 2, 2, 2));
  CHECK_FALSE(constant.zero);
  CHECK(constant.root_count == 0);
  CHECK(constant.coefficients[1] == 2);
  const CellReference zero = solve(diagonal_cell(0, 0, 0, 0));
  CHECK(zero.zero);
  CHECK(zero.root_count == 0);
  CHECK_FALSE(first_crossing(zero));
}

TEST_CASE("roots 2^-60 apart are two, with a value between them") {
  // (s - 2^-60)(s - 2^-59), whose coefficients need 120 bits: sums of three corners have them
  CellChord chord = diagonal_cell(0x1p-119, 0, 0, 1);
  chord.f[1] = chord.f[3] = 3 * 0x1p-119;
  chord.f[2] = -3 * 0x1p-60;
  chord.f[5] = -6 * 0x1p-60;
  chord.f[6] = 1;
  const CellReference r = solve(chord);
  REQUIRE(r.root_count == 2);
  CHECK(r.roots[0].s < r.roots[1].s);
  check_root(r.roots[0], 0x1p-60L, 1, true, true);
  check_root(r.roots[1], 0x1p-59L, 1, true, false);
  REQUIRE(r.critical_count >= 3);
  CHECK(r.critical[1].value == Approx(-0x1p-122).epsilon(0.1));
}

TEST_CASE("any numbers: denormals beside 1e30, points next to a face") {
  CellChord chord = diagonal_cell(5e-324, -5e-324, 1e30, -1e30);
  chord.entry[0] = 0x1p-1070;
  chord.exit[1] = 0x1.fffffffffffffp-1;
  const CellReference r = solve(chord);
  REQUIRE(r.root_count == 1);
  CHECK(std::abs(r.roots[0].s - 0.75L) < 1e-15L);
  CHECK(r.roots[0].negative_behind);
}

TEST_CASE("roots, extrema and values of every family fit together") {
  for (const bench::CellFamily& family : bench::cell_families()) {
    if (family.name == "denormal") continue;  // values between the smallest doubles are rounded to zero
    INFO("family " << family.name);
    const std::vector<CellChord> chords = bench::make_cells(family, 7, 0, 300, bench::Rounding::none);
    const std::vector<CellReference> references = solve(chords);
    for (std::size_t n = 0; n < chords.size(); ++n) {
      const CellReference& r = references[n];
      const bool negative_entry = r.critical[0].value < 0,
                 negative_exit = r.critical[r.critical_count - 1].value < 0;
      int crossings = 0;
      for (int i = 0; i < r.root_count; ++i) crossings += r.roots[i].crossing;
      REQUIRE((crossings % 2 == 1) == (negative_entry != negative_exit));
      REQUIRE(exact_value(chords[n], 0) == r.critical[0].value);
      // a grid point's sign follows from the roots before it
      for (const double s : {0.25, 0.5, 0.875}) {
        bool negative = negative_entry;
        for (int i = 0; i < r.root_count; ++i)
          if (r.roots[i].s < s) negative = r.roots[i].negative_behind;
        const double value = exact_value(chords[n], s);
        REQUIRE((value == 0 || (value < 0) == negative));
      }
    }
  }
}

TEST_CASE("a family's cells do not depend on the others, and are floats if asked") {
  const bench::CellFamily& family = bench::cell_family("close-roots");
  const auto all = bench::make_cells(family, 3, 0, 50, bench::Rounding::to_float);
  const auto some = bench::make_cells(family, 3, 20, 5, bench::Rounding::to_float);
  for (int n = 0; n < 5; ++n)
    for (int i = 0; i < 8; ++i) {
      CHECK(some[n].f[i] == all[20 + n].f[i]);
      CHECK(some[n].f[i] == static_cast<double>(static_cast<float>(some[n].f[i])));
    }
  CHECK_THROWS_WITH(bench::cell_family("nothing"),
                    Catch::StartsWith("cell family 'nothing' is unknown; expected one of random, smooth"));
}
