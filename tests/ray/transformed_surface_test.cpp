// A moved surface is the surface of the moved formula.
#include <isocast/implicit/expression/parse.h>
#include <isocast/implicit/implicit_surface.h>
#include <isocast/ray/transformed_surface.h>

#include <catch2/catch.hpp>
#include <random>

using namespace isocast;

namespace {

constexpr std::uint16_t kOwn = 3, kNumber = 9;

std::shared_ptr<const Surface> ellipsoid(const FormulaMethodChoice& method = {}) {
  ImplicitSurfaceOptions options;
  options.object = kOwn;
  options.method = method;
  return std::make_shared<ImplicitSurface>(parse_expression("x^2+y^2/4+z^2-1"),
                                           Domain{{-2.5, -2.5, -2.5}, {2.5, 2.5, 2.5}}, options);
}

Transform some_place() {
  Transform t;  // not orthogonal, mirrored
  const double m[3][4] = {{2, 0.5, 0, 10}, {0, -1, 0.25, -3}, {0.5, 0, 1.5, 4}};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) t.m[r][c] = m[r][c];
  return t;
}

struct Traced {
  RayStream rays;
  HitStream hits;
  TraceCounts counts;
};

// Rays towards the place from all around.
std::unique_ptr<Traced> rays_at(const Double3& middle) {
  auto traced = std::make_unique<Traced>();
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> across(-1, 1);
  RayStream& rays = traced->rays;
  rays.size = kStreamSize;
  rays.kind = RayKind::reflection;
  for (int i = 0; i < kStreamSize; ++i) {
    const Double3 o = middle + 9.0 * normalized({across(random), across(random), across(random)}),
                  p = middle + 2.0 * Double3{across(random), across(random), across(random)}, d = p - o;
    rays.ox[i] = o[0], rays.oy[i] = o[1], rays.oz[i] = o[2];
    rays.dx[i] = d[0], rays.dy[i] = d[1], rays.dz[i] = d[2];
    rays.t_min[i] = 0, rays.t_max[i] = Box::inf;
    rays.start_object[i] = kNoObject, rays.start_sides[i] = 0, rays.id[i] = 0;
  }
  clear(traced->hits);
  return traced;
}

}  // namespace

TEST_CASE("hits of a moved surface lie on it, in and out, with its normals") {
  const Transform place = some_place(), back = place.inverse();
  const TransformedSurface surface(ellipsoid(choose_formula_method("affine", {{"eps", "1e-6"}})), place, kOwn,
                                   kNumber);
  const auto traced = rays_at(place.point({0, 0, 0}));
  const auto& [rays, first, counts] = *traced;
  HitStream& hits = traced->hits;
  surface.first_hit(rays, hits, traced->counts);
  const auto dressed = std::make_unique<DressedHits>();
  int seen = 0, pairs = 0;
  double before[kStreamSize];
  for (int i = 0; i < kStreamSize; ++i) before[i] = hits.t[i];
  surface.dress(rays, hits, {.normal = true, .position = true, .value = true}, *dressed);
  for (int i = 0; i < kStreamSize; ++i) {
    if (!is_hit(hits, i)) continue;
    ++seen;
    CHECK(hits.object[i] == kNumber);
    CHECK(hits.sides[i] == 0);
    const Double3 p = {dressed->position[0][i], dressed->position[1][i], dressed->position[2][i]},
                  n = {dressed->normal[0][i], dressed->normal[1][i], dressed->normal[2][i]},
                  own = back.point(p),
                  gradient = back.transposed_vector({2 * own[0], own[1] / 2, 2 * own[2]});
    CHECK(std::abs(own[0] * own[0] + own[1] * own[1] / 4 + own[2] * own[2] - 1) < 1e-4);
    CHECK(dot(n, normalized(gradient)) > 0.9999);
    CHECK(dot(n, {rays.dx[i], rays.dy[i], rays.dz[i]}) < 0);
    CHECK(std::abs(dressed->value[i]) < 1e-4);
  }
  CHECK(seen > 100);
  surface.next_hit(rays, hits, traced->counts);
  for (int i = 0; i < kStreamSize; ++i)
    if (is_hit(hits, i)) pairs += hits.t[i] >= before[i] && hits.sides[i] == 1 && hits.object[i] == kNumber;
  CHECK(pairs > seen - 10);
  surface.next_hit(rays, hits, traced->counts);
  for (int i = 0; i < kStreamSize; ++i) CHECK(!is_hit(hits, i));
}

