// Solids cut surfaces at their crossings: held against the reference's roots and the solid's formula there.
#include <implicit/framed_rays.h>
#include <isocast/implicit/expression/parse.h>
#include <isocast/implicit/formula_region.h>
#include <isocast/implicit/implicit_surface.h>
#include <isocast/ray/clipped_surface.h>
#include <test_size.h>

#include <catch2/catch.hpp>
#include <vector>

using namespace isocast;
using namespace isocast::test;

namespace {

const Domain kBox = {{-2, -2, -2}, {2, 2, 2}};

ClippedSurface clipped(const std::string& formula, const std::vector<std::string>& solids,
                       const char* method = "affine") {
  ImplicitSurfaceOptions options;
  options.method = choose_formula_method(method, {});
  options.double_precision = true;
  std::vector<std::shared_ptr<const Region>> regions;
  for (const std::string& solid : solids)
    regions.push_back(std::make_shared<FormulaRegion>(parse_expression(solid)));
  return {std::make_shared<ImplicitSurface>(parse_expression(formula), kBox, options), regions, 0};
}

RayStream one_ray(const Double3& o, const Double3& d) {
  RayStream rays = {};
  rays.size = 1;
  rays.ox[0] = o[0], rays.oy[0] = o[1], rays.oz[0] = o[2];
  rays.dx[0] = d[0], rays.dy[0] = d[1], rays.dz[0] = d[2];
  rays.t_max[0] = std::numeric_limits<double>::infinity();
  rays.start_object[0] = kNoObject;
  return rays;
}

// What a crossing is: where, and whether the solid holds it, as far as double precision can tell.
struct Crossing {
  double lo, hi;
  bool inside, unclear;
};

}  // namespace

TEST_CASE("a clipped sphere shows the first crossing that its solids hold") {
  const RayStream rays = one_ray({3, 0, 0}, {-1, 0, 0});
  const char* sphere = "x^2+y^2+z^2-1";
  const auto first = [&](const std::vector<std::string>& solids) {
    return first_hits(clipped(sphere, solids), rays);
  };
  SECTION("the front") {
    const HitStream hits = first({"0.5-x"});
    CHECK(hits.t[0] == Approx(2));
    CHECK(hits.certificate[0] == Certificate::proved_hit);
  }
  SECTION("the back, seen through the cut") {
    const HitStream hits = first({"x-0.5", "-1.5-x"});
    CHECK(hits.t[0] == Approx(4));
    CHECK(hits.certificate[0] == Certificate::proved_hit);
    CHECK(hits.sides[0] == 1);
  }
  SECTION("nothing") {
    for (const std::vector<std::string>& solids :
         {std::vector<std::string>{"x-0.5", "0.5-x"}, {"x^2+1"}, {"sqrt(-1-x^2)"}}) {
      const HitStream hits = first(solids);
      CHECK_FALSE(is_hit(hits, 0));
      CHECK(hits.certificate[0] == Certificate::proved_miss);
    }
  }
  SECTION("a border through the crossing proves nothing") {
    const HitStream hits = first({"x-1"});
    CHECK(hits.certificate[0] == Certificate::undecided);
  }
  SECTION("a nearer hit of another object stays") {
    HitStream hits;
    clear(hits);
    hits.t[0] = 3, hits.object[0] = 7, hits.certificate[0] = Certificate::proved_hit;
    TraceCounts counts;
    clipped(sphere, {"x-0.5"}).first_hit(rays, hits, counts);
    CHECK(hits.t[0] == 3);
    CHECK(hits.object[0] == 7);
    clipped(sphere, {"x-0.5"}).next_hit(rays, hits, counts);
    CHECK(hits.t[0] == 3);
  }
}

TEST_CASE("clipped crossings are the reference's that lie in the solid, in order", "[property]") {
  const std::string gyroid = "sin(3*x)*cos(3*y)+sin(3*y)*cos(3*z)+sin(3*z)*cos(3*x)",
                    ball = "x^2+y^2+z^2-1.7", slab = "abs(x+y)-1";
  const reference::FormulaReference truth(parse_expression(gyroid));
  const ClippedSurface surface = clipped(gyroid, {ball, slab});
  int checked = 0, undecided = 0;
  each_tile(surface.bounds(), static_cast<int>(cases(64, 256)), [&](const RayStream& rays) {
    HitStream hits = first_hits(surface, rays);
    std::vector<std::vector<Crossing>> all(kStreamSize);
    bool known[kStreamSize] = {};
    for (int i = 0; i < rays.size; ++i) {
      const Double3 o = origin_of(rays, i), d = direction_of(rays, i);
      const Reach range = range_inside(surface.bounds(), o, d);
      if (!is_ray(rays, i) || range.empty()) continue;
      const reference::FormulaRoots roots = truth.solve(o, d, range.lo, range.hi);
      known[i] = roots.decided();
      for (const reference::FormulaRoot& root : roots.roots) {
        const Double3 p = o + root.lo * d;
        const double g = std::max(dot(p, p) - 1.7, std::abs(p[0] + p[1]) - 1);
        all[static_cast<std::size_t>(i)].push_back({root.lo, root.hi, g <= 0, std::abs(g) < 1e-3});
      }
    }
    // the first hit, then what lies behind each
    for (std::size_t step = 0; step < 3; ++step) {
      for (int i = 0; i < rays.size; ++i) {
        if (!known[i]) continue;
        std::vector<Crossing>& crossings = all[static_cast<std::size_t>(i)];
        const auto first = std::ranges::find_if(crossings, [](const Crossing& c) { return c.inside; });
        const auto unclear = std::ranges::find_if(crossings, [](const Crossing& c) { return c.unclear; });
        ++checked;
        if (hits.certificate[i] == Certificate::undecided || unclear != crossings.end()) {
          ++undecided;
          known[i] = false;
          continue;
        }
        REQUIRE(is_hit(hits, i) == (first != crossings.end()));
        if (!is_hit(hits, i)) {
          if (step == 0) REQUIRE(hits.certificate[i] == Certificate::proved_miss);
          known[i] = false;
          continue;
        }
        REQUIRE(hits.certificate[i] == Certificate::proved_hit);
        REQUIRE(hits.t_lo[i] <= first->hi);
        REQUIRE(hits.t_hi[i] >= first->lo);
        crossings.erase(crossings.begin(), first + 1);
      }
      TraceCounts counts;
      surface.next_hit(rays, hits, counts);
    }
  });
  CHECK(checked > 1500);
  CHECK(undecided < 0.05 * checked);
}
