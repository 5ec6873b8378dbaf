// The reference for volumes itself: closed forms, the cell's own reference, and what every ray must show.
#include <isocast/apps/reference/cell_reference.h>
#include <isocast/apps/reference/volume_reference.h>
#include <isocast/base/error.h>
#include <volume/make_tree.h>
#include <volume/make_volume.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

using namespace isocast;
using namespace isocast::reference;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Expected {
  long double t;
  bool crossing = true;
};
void check_roots(const RayTruth& truth, const std::vector<Expected>& expected) {
  REQUIRE(truth.roots.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const RayRoot& root = truth.roots[i];
    const long double slack = 1e-18L * std::abs(expected[i].t);  // the closed form is itself rounded
    CHECK(root.lo <= expected[i].t + slack);
    CHECK(root.hi >= expected[i].t - slack);
    CHECK(root.hi - root.lo <= 1e-12 + 1e-15 * std::abs(root.lo));
    CHECK(root.crossing == expected[i].crossing);
  }
}

std::shared_ptr<Volume> plane(std::int64_t n = 9) {
  return test::make_volume({n, n, n}, SampleType::f32,
                           [](auto i, auto j, auto k) { return double(i + j + k); });
}
// A volume whose ray along x at y = z = 0 sees the lines between the values.
std::shared_ptr<Volume> along_x(const std::vector<double>& values, SampleType type = SampleType::f64) {
  return test::make_volume({static_cast<std::int64_t>(values.size()), 2, 2}, type,
                           [&](auto i, auto, auto) { return values[static_cast<std::size_t>(i)]; });
}
RayTruth solve_x(const std::shared_ptr<Volume>& volume, double iso, double t0 = -10, double t1 = 100) {
  return VolumeReference(volume, {iso}).solve({0, 0.5, 0.25}, {1, 0, 0}, t0, t1);
}

}  // namespace

TEST_CASE("a plane that was sampled: one crossing, wherever the ray comes from") {
  const VolumeReference reference(plane(), {10.5});
  check_roots(reference.solve({-1, 2.25, 3.125}, {0.5, 0.25, 0.125}, 0, 100), {{6.125L / 0.875L}});
  check_roots(reference.solve({20, 2.5, 3.5}, {-3, 0, 0}, 0, 100), {{15.5L / 3}});
  check_roots(reference.solve({0, 0, 0}, {1, 1, 1}, 0, 100), {{3.5L}});       // through lattice points
  check_roots(reference.solve({-1, 4, 4}, {1, 0, 0}, 0, 100), {{3.5L}});      // in an edge of cells
  check_roots(reference.solve({-1, 4, 4.25}, {1, 0, 0}, 0, 100), {{3.25L}});  // in a face
  check_roots(reference.solve({-1, 0, 4.25}, {1, 0, 0}, 0, 100), {{7.25L}});  // in the border
  check_roots(reference.solve({0, 0, 0}, {1, 1, 1}, 4, 100), {});
  check_roots(reference.solve({0, -1, 0}, {1, 0, 1}, 0, 100), {});
  check_roots(reference.solve({0, 0, 0}, {-1, -1, -1}, 0, 100), {});
  check_roots(reference.solve({-1e15, 2.5, 3.5}, {1, 0, 0}, 0, 2e15), {{1e15L + 4.5L}});
  check_roots(reference.solve({0, 3.5, 3.5}, {1e-300, 0, 0}, 0, 1e302), {{3.5e300L * (1 - 1e-20L)}});
  CHECK(reference.solve({1e300, 1e300, 1e300}, {1, 2, -1e300}, 0, 1e300).roots.empty());
  CHECK(reference.solve({1, 1, 1}, {0, 0, 0}, 0, 1).roots.empty());
  CHECK(reference.unit() == 1);
}

TEST_CASE("a root on a face is one, with its condition and distance") {
  const VolumeReference reference(plane(), {9, 10.5});
  const RayTruth truth =
      reference.solve({0, 0, 0}, {2, 2, 2}, 0, 100);  // f = 6 t: t = 1.5 is a lattice point
  check_roots(truth, {{1.5L}, {1.75L}});
  CHECK(truth.roots[0].iso == 0);
  CHECK(truth.roots[1].iso == 1);
  // both cells at the face have corners 3 away from it
  CHECK(truth.roots[0].condition == Approx(3.0 / 6 * 2 * std::sqrt(3)));
  CHECK(truth.roots[1].condition == Approx(1.5 / 6 * 2 * std::sqrt(3)));
  CHECK(truth.roots[0].distance == Approx(0.5 * std::sqrt(3)));
  CHECK(truth.roots[1].distance == Approx(0.5 * std::sqrt(3)));
  CHECK(reference.solve({0, 0, 0}, {2, 2, 2}, 0, 1.6).roots[0].distance == kInfinity);
}

