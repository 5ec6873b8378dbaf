// Triangles: no ray slips through an edge or a corner, none crosses twice, wherever the mesh lies and however
// small it is; the same bits with each instruction set and each tree.
#include <isocast/scene/mesh/mesh_surface.h>
#include <test_size.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <cstring>
#include <map>
#include <random>

using namespace isocast;

namespace {

// A ball of triangles: an octahedron, every triangle cut in four, again and again.
Mesh ball(int levels, const Double3& middle, double radius) {
  Mesh mesh;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto between = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, fresh] =
          middles.try_emplace(std::minmax(a, b), std::uint32_t(mesh.positions.size()));
      if (fresh) mesh.positions.push_back(normalized(mesh.positions[a] + mesh.positions[b]));
      return found->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = between(a, b), bc = between(b, c), ca = between(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = finer;
  }
  for (Double3& p : mesh.positions) p = middle + radius * p;
  return mesh;
}

// Rays from outside into the ball, at corners, middles of edges, and anywhere.
void aim(std::mt19937_64& random, const Mesh& mesh, const Double3& middle, double radius, RayStream& rays) {
  std::uniform_real_distribution<double> across(-1, 1);
  rays.size = kStreamSize;
  rays.kind = RayKind::reflection;
  for (int i = 0; i < kStreamSize; ++i) {
    const auto& triangle = mesh.triangles[random() % mesh.triangles.size()];
    const Double3 &a = mesh.positions[triangle[0]], &b = mesh.positions[triangle[1]];
    Double3 at = a;
    if (i % 3 == 1) at = 0.5 * (a + b);
    if (i % 3 == 2) at = middle + 0.9 * radius * normalized({across(random), across(random), across(random)});
    // every fourth ray runs along an axis
    Double3 from = middle + 3 * radius * normalized({across(random), across(random), across(random)});
    if (i % 4 == 0) from = at, from[std::size_t(i / 4 % 3)] += 4 * radius;
    const Double3 d = at - from;
    rays.ox[i] = from[0], rays.oy[i] = from[1], rays.oz[i] = from[2];
    rays.dx[i] = d[0], rays.dy[i] = d[1], rays.dz[i] = d[2];
    rays.t_min[i] = 0, rays.t_max[i] = Box::inf;
    rays.start_object[i] = kNoObject, rays.start_sides[i] = 0;
  }
}

struct Place {
  Double3 middle;
  double radius;
};

}  // namespace

TEST_CASE("a closed mesh is crossed in and out, at its edges and corners too", "[property]") {
  const Place place = GENERATE(Place{{0, 0, 0}, 1}, Place{{1e6, 1e6, -1e6}, 1}, Place{{0, 0, 0}, 1e-30},
                               Place{{1, 2, 3}, 1e4});
  const Mesh mesh = ball(4, place.middle, place.radius);
  std::mt19937_64 random(3);
  const auto rays = std::make_unique<RayStream>();
  const auto hits = std::make_unique<HitStream>();
  const MeshSurface surface(mesh, widest_isa(), 5);
  std::int64_t lost = 0, odd = 0, wrong_order = 0, rays_seen = 0;
  for (std::int64_t stream = test::cases(100000, 1000000) / kStreamSize / 4; stream >= 0; --stream) {
    aim(random, mesh, place.middle, place.radius, *rays);
    TraceCounts counts;
    clear(*hits);
    surface.first_hit(*rays, *hits, counts);
    // at the silhouette a ray may pass, or go in and out at the same place
    bool inner[kStreamSize];
    for (int i = 0; i < kStreamSize; ++i) {
      const Double3 o = {rays->ox[i], rays->oy[i], rays->oz[i]}, d = {rays->dx[i], rays->dy[i], rays->dz[i]},
                    along = normalized(d), to = place.middle - o, aside = to - dot(to, along) * along;
      inner[i] = length(aside) < 0.99 * place.radius;
    }
    int crossings[kStreamSize] = {};
    double last[kStreamSize] = {};
    for (int step = 0; step < 8; ++step) {
      for (int i = 0; i < kStreamSize; ++i) {
        if (!is_hit(*hits, i)) continue;
        wrong_order += hits->t[i] < last[i] || hits->object[i] != 5 ||
                       (inner[i] && hits->sides[i] != std::uint32_t(crossings[i] % 2));
        last[i] = hits->t[i];
        ++crossings[i];
      }
      surface.next_hit(*rays, *hits, counts);
    }
    for (int i = 0; i < kStreamSize; ++i) {
      ++rays_seen;
      odd += crossings[i] % 2 != 0;
      lost += inner[i] && crossings[i] != 2;
    }
  }
  CHECK(rays_seen > 20000);
  CHECK(lost == 0);
  CHECK(odd == 0);
  CHECK(wrong_order == 0);
}

