// Solids cut surfaces at their crossings: held against the reference's roots and the solid's formula there.
#include <fmt/format.h>
#include <implicit/framed_rays.h>
#include <implicit/random_camera.h>
#include <isocast/implicit/expression/parse.h>
#include <isocast/implicit/expression/simplify.h>
#include <isocast/implicit/formula_region.h>
#include <isocast/implicit/implicit_surface.h>
#include <isocast/ray/clipped_surface.h>
#include <test_size.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
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

namespace {

// A solid that only tells where hits lie.
class Plain final : public Region {
 public:
  explicit Plain(std::shared_ptr<const Region> solid) : solid_(std::move(solid)) {}
  void locate(const RayStream& rays, const HitStream& hits, Place (&places)[kStreamSize]) const override {
    solid_->locate(rays, hits, places);
  }

 private:
  std::shared_ptr<const Region> solid_;
};

}  // namespace

TEST_CASE("rays that are cut to planes and balls first show what they show otherwise, for less",
          "[property]") {
  const char* const kTangle = "x^4-5*x^2+y^4-5*y^2+z^4-5*z^2+11.8";
  const std::vector<std::vector<std::string>> solids = {{"x+0.3*y-0.1"},
                                                        {"x^2+y^2+z^2-4.5"},
                                                        {"0.2-z", "(x-1)^2+y^2+(z-1)^2-3"},
                                                        {"0.3-x", "x-0.1"},
                                                        {"1-x^2-y^2-z^2"}};
  for (const char* method : {"frustum-lr", "affine", "mitchell"}) {
    ImplicitSurfaceOptions options;
    options.method = choose_formula_method(method, {});
    options.double_precision = true;
    const auto tangle = std::make_shared<ImplicitSurface>(parse_expression(kTangle), kBox, options);
    for (std::size_t k = 0; k < solids.size(); ++k) {
      std::vector<std::shared_ptr<const Region>> cutting, plain;
      for (const std::string& solid : solids[k]) {
        cutting.push_back(std::make_shared<FormulaRegion>(parse_expression(solid)));
        plain.push_back(std::make_shared<Plain>(cutting.back()));
      }
      const ClippedSurface cut(tangle, cutting, 0), whole(tangle, plain, 0);
      INFO(method << " in solids " << k);
      int hit = 0, open = 0, rays_seen = 0;
      TraceCounts cut_work, whole_work;
      each_tile(tangle->bounds(), static_cast<int>(cases(48, 256)), [&](const RayStream& rays) {
        HitStream a, b;
        for (HitStream* const hits : {&a, &b}) {
          clear(*hits);
          std::ranges::fill(hits->certificate, Certificate::proved_miss);
        }
        cut.first_hit(rays, a, cut_work);
        whole.first_hit(rays, b, whole_work);
        for (int step = 0; step < 2; ++step) {
          for (int i = 0; i < rays.size; ++i) {
            ++rays_seen;
            if (a.certificate[i] == Certificate::undecided || b.certificate[i] == Certificate::undecided) {
              ++open;
              forget(a, i), forget(b, i);
              continue;
            }
            INFO("ray " << i << ", crossing " << step);
            REQUIRE(is_hit(a, i) == is_hit(b, i));
            if (!is_hit(a, i)) continue;
            ++hit;
            REQUIRE(a.t_lo[i] <= b.t_hi[i]);
            REQUIRE(b.t_lo[i] <= a.t_hi[i]);
            REQUIRE(a.sides[i] == b.sides[i]);
          }
          cut.next_hit(rays, a, cut_work);
          whole.next_hit(rays, b, whole_work);
        }
      });
      CHECK(open <= 0.01 * rays_seen);
      if (k == 3) CHECK(cut_work.evaluations == 0);
      else CHECK(hit > 150);
      if (k < 4) CHECK(cut_work.evaluations < whole_work.evaluations);
      else CHECK(cut_work.evaluations == whole_work.evaluations);
    }
  }
}