TEST_CASE("a product that was sampled is a cubic along the diagonal, across cells") {
  // (x - 1.5)(y - 3.25)(z - 5.75) is trilinear: its samples give it back
  const auto volume = test::make_volume({9, 9, 9}, SampleType::f64, [](auto i, auto j, auto k) {
    return (double(i) - 1.5) * (double(j) - 3.25) * (double(k) - 5.75);
  });
  const VolumeReference reference(volume, {0});
  check_roots(reference.solve({0, 0, 0}, {1, 1, 1}, 0, 10), {{1.5L}, {3.25L}, {5.75L}});
  // two factors vanish together: a touch, and the third crosses
  check_roots(reference.solve({0, 1.75, 0}, {1, 1, 1}, 0, 10), {{1.5L, false}, {5.75L}});
  CHECK(reference.solve({0, 1.75, 0}, {1, 1, 1}, 0, 10).roots[0].condition == kInfinity);
  // all three: a threefold root crosses
  check_roots(reference.solve({0, 1.75, 4.25}, {1, 1, 1}, 0, 10), {{1.5L}});
  // inside the plane x = 1.5 there is nothing but zero
  const RayTruth zero = reference.solve({1.5, -1, 2}, {0, 1, 0}, 0, 100);
  REQUIRE(zero.doubts.size() == 1);
  CHECK(zero.doubts[0].doubt == Doubt::zero);
  CHECK(zero.doubts[0].lo == 1);
  CHECK(zero.doubts[0].hi == 9);
  CHECK(zero.roots.empty());
  // iso 1: the roots of a cubic without a closed form of ours are where the product is 1
  for (const RayRoot& root : VolumeReference(volume, {1}).solve({0, 0, 0}, {1, 1, 1}, 0, 8).roots) {
    const double t = 0.5 * (root.lo + root.hi);
    CHECK((t - 1.5) * (t - 3.25) * (t - 5.75) == Approx(1).epsilon(1e-13));
  }
}

TEST_CASE("touches, plateaus and ends") {
  check_roots(solve_x(along_x({2, 1, 2, 0, 2}), 1), {{1, false}, {2.5L}, {3.5L}});
  check_roots(solve_x(along_x({0, 1, 0}), 1), {{1, false}});
  check_roots(solve_x(along_x({1, 0, 2}), 1), {{0}, {1.5L}});  // at the border f counts as iso outside
  check_roots(solve_x(along_x({1, 2, 0}), 1), {{0, false}, {1.5L}});
  check_roots(solve_x(along_x({0, 1}), 1), {{1}});
  check_roots(solve_x(along_x({0, 3, 0}), 1, 0.5, 1.5), {});
  check_roots(solve_x(along_x({0, 3, 0}), 1, 0.25, 1.75), {{1.0L / 3}, {5.0L / 3}});
  // a plateau between both signs: iso counts as not negative
  const RayTruth plateau = solve_x(along_x({0, 1, 1, 1, 0, 2}), 1);
  check_roots(plateau, {{1}, {3}, {4.5L}});
  REQUIRE(plateau.doubts.size() == 1);
  CHECK(plateau.doubts[0].lo == 1);
  CHECK(plateau.doubts[0].hi == 3);
}

TEST_CASE("too many cells for one ray are a doubt") {
  std::vector<double> values(1 << 18);
  for (std::size_t i = 0; i < values.size(); i += 2) values[i] = 2;
  const RayTruth truth = solve_x(along_x(values, SampleType::u8), 1, 0, 1e6);
  CHECK(truth.roots.empty());
  REQUIRE(truth.doubts.size() == 1);
  CHECK(truth.doubts[0].doubt == Doubt::work);
  CHECK(truth.doubts[0].hi == 1e6);
}

TEST_CASE("cells with a corner that is not finite are none, and every type is read") {
  check_roots(solve_x(along_x({0, 2, 0, std::nan(""), 0, 2, kInfinity, 0, 2}), 1),
              {{0.5L}, {1.5L}, {4.5L}, {7.5L}});
  for (const SampleType type : {SampleType::u8, SampleType::i8, SampleType::u16, SampleType::i16,
                                SampleType::u32, SampleType::i32, SampleType::f32, SampleType::f64})
    check_roots(solve_x(along_x({3, 100, 7}, type), 50), {{47.0L / 97}, {143.0L / 93}});
  check_roots(solve_x(along_x({0x3c00, 0x4000}, SampleType::f16), 1.25), {{0.25L}});
  check_roots(solve_x(along_x({4294967295.0, 4294967293.0}, SampleType::u32), 4294967294.5), {{0.25L}});
}

TEST_CASE("the iso-value is in the file's units, the unit a voxel's longest edge, the transform any") {
  const auto volume = plane();
  volume->slope = 2;
  volume->intercept = -1;
  volume->world_from_grid = {{{0, -0.5, 0, 10}, {0.25, 0, 0, 20}, {0, 0, 2, 30}}};
  const VolumeReference reference(volume, {20});  // stored 10.5
  CHECK(reference.unit() == 2);
  // grid (4 (y - 20), -2 (x - 10), (z - 30) / 2)
  const RayTruth truth = reference.solve({8.125, 20, 31}, {0, 0.125, 0}, 0, 100);
  check_roots(truth, {{12.5L}});
  CHECK(truth.roots[0].condition == Approx(1.5 / 0.5 * 0.125 / 2));
  CHECK_THROWS_AS(VolumeReference(volume, {kInfinity}), InputError);
  CHECK_THROWS_AS(reference.solve({0, 0, 0}, {1, 0, 0}, 1, 1), InputError);
  CHECK_THROWS_AS(reference.solve({0, std::nan(""), 0}, {1, 0, 0}, 0, 1), InputError);
}

