// The truth of scenes: formulas in their box, volumes as they were built; and its answers on disk.
#include <isocast/apps/reference/formula_ray_reference.h>
#include <isocast/apps/reference/reference_cache.h>
#include <isocast/apps/reference/scene_reference.h>
#include <isocast/implicit/expression/parse.h>
#include <temporary_folder.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>

using namespace isocast;
using namespace isocast::reference;

namespace {

Domain cube(double half) { return {{-half, -half, -half}, {half, half, half}}; }

// Counts its calls.
class Counted final : public RayReference {
 public:
  explicit Counted(std::string identity) : identity_(std::move(identity)) {}
  RayTruth solve(const Double3& o, const Double3&, double t0, double t1) const override {
    ++calls;
    RayTruth truth;
    if (o[0] > 0) truth.roots = {{t0, t1, true, 2.5, 1.25, 3}, {t1, t1, false, 1 / 0.0, 1.25, 0}};
    if (o[1] > 0) truth.doubts = {{t0, t1, Doubt::jump}};
    truth.bits = 64;
    return truth;
  }
  double unit() const override { return 1; }
  std::string identity() const override { return identity_; }
  mutable std::atomic<int> calls = 0;

 private:
  std::string identity_;
};

std::vector<ReferenceRay> made_rays(int count) {
  std::vector<ReferenceRay> rays;
  for (int i = 0; i < count; ++i)
    rays.push_back({{double(i % 2), double(i % 3), 0}, {1, 0, 0}, 0.0, 1.0 + i});
  return rays;
}
void check_equal(const std::vector<RayTruth>& a, const std::vector<RayTruth>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].bits == b[i].bits);
    REQUIRE(a[i].roots.size() == b[i].roots.size());
    for (std::size_t k = 0; k < a[i].roots.size(); ++k) {
      const RayRoot &x = a[i].roots[k], &y = b[i].roots[k];
      CHECK(std::tie(x.lo, x.hi, x.crossing, x.condition, x.distance, x.iso) ==
            std::tie(y.lo, y.hi, y.crossing, y.condition, y.distance, y.iso));
    }
    REQUIRE(a[i].doubts.size() == b[i].doubts.size());
    for (std::size_t k = 0; k < a[i].doubts.size(); ++k)
      CHECK(std::tie(a[i].doubts[k].lo, a[i].doubts[k].hi, a[i].doubts[k].doubt) ==
            std::tie(b[i].doubts[k].lo, b[i].doubts[k].hi, b[i].doubts[k].doubt));
  }
}

}  // namespace

TEST_CASE("a formula in its box: clipped, for several iso-values, with condition and distance") {
  const FormulaRayReference reference(parse_expression("x^2 + y^2 + z^2"), cube(1.5), 0, {1, 4});
  CHECK(reference.unit() == 3);
  const RayTruth truth = reference.solve({-8, 0, 0}, {2, 0, 0}, 0, 100);
  REQUIRE(truth.roots.size() == 2);  // the larger sphere lies outside the box
  CHECK(truth.roots[0].lo <= 3.5);
  CHECK(truth.roots[0].hi >= 3.5);
  CHECK(truth.roots[0].hi - truth.roots[0].lo <= 3e-12);
  CHECK(truth.roots[1].lo == Approx(4.5));
  CHECK(truth.roots[0].distance == Approx(2.0 / 3));
  // f - 1 reaches 1.25 at the ends of the box; df/dx = 2
  CHECK(truth.roots[0].condition == Approx(1.25 / 2 / 3));
  const RayTruth corner = reference.solve({1.25, 1.25, -9}, {0, 0, 1}, 0, 100);
  REQUIRE(corner.roots.size() == 2);
  CHECK(corner.roots[0].iso == 1);
  CHECK(reference.solve({1.25, 1.25, -9}, {0, 0, 1}, 0, 5).roots.empty());
  CHECK(reference.solve({2, 0, 0}, {0, 1, 0}, -9, 9).roots.empty());
  CHECK(reference.identity() !=
        FormulaRayReference(parse_expression("x^2 + y^2 + z^2"), cube(1.5), 0, {1}).identity());
  CHECK(reference.identity() !=
        FormulaRayReference(parse_expression("x^2 + y^2 - z^2"), cube(1.5), 0, {1, 4}).identity());
}

TEST_CASE("the reference of a scene is that of its object") {
  SceneDescription description;
  description.objects.front().source = FormulaSource{parse_expression("x + w"), cube(1), 0.25};
  description.objects.front().iso = {0.5};
  const BuiltScene built = build_scene(description, {});
  const RayTruth truth = make_reference(description, built)->solve({-2, 0, 0}, {1, 0, 0}, 0, 10);
  REQUIRE(truth.roots.size() == 1);
  CHECK(truth.roots[0].lo == Approx(2.25));
}

TEST_CASE("answers come back from disk as they were") {
  const test::TemporaryFolder folder;
  const Counted reference("one");
  const std::vector<ReferenceRay> rays = made_rays(100);
  const std::vector<RayTruth> computed = solve_all(reference, rays, {});
  CHECK(folder.entries() == 0);
  check_equal(solve_all(reference, rays, folder / "deep" / "cache"), computed);
  CHECK(reference.calls == 200);
  check_equal(solve_all(reference, rays, folder / "deep" / "cache"), computed);
  CHECK(reference.calls == 200);

  SECTION("another set of rays, or another reference, is another file") {
    check_equal(solve_all(reference, made_rays(99), folder / "deep" / "cache"),
                solve_all(reference, made_rays(99), {}));
    CHECK(reference.calls == 398);
    const Counted other("two");
    (void)solve_all(other, rays, folder / "deep" / "cache");
    CHECK(other.calls == 100);
  }
  SECTION("damaged files are computed anew and mended") {
    const auto file = std::filesystem::directory_iterator(folder / "deep" / "cache")->path();
    const std::string good = test::bytes_of(file);
    int calls = reference.calls;
    for (const std::size_t size :
         {good.size() - 1, good.size() / 2, std::size_t{40}, std::size_t{3}, std::size_t{0}}) {
      std::filesystem::resize_file(file, size);
      check_equal(solve_all(reference, rays, folder / "deep" / "cache"), computed);
      CHECK(reference.calls == (calls += 100));
      REQUIRE(test::bytes_of(file) == good);
    }
    for (const std::size_t at : {std::size_t{0}, std::size_t{50}, std::size_t{70}, good.size() - 1}) {
      std::string bad = good;
      bad[at] ^= 4;
      std::ofstream(file, std::ios::binary) << bad;
      check_equal(solve_all(reference, rays, folder / "deep" / "cache"), computed);
      CHECK(reference.calls == (calls += 100));
    }
  }
  SECTION("a folder that cannot be made keeps nothing") {
    std::ofstream(folder / "file") << "no folder";
    check_equal(solve_all(reference, rays, folder / "file" / "cache"), computed);
  }
}