TEST_CASE("hits of a mesh are the same bits with each instruction set and each tree") {
  const Mesh mesh = ball(3, {0.1, 0.2, 0.3}, 1);
  std::mt19937_64 random(9);
  const auto rays = std::make_unique<RayStream>();
  aim(random, mesh, {0.1, 0.2, 0.3}, 1, *rays);
  const auto expected = std::make_unique<HitStream>(), found = std::make_unique<HitStream>();
  clear(*expected);
  TraceCounts counts;
  MeshSurface(mesh, Isa::scalar, 0).first_hit(*rays, *expected, counts);
  for (const Isa isa : available_isas())
    for (const char* const embree : {"0", "1"}) {
      setenv("ISOCAST_EMBREE", embree, 1);
      const MeshSurface surface(mesh, isa, 0);
      clear(*found);
      surface.first_hit(*rays, *found, counts);
      int differences = 0;
      for (int i = 0; i < kStreamSize; ++i)
        differences += std::memcmp(&expected->t[i], &found->t[i], sizeof(double)) != 0 ||
                       expected->cell[0][i] != found->cell[0][i];
      CHECK(differences == 0);
      bool any[kStreamSize] = {};
      surface.any_hit(*rays, any, counts);
      for (int i = 0; i < kStreamSize; ++i) differences += any[i] != is_hit(*expected, i);
      CHECK(differences == 0);
    }
  unsetenv("ISOCAST_EMBREE");
}

TEST_CASE("hits of a mesh are those of the ball that it stands for") {
  const Mesh mesh = ball(6, {0, 0, 0}, 1);
  const MeshSurface surface(mesh, widest_isa(), 0);
  std::mt19937_64 random(1);
  const auto rays = std::make_unique<RayStream>();
  const auto hits = std::make_unique<HitStream>();
  const auto dressed = std::make_unique<DressedHits>();
  aim(random, mesh, {0, 0, 0}, 1, *rays);
  clear(*hits);
  TraceCounts counts;
  surface.first_hit(*rays, *hits, counts);
  surface.dress(*rays, *hits, {.normal = true, .position = true, .value = true}, *dressed);
  for (int i = 0; i < kStreamSize; ++i) {
    if (!is_hit(*hits, i)) continue;
    const Double3 p = {dressed->position[0][i], dressed->position[1][i], dressed->position[2][i]},
                  n = {dressed->normal[0][i], dressed->normal[1][i], dressed->normal[2][i]};
    CHECK(length(p) == Approx(1).margin(1e-3));
    CHECK(length(n) == Approx(1));
    CHECK(dot(n, normalized(p)) > 0.99);
  }
}

TEST_CASE("a ray that starts on a mesh does not see its own start") {
  const Mesh mesh = ball(3, {5, 5, 5}, 1);
  const MeshSurface surface(mesh, widest_isa(), 0);
  std::mt19937_64 random(1);
  const auto rays = std::make_unique<RayStream>();
  const auto hits = std::make_unique<HitStream>();
  const auto dressed = std::make_unique<DressedHits>();
  aim(random, mesh, {5, 5, 5}, 1, *rays);
  TraceCounts counts;
  clear(*hits);
  surface.first_hit(*rays, *hits, counts);
  surface.dress(*rays, *hits, {.normal = true}, *dressed);
  int started = 0;
  for (int i = 0; i < kStreamSize; ++i) {
    const bool hit = is_hit(*hits, i);
    started += hit;
    rays->t_min[i] = hit ? 0 : 1;
    rays->t_max[i] = hit ? Box::inf : 0;
    if (!hit) continue;
    rays->ox[i] += hits->t_lo[i] * rays->dx[i], rays->oy[i] += hits->t_lo[i] * rays->dy[i];
    rays->oz[i] += hits->t_lo[i] * rays->dz[i];
    // out along the surface and a little up
    const Double3 n = {dressed->normal[0][i], dressed->normal[1][i], dressed->normal[2][i]},
                  side = normalized(cross(n, {0.3, 0.5, 0.7})), d = side + 1e-3 * n;
    rays->dx[i] = d[0], rays->dy[i] = d[1], rays->dz[i] = d[2];
    rays->start_object[i] = 0, rays->start_sides[i] = hits->sides[i];
  }
  CHECK(started > 200);
  bool any[kStreamSize] = {};
  surface.any_hit(*rays, any, counts);
  int blocked = 0;
  for (const bool one : any) blocked += one;
  CHECK(blocked == 0);
}
