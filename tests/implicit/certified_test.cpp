// The method certified: its trees of beams against rays that are solved each for itself, and against the
// reference.
#include <implicit/framed_rays.h>
#include <implicit/random_camera.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/expression/parse.h>
#include <isocast/implicit/implicit_surface.h>
#include <test_size.h>
#include <volume/rays.h>

#include <catch2/catch.hpp>
#include <vector>

using namespace isocast;
using namespace isocast::test;
using reference::FormulaReference, reference::FormulaRoots;

namespace {

const Domain kBox = {{-2, -2, -2}, {2, 2, 2}};
// Pruned part by part.
constexpr const char* kSpheres =
    "min(min(min(x^2+y^2+z^2-0.1,(x-1)^2+y^2+z^2-0.1),min((x+1)^2+y^2+z^2-0.2,x^2+(y-1)^2+z^2-0.2)),"
    "min(min(x^2+(y+1)^2+z^2-0.1,x^2+y^2+(z-1)^2-0.1),min(x^2+y^2+(z+1)^2-0.3,(x-1)^2+(y-1)^2+z^2-0.3)))";
constexpr double kEps = 0x1p-10;

ImplicitSurface surface_of(const Expression& expression, const Domain& domain, const char* method,
                           bool precise, std::vector<double> iso = {0}, Isa isa = widest_isa(),
                           const char* eps_rel = "0.0009765625") {
  ImplicitSurfaceOptions options;
  options.iso = std::move(iso);
  options.method = choose_formula_method(method, {{"eps-rel", eps_rel}});
  options.double_precision = precise;
  options.isa = isa;
  return ImplicitSurface(expression, domain, options);
}

std::vector<HitStream> picture_of(const Surface& surface, const View& view) {
  std::vector<HitStream> tiles;
  each_tile_of_pass(surface, view, [&](const RayStream&, const HitStream& hits) { tiles.push_back(hits); });
  return tiles;
}

}  // namespace

TEST_CASE("trees of beams prove what single rays prove", "[property]") {
  std::mt19937_64 random(12);
  std::int64_t hits_seen = 0, compared = 0, rays_seen = 0;
  for (std::int64_t n = 0, count = cases(54, 2000); n < count; ++n) {
    const char* formulas[] = {"x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8",
                              "sin(4*x)+sin(4*y)+sin(4*z)",
                              "min(x^2+y^2+z^2-1, abs(x-1)+y^2-0.1)",
                              "1/x + y*z",
                              "sqrt(x-0.5) - y*z",
                              "exp(-4*(x^2+y^2)) - z^2",
                              "x - 0.3*y",
                              "floor(3*x) - y",
                              kSpheres};
    const Expression formula = parse_expression(formulas[n % 9]);
    const bool precise = n / 9 % 2 == 0;
    const std::vector<double> iso = n % 3 == 0 ? std::vector<double>{0} : std::vector<double>{0, 0.3};
    INFO(formulas[n % 9] << (precise ? " double" : " float"));
    const ImplicitSurface tree = surface_of(formula, kBox, "certified", precise, iso),
                          alone = surface_of(formula, kBox, "affine", precise, iso);
    // not whole tiles, and more than a block; the polynomial as large as forms ask for
    const bool large = tree.takes_forms();
    const View view(random_camera(random), large || n % 4 == 0 ? 140 : 45, large ? 140 : 37);
    const std::vector<HitStream> a = picture_of(tree, view);
    for (const Isa isa : available_isas()) {
      const std::vector<HitStream> same =
          picture_of(surface_of(formula, kBox, "certified", precise, iso, isa), view);
      for (std::size_t tile = 0; tile < a.size(); ++tile) require_same_bits(a[tile], same[tile], kStreamSize);
    }
    std::size_t tile = 0;
    each_tile_of_pass(tree, view, [&](const RayStream& rays, const HitStream&) {
      RayStream others = rays;
      others.kind = RayKind::reflection;
      const HitStream b = first_hits(alone, others), &h = a[tile++];
      for (int i = 0; i < rays.size; ++i) {
        if (!is_ray(rays, i)) {
          REQUIRE_FALSE(is_hit(h, i));
          continue;
        }
        ++rays_seen;
        if (h.certificate[i] == Certificate::undecided || b.certificate[i] == Certificate::undecided)
          continue;
        ++compared;
        INFO(std::hexfloat << rays.ox[i] << " " << rays.oy[i] << " " << rays.oz[i] << " towards "
                           << rays.dx[i] << " " << rays.dy[i] << " " << rays.dz[i]);
        REQUIRE(h.certificate[i] == b.certificate[i]);
        if (!is_hit(h, i)) continue;
        ++hits_seen;
        REQUIRE(h.t_lo[i] <= h.t[i]);
        REQUIRE(h.t[i] <= h.t_hi[i]);
        // in single precision the end is put off where roundings hide f's side: a ray in a million has 1.5
        // eps
        REQUIRE(h.t_hi[i] - h.t_lo[i] <= (1 + 1e-3) * 4 * kEps * (precise ? 1 : 2));
        REQUIRE(h.t_lo[i] <= b.t_hi[i]);
        REQUIRE(b.t_lo[i] <= h.t_hi[i]);
        REQUIRE(h.iso[i] == b.iso[i]);
        REQUIRE(h.sides[i] == b.sides[i]);
      }
    });
  }
  CHECK(compared > 0.9 * static_cast<double>(rays_seen));
  CHECK(hits_seen > 10000);
}