TEST_CASE("inside one cell the roots are those of the cell's reference") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  int roots = 0;
  for (int n = 0; n < 2000; ++n) {
    CellChord chord;
    for (double& f : chord.f) f = std::floor(9 * unit(random)) - 4;
    const auto volume = test::make_volume({2, 2, 2}, SampleType::f64, [&](auto i, auto j, auto k) {
      return chord.f[static_cast<std::size_t>(i + 2 * j + 4 * k)];
    });
    for (int a = 0; a < 3; ++a) {  // multiples of 2^-20: the span between them is exact
      chord.entry[a] = std::floor(0x1p20 * unit(random)) * 0x1p-20;
      chord.exit[a] = std::floor(0x1p20 * unit(random)) * 0x1p-20;
    }
    const Double3 o = {chord.entry[0], chord.entry[1], chord.entry[2]},
                  p = {chord.exit[0], chord.exit[1], chord.exit[2]};
    const RayTruth truth = VolumeReference(volume, {0}).solve(o, p - o, 0, 1);
    const CellReference expected = solve(chord);
    REQUIRE(truth.decided() == !expected.zero);
    REQUIRE(static_cast<int>(truth.roots.size()) == expected.root_count);
    for (int i = 0; i < expected.root_count; ++i) {
      const RayRoot& root = truth.roots[static_cast<std::size_t>(i)];
      REQUIRE(root.lo <= expected.roots[i].s + 0x1p-59L);
      REQUIRE(root.hi >= expected.roots[i].s - 0x1p-59L);
      REQUIRE(root.crossing == expected.roots[i].crossing);
      ++roots;
    }
  }
  CHECK(roots > 500);
}

TEST_CASE("a sparse grid has the roots of the dense one, and none where nothing is active") {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> unit(0, 1);
  const auto f = [](auto i, auto j, auto k) { return double((i * 7 + j * 5 + k * 3) % 11); };
  const VolumeReference dense(test::make_volume({12, 12, 12}, SampleType::f32, f), {4.5}),
      sparse(test::make_full_tree({12, 12, 12}, SparseType::f32, 9, f), {4.5});
  for (int n = 0; n < 50; ++n) {
    const Double3 o = {unit(random) * 11, unit(random) * 11, -1},
                  d = {unit(random) - 0.5, unit(random) - 0.5, 1};
    // beyond the last sample a sparse grid has cells of its own
    std::vector<RayRoot> inside;
    for (const RayRoot& root : sparse.solve(o, d, 0, 100).roots) {
      const Double3 p = o + root.lo * d;
      if (std::min({p[0], p[1], p[2]}) > 1e-9 && std::max({p[0], p[1], p[2]}) < 11 - 1e-9)
        inside.push_back(root);
    }
    const std::vector<RayRoot> expected = dense.solve(o, d, 0, 100).roots;
    REQUIRE(inside.size() == expected.size());
    for (std::size_t i = 0; i < inside.size(); ++i) REQUIRE(inside[i].lo == expected[i].lo);
  }
}

TEST_CASE("tiles of a sparse grid: far borders, inactive ones, a plateau") {
  test::TreeMaker maker(SparseType::f32, 3);
  maker.tile({0, 0, 0}, 7, -1, true);       // 128^3
  maker.tile({4096, 0, 0}, 12, -1, false);  // nothing active
  maker.tile({-8192, 0, 0}, 12, -1, true);  // 4096^3
  maker.set({300, 1, 1}, -5, true);
  const VolumeReference reference(maker.volume(), {0});
  const RayTruth truth = reference.solve({-1e4, 0.5, 0.5}, {1, 0, 0}, 0, 1e5);
  check_roots(truth, {
                         {1e4L - 8193 + 0.75L}, {1e4L - 4097 + 0.25L}, {1e4L - 1 + 0.75L}, {1e4L + 127.25L},
                         // the cells beside (300, 1, 1): 3 - 8 / 4 (1 - |x - 300|) = 1 at least
                     });
  check_roots(reference.solve({-1e4, 1, 1}, {1, 0, 0}, 10250, 1e5), {{1e4L + 299.375L}, {1e4L + 300.625L}});
  const RayTruth plateau = VolumeReference(maker.volume(), {-1}).solve({50, 50, -10}, {0, 0, 1}, 0, 1000);
  REQUIRE(plateau.doubts.size() == 1);
  CHECK(plateau.doubts[0].lo == 10);
  CHECK(plateau.doubts[0].hi == 10 + 127);
}
