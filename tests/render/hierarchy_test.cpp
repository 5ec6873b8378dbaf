// Many objects: what the hierarchy finds is what asking each of them finds, whichever tree offers candidates.
#include <isocast/implicit/expression/parse.h>
#include <isocast/implicit/implicit_surface.h>
#include <isocast/ray/transformed_surface.h>
#include <isocast/scene/object_hierarchy.h>
#include <test_size.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <random>

using namespace isocast;

namespace {

std::shared_ptr<const Surface> ball(const Double3& center, double radius, std::uint16_t number) {
  static const std::shared_ptr<const Surface> unit = std::make_shared<ImplicitSurface>(
      parse_expression("x^2+y^2+z^2-1"), Domain{{-1.25, -1.25, -1.25}, {1.25, 1.25, 1.25}},
      ImplicitSurfaceOptions());
  Transform place;
  for (int a = 0; a < 3; ++a) place.m[a][a] = radius, place.m[a][3] = center[a];
  return std::make_shared<TransformedSurface>(unit, place, std::uint16_t{0}, number);
}

// Balls at random in a cube of this size around a point.
Scene balls(int count, const Double3& middle, double size) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> across(-0.5, 0.5);
  Scene scene;
  for (int n = 0; n < count; ++n) {
    const Double3 center = middle + size * Double3{across(random), across(random), across(random)};
    scene.objects.push_back({ball(center, 0.04 * size, static_cast<std::uint16_t>(n)), {Material()}});
  }
  return scene;
}

// Rays from around through the cube.
void fill(std::mt19937_64& random, const Double3& middle, double size, RayStream& rays) {
  std::uniform_real_distribution<double> across(-0.5, 0.5);
  rays.size = kStreamSize;
  rays.kind = RayKind::reflection;
  for (int i = 0; i < kStreamSize; ++i) {
    const Double3 o = middle + 3 * size * Double3{across(random), across(random), across(random)},
                  p = middle + size * Double3{across(random), across(random), across(random)}, d = p - o;
    rays.ox[i] = o[0], rays.oy[i] = o[1], rays.oz[i] = o[2];
    rays.dx[i] = d[0], rays.dy[i] = d[1], rays.dz[i] = d[2];
    rays.t_min[i] = 0, rays.t_max[i] = Box::inf;
    rays.start_object[i] = kNoObject, rays.start_sides[i] = 0, rays.id[i] = static_cast<std::uint32_t>(i);
  }
}

void check_alike(const HitStream& a, const HitStream& b, int size) {
  int differences = 0;
  for (int i = 0; i < size; ++i)
    differences += a.t[i] != b.t[i] || a.object[i] != b.object[i] || a.certificate[i] != b.certificate[i] ||
                   (is_hit(a, i) && (a.t_lo[i] != b.t_lo[i] || a.sides[i] != b.sides[i]));
  CHECK(differences == 0);
}

struct Place {
  Double3 middle;
  double size;
};

}  // namespace

TEST_CASE("no crossing of many objects is lost, at any place and scale, with each tree", "[property]") {
  const Place place = GENERATE(Place{{0, 0, 0}, 1}, Place{{1e6, -1e6, 1e6}, 1}, Place{{0, 0, 0}, 1e-30},
                               Place{{3e5, 0, 0}, 1e5});
  const Scene scene = balls(60, place.middle, place.size);
  std::mt19937_64 random(11);
  RayStream rays;
  const auto expected = std::make_unique<HitStream>(), found = std::make_unique<HitStream>();
  std::int64_t hits = 0;
  for (const char* const embree : {"0", "1"}) {
    setenv("ISOCAST_EMBREE", embree, 1);
    const ObjectHierarchy hierarchy(scene);
    for (int streams = test::cases(100000, 1000000) / kStreamSize / 8; streams >= 0; --streams) {
      fill(random, place.middle, place.size, rays);
      TraceCounts counts;
      clear(*expected), clear(*found);
      for (const SceneObject& object : scene.objects) object.surface->first_hit(rays, *expected, counts);
      hierarchy.first_hit(rays, {}, *found, counts);
      check_alike(*expected, *found, rays.size);
      bool any[kStreamSize] = {};
      hierarchy.any_hit(rays, any, counts);
      for (int i = 0; i < rays.size; ++i) {
        hits += is_hit(*expected, i);
        if (any[i] != is_hit(*expected, i)) FAIL("ray " << i);
      }
    }
  }
  unsetenv("ISOCAST_EMBREE");
  CHECK(hits > 500);
}

TEST_CASE("candidates are all whose boxes are met") {
  const Scene scene = balls(50, {0, 0, 0}, 1);
  const ObjectHierarchy hierarchy(scene);
  std::mt19937_64 random(3);
  RayStream rays;
  fill(random, {0, 0, 0}, 1, rays);
  std::vector<std::uint16_t> objects;
  hierarchy.find_candidates(rays, objects);
  CHECK(std::ranges::is_sorted(objects));
  const auto hits = std::make_unique<HitStream>();
  TraceCounts counts;
  int hit = 0;
  for (std::uint16_t n = 0; n < scene.objects.size(); ++n) {
    clear(*hits);
    scene.objects[n].surface->first_hit(rays, *hits, counts);
    bool any = false;
    for (int i = 0; i < rays.size; ++i) any = any || is_hit(*hits, i);
    hit += any;
    if (any) CHECK(std::ranges::binary_search(objects, n));
  }
  CHECK(hit > 10);
}

TEST_CASE("of equally near hits the object with the lowest number wins") {
  Scene scene;
  for (std::uint16_t n = 0; n < 3; ++n) scene.objects.push_back({ball({0, 0, 0}, 1, n), {Material()}});
  scene.objects.push_back({ball({0, 0, 5}, 1, 3), {Material()}});
  for (const char* const embree : {"0", "1"}) {
    setenv("ISOCAST_EMBREE", embree, 1);
    const ObjectHierarchy hierarchy(scene);
    RayStream rays;
    std::mt19937_64 random(5);
    fill(random, {0, 0, 0}, 0.5, rays);
    const auto hits = std::make_unique<HitStream>();
    TraceCounts counts;
    clear(*hits);
    const std::vector<std::uint8_t> skip = {1, 0, 0, 0};
    hierarchy.first_hit(rays, skip, *hits, counts);
    int seen = 0;
    for (int i = 0; i < rays.size; ++i) {
      if (!is_hit(*hits, i)) continue;
      ++seen;
      CHECK((hits->object[i] == 1 || hits->object[i] == 3));
    }
    CHECK(seen > 100);
  }
  unsetenv("ISOCAST_EMBREE");
}