TEST_CASE("certified pictures of the catalogue agree with the reference", "[property]") {
  const int size = static_cast<int>(cases(14, 96));
  for (const CatalogueSurface& surface : catalogue()) {
    const Expression expression = surface_expression(surface);
    const FormulaReference reference(expression, 0, 0);
    for (const bool precise : {false, true}) {
      INFO(surface.id << (precise ? " double" : " float"));
      const ImplicitSurface certified = surface_of(expression, surface.domain, "certified", precise);
      const Box box = certified.bounds();
      const Double3 edges = box.hi - box.lo;
      // as large as forms ask for, with as many rays
      const int side = certified.takes_forms() ? 200 : size, every = side * side / (size * size);
      int n = 0;
      each_tile_of_pass(
          certified, View(frame(box, {}, 1), side, side), [&](const RayStream& rays, const HitStream& hits) {
            for (int i = 0; i < rays.size; ++i) {
              if (n++ % every != 0) continue;
              if (!is_ray(rays, i) || hits.certificate[i] == Certificate::undecided) continue;
              const Double3 o = origin_of(rays, i), d = direction_of(rays, i);
              const Reach range = range_inside(box, o, d);
              if (range.empty()) {
                REQUIRE_FALSE(is_hit(hits, i));
                continue;
              }
              reference::ReferenceOptions options;
              options.max_roots = 1;
              const FormulaRoots truth = reference.solve(o, d, range.lo, range.hi, options);
              if (!truth.decided()) continue;
              INFO(std::hexfloat << o[0] << " " << o[1] << " " << o[2] << " towards " << d[0] << " " << d[1]
                                 << " " << d[2]);
              if (!is_hit(hits, i)) {
                REQUIRE(truth.roots.empty());
                continue;
              }
              if (!range.holds(hits.t_lo[i], hits.t_hi[i])) continue;
              REQUIRE_FALSE(truth.roots.empty());
              REQUIRE(truth.roots[0].hi >= hits.t_lo[i]);
              REQUIRE(truth.roots[0].lo <= hits.t_hi[i]);
              REQUIRE(std::abs(hits.t[i] - truth.roots[0].lo) <= 2 * kEps * std::ranges::max(edges));
            }
          });
    }
  }
}

// Rays from anywhere near a box, half of them from inside.
std::unique_ptr<Streams> rays_near(const Box& box, std::mt19937_64& random, int size) {
  std::uniform_real_distribution<double> unit(-1, 1);
  auto s = make_streams();
  for (int i = 0; i < size; ++i) {
    Double3 o, target;
    for (int a = 0; a < 3; ++a) {
      const double half = 0.5 * (box.hi[a] - box.lo[a]), middle = box.center()[a];
      o[a] = middle + half * unit(random) * (i % 2 ? 1 : 3);
      target[a] = middle + half * unit(random);
    }
    add_ray(s->rays, o, target - o);
  }
  return s;
}