TEST_CASE("hits of other objects are left alone, and nearer ones kept") {
  const TransformedSurface surface(ellipsoid(), some_place(), kOwn, kNumber);
  const auto traced = rays_at(some_place().point({0, 0, 0}));
  HitStream& hits = traced->hits;
  for (int i = 0; i < kStreamSize; ++i) {
    hits.t[i] = i % 2 == 0 ? 1e-9 : 1e9;
    hits.object[i] = kOwn;  // another object with the number that the surface itself has
  }
  surface.first_hit(traced->rays, hits, traced->counts);
  int taken = 0;
  for (int i = 0; i < kStreamSize; ++i) {
    if (i % 2 == 0) CHECK(hits.object[i] == kOwn);
    else taken += hits.object[i] == kNumber;
  }
  CHECK(taken > 50);
  for (int i = 0; i < kStreamSize; ++i) hits.object[i] = kOwn, hits.t[i] = 5;
  surface.next_hit(traced->rays, hits, traced->counts);
  for (int i = 0; i < kStreamSize; ++i) CHECK(hits.t[i] == 5);
}

TEST_CASE("moved twice is moved once by both") {
  Transform shift;
  shift.m[0][3] = 100;
  const auto once = std::make_shared<TransformedSurface>(ellipsoid(), some_place(), kOwn, kNumber);
  const TransformedSurface twice(once, shift, kNumber, 1);
  const auto a = rays_at(some_place().point({0, 0, 0})),
             b = rays_at(some_place().point({0, 0, 0}) + Double3{100, 0, 0});
  once->first_hit(a->rays, a->hits, a->counts);
  twice.first_hit(b->rays, b->hits, b->counts);
  int hits = 0;
  for (int i = 0; i < kStreamSize; ++i) {
    if (!is_hit(a->hits, i)) continue;
    ++hits;
    CHECK(b->hits.t[i] == Approx(a->hits.t[i]).margin(1e-3));
    CHECK(b->hits.object[i] == 1);
  }
  CHECK(hits > 50);
  CHECK(twice.bounds().lo[0] == Approx(once->bounds().lo[0] + 100));
}

TEST_CASE("a moved surface proves what it proves of the ray in its own space") {
  const TransformedSurface surface(ellipsoid(choose_formula_method("certified", {})), some_place(), kOwn,
                                   kNumber);
  CHECK(surface.proves());
  const auto traced = rays_at(some_place().point({0, 0, 0}));
  HitStream& hits = traced->hits;
  for (Certificate& certificate : hits.certificate) certificate = Certificate::proved_miss;
  surface.first_hit(traced->rays, hits, traced->counts);
  int proved = 0, missed = 0;
  for (int i = 0; i < kStreamSize; ++i) {
    proved += hits.certificate[i] == Certificate::proved_hit;
    missed += !is_hit(hits, i) && hits.certificate[i] == Certificate::proved_miss;
    if (is_hit(hits, i)) CHECK(hits.t_lo[i] <= hits.t_hi[i]);
  }
  CHECK(proved > 100);
  CHECK(missed > 10);
}

TEST_CASE("a ray that starts on a moved surface knows it") {
  const TransformedSurface surface(ellipsoid(), some_place(), kOwn, kNumber);
  const auto traced = rays_at(some_place().point({0, 0, 0}));
  auto& [rays, hits, counts] = *traced;
  surface.first_hit(rays, hits, counts);
  int started = 0;
  for (int i = 0; i < kStreamSize; ++i) {
    const bool hit = is_hit(hits, i);
    started += hit;
    if (hit) {
      rays.ox[i] += hits.t_lo[i] * rays.dx[i], rays.oy[i] += hits.t_lo[i] * rays.dy[i];
      rays.oz[i] += hits.t_lo[i] * rays.dz[i];
      rays.dx[i] = -rays.dx[i], rays.dy[i] = -rays.dy[i],
      rays.dz[i] = -rays.dz[i];  // back to where it came from
      rays.start_object[i] = kNumber, rays.start_sides[i] = hits.sides[i];
    } else rays.t_min[i] = 1, rays.t_max[i] = 0;
  }
  bool any[kStreamSize] = {};
  surface.any_hit(rays, any, counts);
  int blocked = 0;
  for (const bool one : any) blocked += one;
  CHECK(started > 100);
  CHECK(blocked == 0);
}
