// Normals from neighbouring hits against their definition, pixel by pixel in double.
#include <isocast/isa/cpu.h>
#include <isocast/ray/neighbour_normals.h>
#include <isocast/ray/tile_slot.h>
#include <isocast/render/camera.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <optional>
#include <random>

using namespace isocast;

namespace {

constexpr std::uint16_t kObject = 3;
constexpr double kUntouched = 7;

struct Tile {
  RayStream rays;
  HitStream hits;

  [[nodiscard]] bool hit(int x, int y) const {
    return x >= 0 && y >= 0 && x < 16 && y < 16 && hits.object[slot(x, y)] == kObject;
  }
  [[nodiscard]] Double3 point(int i) const {
    return {rays.ox[i] + hits.t[i] * rays.dx[i], rays.oy[i] + hits.t[i] * rays.dy[i],
            rays.oz[i] + hits.t[i] * rays.dz[i]};
  }
  static int slot(int x, int y) { return tile_slot(x, y); }
};

// The hit of one of two neighbours whose depth is nearer; -1: none.
int nearer(const Tile& tile, int i, int ax, int ay, int bx, int by) {
  const auto distance = [&](int x, int y) {
    const int k = Tile::slot(x, y);
    return tile.hit(x, y) && tile.hits.iso[k] == tile.hits.iso[i] ? std::abs(tile.hits.t[k] - tile.hits.t[i])
                                                                  : Box::inf;
  };
  const double a = distance(ax, ay), b = distance(bx, by);
  if (a == Box::inf && b == Box::inf) return -1;
  return a <= b ? Tile::slot(ax, ay) : Tile::slot(bx, by);
}

// off: how far the normal moves where a point moves by 1
struct Triangle {
  Double3 normal;
  double off;
};
std::optional<Triangle> triangle_of(const Tile& tile, int x, int y) {
  const int i = Tile::slot(x, y);
  if (!tile.hit(x, y)) return std::nullopt;
  const int across = nearer(tile, i, x - 1, y, x + 1, y), down = nearer(tile, i, x, y - 1, x, y + 1);
  if (across < 0 || down < 0) return std::nullopt;
  const Double3 p = tile.point(i), a = tile.point(across) - p, b = tile.point(down) - p, n = cross(a, b),
                d = {tile.rays.dx[i], tile.rays.dy[i], tile.rays.dz[i]};
  return Triangle{(dot(n, d) > 0 ? -1.0 : 1.0) * normalized(n), (length(a) + length(b)) / length(n)};
}

// Two sheets, holes and another object, from any camera; lengths of any size.
void make_tile(std::mt19937_64& random, double size, Tile& tile) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Camera camera;
  camera.position = {size * (3 + unit(random)), size * unit(random), size * unit(random)};
  camera.target = {0, 0, 0};
  camera.up = {unit(random), 0.1, 1};
  if (random() % 3 == 0) camera.ortho_height = 2 * size;
  View(camera, 300, 200)
      .fill(static_cast<int>(random() % 15), static_cast<int>(random() % 10), 0.5, 0.5, tile.rays);
  clear(tile.hits);
  const double bend = unit(random);
  const int holes = 2 + static_cast<int>(random() % 8);
  for (int i = 0; i < kStreamSize; ++i) {
    if (random() % static_cast<unsigned>(holes) == 0) continue;
    const double u = tile.rays.u[i] / 300 - 0.5, v = tile.rays.v[i] / 200 - 0.5;
    tile.hits.t[i] =
        size * (2 + bend * u * v + 0.4 * u + u * u - 0.7 * v * v + (random() % 5 == 0 ? 0.7 : 0.0));
    tile.hits.object[i] = random() % 9 == 0 ? 1 : kObject;
    tile.hits.iso[i] = random() % 7 == 0;
  }
}

}  // namespace

TEST_CASE("normals from neighbours are those of their definition, with the same bits everywhere") {
  std::mt19937_64 random(3);
  const auto tile = std::make_unique<Tile>();
  const auto dressed = std::make_unique<DressedHits>(), same = std::make_unique<DressedHits>();
  int seen = 0;
  for (int n = 0; n < 300; ++n) {
    const double size = std::ldexp(1.0, static_cast<int>(random() % 200) - 100);
    make_tile(random, size, *tile);
    if (n % 3 == 0)
      for (std::uint8_t& iso : tile->hits.iso) iso = 0;
    const auto find = [&](Isa isa, DressedHits& looks, bool(&made)[kStreamSize]) {
      for (auto& axis : looks.normal)
        for (double& x : axis) x = kUntouched;
      return normal_kernels(isa).find_neighbour_normals(tile->rays, tile->hits, kObject, looks, made);
    };
    bool made[kStreamSize], also[kStreamSize];
    const int left = find(Isa::scalar, *dressed, made);
    int without = 0;
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const int i = Tile::slot(x, y);
        const std::optional<Triangle> right = triangle_of(*tile, x, y);
        INFO("tile " << n << " pixel " << x << "," << y);
        REQUIRE(made[i] == right.has_value());
        without += tile->hit(x, y) && !right;
        const Double3 found = {dressed->normal[0][i], dressed->normal[1][i], dressed->normal[2][i]};
        if (!right) REQUIRE(found == Double3{kUntouched, kUntouched, kUntouched});
        else REQUIRE(length(found - right->normal) < 1e-6 * size * right->off);
        seen += right.has_value();
      }
    REQUIRE(left == without);
    for (const Isa isa : available_isas()) {
      REQUIRE(find(isa, *same, also) == left);
      for (int i = 0; i < kStreamSize; ++i) {
        REQUIRE(made[i] == also[i]);
        for (int a = 0; a < 3; ++a) REQUIRE(dressed->normal[a][i] == same->normal[a][i]);
      }
    }
  }
  CHECK(seen > 20000);
}

TEST_CASE("a tile without hits of the object has no normals, and one hit alone has none") {
  const auto tile = std::make_unique<Tile>();
  std::mt19937_64 random(1);
  make_tile(random, 1, *tile);
  const auto dressed = std::make_unique<DressedHits>();
  bool made[kStreamSize];
  const auto find = [&] {
    return normal_kernels(widest_isa())
        .find_neighbour_normals(tile->rays, tile->hits, kObject, *dressed, made);
  };
  clear(tile->hits);
  CHECK(find() == 0);
  tile->hits.t[100] = 1, tile->hits.object[100] = kObject, tile->hits.iso[100] = 0;
  CHECK(find() == 1);
  for (const bool one : made) REQUIRE_FALSE(one);
}