TEST_CASE("the part of a line in a quadric holds all that lies in it, and little more") {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto quadric = [](const std::string& text) {
    return Quadric::of(make_tape(simplify(parse_expression(text))), 0);
  };
  for (const char* text : {"x*y*z", "sin(x)", "x^3", "1/x", "sqrt(x)"}) CHECK_FALSE(quadric(text));
  CHECK_FALSE(quadric("1e308*(x^2+y^2+z^2)*10"));
  for (int n = 0; n < 20000; ++n) {
    const auto number = [&] { return unit(random) * std::ldexp(1.0, static_cast<int>(random() % 20) - 10); };
    const Double3 o = {number(), number(), number()}, center = {number(), number(), number()};
    Double3 d = {unit(random), unit(random), unit(random)};
    for (double& x : d)
      if (random() % 6 == 0) x = 0;
    const double r = std::abs(number());
    const bool ball = n % 2 == 0;
    const auto text =
        ball ? fmt::format("(x-({}))^2+(y-({}))^2+(z-({}))^2-{}", center[0], center[1], center[2], r * r)
             : fmt::format("({})*x+({})*y+({})*z-({})", center[0], center[1], center[2], r);
    const auto solid = quadric(text);
    REQUIRE(solid);
    const LinePart part = solid->inside(o, d);
    INFO(text << " from " << o[0] << " " << o[1] << " " << o[2] << " along " << d[0] << " " << d[1] << " "
              << d[2]);
    const auto value = [&](double t) {
      const Double3 p = o + t * d, q = p - center;
      return ball ? dot(q, q) - r * r : dot(center, p) - r;
    };
    const auto clearly = [&](double t) {
      const Double3 p = o + t * d;
      return 1e-12 * (dot(p, p) + dot(center, center) + r * r + length(center) * length(p) + r);
    };
    if (part.lo <= part.hi && dot(d, d) > 0) {
      // just beyond the ends it is outside, and just before them it is not by much
      for (const double end : {part.lo, part.hi})
        if (std::abs(end) < 1e6)
          REQUIRE(std::abs(value(end)) <= 1e5 * clearly(end) + 1e-9 * std::abs(end) * dot(d, d));
    }
    for (int k = 0; k < 8; ++k) {
      const double t = number();
      if (value(t) < -clearly(t)) {
        REQUIRE(part.lo <= t);
        REQUIRE(t <= part.hi);
      }
    }
  }
}

TEST_CASE("pictures of clipped surfaces are those of their rays", "[property]") {
  std::mt19937_64 random(41);
  std::int64_t hits_seen = 0, cut = 0, pictures = 0;
  const std::int64_t count = cases(24, 1000);
  for (std::int64_t n = 0; n < count; ++n) {
    const char* methods[] = {"certified", "frustum-lr", "beam-adaptive"};
    const char* method = methods[n % 3];
    const std::vector<std::string> solids = n % 2 == 0 ? std::vector<std::string>{"x+0.3*y-0.2"}
                                                       : std::vector<std::string>{"x^4+y^4+z^4-2", "-z-1"};
    const ClippedSurface surface = clipped("x^4-5*x^2+y^4-5*y^2+z^4-5*z^2+11.8", solids, method);
    INFO(method << " " << solids[0]);
    // large enough for forms, mostly
    const View view(random_camera(random), 150, 130);
    if (!surface.primary(view)) continue;
    ++pictures;
    each_tile_of_pass(surface, view, [&](const RayStream& rays, const HitStream& a) {
      RayStream others = rays;
      others.kind = RayKind::reflection;
      const HitStream b = first_hits(surface, others);
      for (int i = 0; i < rays.size; ++i) {
        if (!is_ray(rays, i)) continue;
        if (a.certificate[i] == Certificate::undecided || b.certificate[i] == Certificate::undecided)
          continue;
        REQUIRE(a.certificate[i] == b.certificate[i]);
        cut += !is_hit(a, i);
        if (!is_hit(a, i)) continue;
        ++hits_seen;
        REQUIRE(a.t_lo[i] <= b.t_hi[i]);
        REQUIRE(b.t_lo[i] <= a.t_hi[i]);
        REQUIRE(a.sides[i] == b.sides[i]);
      }
    });
  }
  CHECK(hits_seen > 1000);
  CHECK(cut > 1000);
  CHECK(4 * pictures > 3 * count);
}