TEST_CASE("other rays of certified cross what the reference crosses, one after the other", "[property]") {
  std::mt19937_64 random(21);
  const int size = static_cast<int>(cases(24, kStreamSize));
  std::int64_t crossings = 0, rays_seen = 0, open = 0;
  for (const CatalogueSurface& surface : catalogue()) {
    const Expression expression = surface_expression(surface);
    if (!surface_of(expression, surface.domain, "certified", false).takes_forms()) continue;
    const FormulaReference reference(expression, 0, 0);
    for (const bool precise : {false, true}) {
      INFO(surface.id << (precise ? " double" : " float"));
      const ImplicitSurface certified = surface_of(expression, surface.domain, "certified", precise);
      const auto s = rays_near(certified.bounds(), random, size);
      constexpr int kMostHits = 12;
      std::vector<HitStream> chain(1, first_hits(certified, s->rays));
      TraceCounts counts;
      while (chain.size() < kMostHits) {
        chain.push_back(chain.back());
        certified.next_hit(s->rays, chain.back(), counts);
      }
      for (const Isa isa : available_isas()) {
        const ImplicitSurface other = surface_of(expression, surface.domain, "certified", precise, {0}, isa);
        HitStream hits = first_hits(other, s->rays);
        for (const HitStream& expected : chain) {
          if (&expected != chain.data()) other.next_hit(s->rays, hits, counts);
          require_same_bits(expected, hits, size);
        }
      }
      for (int i = 0; i < size; ++i) {
        const Double3 o = origin_of(s->rays, i), d = direction_of(s->rays, i);
        const Reach range = range_inside(certified.bounds(), o, d);
        if (range.empty()) continue;
        const FormulaRoots truth = reference.solve(o, d, range.lo, range.hi, {});
        if (!truth.decided()) continue;
        ++rays_seen;
        INFO(std::hexfloat << o[0] << " " << o[1] << " " << o[2] << " towards " << d[0] << " " << d[1] << " "
                           << d[2]);
        std::size_t root = 0;
        for (const HitStream& hits : chain) {
          if (hits.certificate[i] == Certificate::undecided) {
            ++open;
            break;
          }
          if (!is_hit(hits, i)) {
            REQUIRE(root == truth.roots.size());
            break;
          }
          if (!range.holds(hits.t_lo[i], hits.t_hi[i])) break;
          REQUIRE(root < truth.roots.size());
          REQUIRE(truth.roots[root].hi >= hits.t_lo[i]);
          REQUIRE(truth.roots[root].lo <= hits.t_hi[i]);
          ++root, ++crossings;
        }
      }
    }
  }
  CHECK(crossings > rays_seen);
  CHECK(open < 0.02 * static_cast<double>(rays_seen));
}

TEST_CASE("rays whose parts are trimmed to their beginnings come to an end") {
  const CatalogueSurface& chmutov = *std::ranges::find(catalogue(), "chmutov_18", &CatalogueSurface::id);
  const ImplicitSurface certified = surface_of(surface_expression(chmutov), chmutov.domain, "certified",
                                               false, {0}, widest_isa(), "0.00048828125");
  int hits_seen = 0;
  for (int n = 0; n < 20; ++n) {
    CameraWishes wishes;
    wishes.position = {3 + 0.01 * n, -4, 2};
    for (const HitStream& hits : picture_of(certified, View(frame(certified.bounds(), wishes, 1), 8, 8)))
      for (int i = 0; i < kStreamSize; ++i) hits_seen += is_hit(hits, i);
  }
  CHECK(hits_seen > 200);
}

TEST_CASE("the picture of a polynomial does not depend on the size of its values") {
  const std::string curved = "((x-0.13)^2+(y+0.07)^2-0.0004)*(z+3)";
  const auto hits_of = [&](const std::string& factor) {
    const Domain domain = {{-1, -1, -1}, {1, 1, 1}};
    const ImplicitSurface surface =
        surface_of(parse_expression(factor + "*" + curved), domain, "certified", true);
    std::int64_t found[2] = {};
    for (const HitStream& tile : picture_of(surface, View(frame(surface.bounds(), {}, 1), 512, 512)))
      for (int i = 0; i < kStreamSize; ++i) {
        found[0] += is_hit(tile, i);
        found[1] += tile.certificate[i] == Certificate::undecided;
      }
    return std::pair(found[0], found[1]);
  };
  const auto [hits, undecided] = hits_of("1");
  CHECK(hits > 1400);
  CHECK(undecided == 0);
  for (const char* factor : {"1e-140", "1e-165", "1e-200", "1e160"}) {
    INFO(factor);
    CHECK(hits_of(factor) == std::pair(hits, undecided));
  }
}

TEST_CASE("a block that nobody wants is not searched") {
  const ImplicitSurface certified =
      surface_of(parse_expression("sin(20*x)*sin(20*y)-z"), kBox, "certified", false);
  const View view(frame(certified.bounds(), {}, 1), 128, 128);
  const std::unique_ptr<PrimaryPass> pass = certified.primary(view);
  const auto block = std::make_unique<BlockHits>();
  const auto evaluations = [&](std::stop_token stop) {
    TraceCounts counts;
    block->reset(true, std::move(stop));
    pass->first_hits(0, 0, 0.5, 0.5, *block, counts);
    return counts.evaluations;
  };
  std::stop_source stop;
  CHECK(evaluations(stop.get_token()) > 1000);
  stop.request_stop();
  CHECK(evaluations(stop.get_token()) == 0);
}
