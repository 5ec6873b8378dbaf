// Boxes, straight and turned, against their planes.
#include <isocast/ray/box_surface.h>

#include <catch2/catch.hpp>
#include <memory>

#include "ray_maker.h"

using namespace isocast;
using namespace isocast::test;

namespace {

struct Found {
  std::unique_ptr<HitStream> hits = std::make_unique<HitStream>();
  TraceCounts counts;
};
Found first(const Surface& surface, const RayStream& rays) {
  Found found;
  clear(*found.hits);
  for (Certificate& c : found.hits->certificate) c = Certificate::proved_miss;
  surface.first_hit(rays, *found.hits, found.counts);
  return found;
}

}  // namespace

TEST_CASE("a ray enters and leaves a box, and tells its faces") {
  const BoxSurface box({{-1, -2, -3}, {1, 2, 3}}, 4);
  const auto rays = one_ray({-5, 0.5, 0}, {2, 0, 0});
  Found found = first(box, *rays);
  HitStream& hits = *found.hits;
  CHECK(hits.t[0] == Approx(2));
  CHECK(hits.sides[0] == 0);
  CHECK(hits.object[0] == 4);
  CHECK(hits.certificate[0] == Certificate::proved_hit);
  CHECK(hits.t_lo[0] < hits.t[0]);
  DressedHits dressed;
  box.dress(*rays, hits, {true, true, true}, dressed);
  CHECK(dressed.normal[0][0] == -1);
  CHECK(dressed.position[1][0] == 0.5);
  box.next_hit(*rays, hits, found.counts);
  CHECK(hits.t[0] == Approx(3));
  CHECK(hits.sides[0] == 1);
  box.next_hit(*rays, hits, found.counts);
  CHECK_FALSE(is_hit(hits, 0));
}

TEST_CASE("a ray from inside leaves, one beside it misses, one along a face is undecided") {
  const BoxSurface box({{-1, -1, -1}, {1, 1, 1}}, 0);
  CHECK(first(box, *one_ray({0, 0, 0}, {0, 0, 1})).hits->t[0] == Approx(1));
  const Found beside = first(box, *one_ray({-5, 1.01, 0}, {1, 0, 0}));
  CHECK_FALSE(is_hit(*beside.hits, 0));
  CHECK(beside.hits->certificate[0] == Certificate::proved_miss);
  CHECK(first(box, *one_ray({-5, 1, 0}, {1, 0, 0})).hits->certificate[0] == Certificate::undecided);
  CHECK(first(box, *one_ray({-5, 0, 1}, {1, 1, 0})).hits->certificate[0] == Certificate::undecided);
}

TEST_CASE("a ray that starts on a face knows its side") {
  const BoxSurface box({{-1, -1, -1}, {1, 1, 1}}, 3);
  for (const double off : {-1e-12, 0.0, 1e-12}) {
    const auto from = [&](const Double3& d, bool inside) {
      auto rays = one_ray({1 + off, 0.2, 0.1}, d);
      rays->start_object[0] = 3;
      rays->start_sides[0] = inside;
      return first(box, *rays).hits->t[0];
    };
    CHECK_FALSE(from({1, 0, 0}, false) < Box::inf);
    CHECK(from({-1, 0, 0}, true) == Approx(2));
  }
}

TEST_CASE("a turned box is met where its planes are") {
  Transform world_from_box;
  const double c = 0.6, s = 0.8;
  const double rows[3][4] = {{2 * c, -s, 0, 5}, {2 * s, c, 0, -7}, {0, 0, 3, 11}};
  for (int r = 0; r < 3; ++r)
    for (int k = 0; k < 4; ++k) world_from_box.m[r][k] = rows[r][k];
  const BoxSurface box({{-1, -1, -1}, {1, 1, 1}}, world_from_box, 0);
  std::mt19937 random(5);
  int hit = 0;
  for (int round = 0; round < 40; ++round) {
    const auto rays = random_rays(random, {5, -7, 11}, 6);
    const Found found = first(box, *rays);
    for (int i = 0; i < rays->size; ++i) {
      // the slabs of the box's own axes
      const Double3 axes[3] = {{c, s, 0}, {-s, c, 0}, {0, 0, 1}};
      const double halves[3] = {2, 1, 3};
      const Double3 o = at(*rays, i, 0) - Double3{5, -7, 11}, d = at(*rays, i, 1) - at(*rays, i, 0);
      double near = -Box::inf, far = Box::inf;
      for (int a = 0; a < 3; ++a) {
        const double p = dot(o, axes[a]), v = dot(d, axes[a]);
        near = std::max(near, (-halves[a] * (v > 0 ? 1 : -1) - p) / v);
        far = std::min(far, (halves[a] * (v > 0 ? 1 : -1) - p) / v);
      }
      const double expected = near > far || far < 0 ? Box::inf : near > 0 ? near : far;
      if (std::abs(near - far) < 1e-9) continue;
      CHECK(is_hit(*found.hits, i) == (expected < Box::inf));
      if (!is_hit(*found.hits, i)) continue;
      ++hit;
      CHECK(found.hits->t[i] == Approx(expected));
      CHECK(found.hits->t_lo[i] <= expected);
      CHECK(found.hits->t_hi[i] >= expected);
    }
  }
  CHECK(hit > 2000);
}
