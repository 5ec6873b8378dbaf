// Solids of solids against closed forms and point membership.
#include <fmt/format.h>
#include <isocast/ray/csg_surface.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>

#include "../input_error.h"
#include "../render/formula_scene.h"
#include "../test_size.h"
#include "../volume/make_volume.h"
#include "ray_maker.h"

using namespace isocast;
using namespace isocast::test;

namespace {

constexpr std::uint16_t kObject = 2;

CsgPart operand(std::shared_ptr<const Surface> surface, int isos = 1, bool above = false) {
  return {CsgOperation::operand, {std::move(surface), isos, above}, {}};
}
CsgPart formula(const std::string& text, std::vector<double> iso = {0}, bool precise = true) {
  const int isos = static_cast<int>(iso.size());
  return operand(formula_surface(text, std::move(iso), kObject, precise), isos);
}
CsgPart join(CsgOperation operation, std::vector<CsgPart> parts) { return {operation, {}, std::move(parts)}; }

// All crossings of a stream: hits[n] is what the n-th query found.
struct Crossing {
  double t, t_lo, t_hi;
  int iso;
  std::uint32_t sides;
  Certificate certificate;
};
std::vector<std::vector<Crossing>> all_crossings(const Surface& surface, const RayStream& rays,
                                                 Certificate (&last)[kStreamSize]) {
  std::vector<std::vector<Crossing>> all(static_cast<std::size_t>(rays.size));
  auto hits = std::make_unique<HitStream>();
  clear(*hits);
  std::ranges::fill(hits->certificate, Certificate::proved_miss);
  TraceCounts counts;
  surface.first_hit(rays, *hits, counts);
  for (bool any = true; any;) {
    any = false;
    for (int i = 0; i < rays.size; ++i) {
      if (all[static_cast<std::size_t>(i)].empty() && !is_hit(*hits, i)) last[i] = hits->certificate[i];
      if (!is_hit(*hits, i)) continue;
      any = true;
      all[static_cast<std::size_t>(i)].push_back(
          {hits->t[i], hits->t_lo[i], hits->t_hi[i], hits->iso[i], hits->sides[i], hits->certificate[i]});
      REQUIRE(all[static_cast<std::size_t>(i)].size() < 200);
    }
    surface.next_hit(rays, *hits, counts);
  }
  return all;
}
std::vector<Crossing> along(const Surface& surface, const Double3& o, const Double3& d) {
  Certificate last[kStreamSize];
  return all_crossings(surface, *one_ray(o, d), last)[0];
}
std::vector<double> places(const std::vector<Crossing>& crossings) {
  std::vector<double> t;
  for (const Crossing& c : crossings) t.push_back(c.t);
  return t;
}
void check_places(const std::vector<Crossing>& crossings, const std::vector<double>& expected) {
  const std::vector<double> t = places(crossings);
  CHECK_THAT(t, Catch::Approx(expected).margin(1e-6));
}

const char* const kBig = "x^2 + y^2 + z^2 - 1";
const char* const kSmall = "x^2 + y^2 + z^2 - 0.25";

// A solid by its membership, and where it may change along a ray.
struct Truth {
  std::function<bool(const Double3&)> inside;
  std::function<void(const Double3& o, const Double3& d, std::vector<double>& roots)> roots;
};

// Spheres in a tree of `depth` with operations at random.
struct RandomTree {
  std::mt19937& random;
  std::vector<std::pair<Double3, double>> spheres;

  std::pair<CsgPart, std::function<bool(const Double3&)>> make(int depth) {
    std::uniform_real_distribution<double> place(-0.8, 0.8), size(0.4, 1.3);
    if (depth == 0) {
      const Double3 c = {place(random), place(random), place(random)};
      const double r = size(random);
      spheres.push_back({c, r});
      return {
          formula(fmt::format("(x - ({}))^2 + (y - ({}))^2 + (z - ({}))^2 - {}", c[0], c[1], c[2], r * r)),
          [=](const Double3& p) { return dot(p - c, p - c) < r * r; }};
    }
    const auto a = make(depth - 1), b = make(depth - 1);
    switch (random() % 3) {
      case 0:
        return {join(CsgOperation::unite, {a.first, b.first}),
                [=](const Double3& p) { return a.second(p) || b.second(p); }};
      case 1:
        return {join(CsgOperation::intersect, {a.first, b.first}),
                [=](const Double3& p) { return a.second(p) && b.second(p); }};
      default:
        return {join(CsgOperation::subtract, {a.first, b.first}),
                [=](const Double3& p) { return a.second(p) && !b.second(p); }};
    }
  }
};

}  // namespace

TEST_CASE("nested spheres: union, intersection and difference in closed form") {
  const CsgPart big = formula(kBig), small = formula(kSmall);
  const CsgSurface shell(join(CsgOperation::subtract, {big, small}), kObject);
  const std::vector<Crossing> crossings = along(shell, {-3, 0, 0}, {1, 0, 0});
  check_places(crossings, {2, 2.5, 3.5, 4});
  for (const Crossing& c : crossings) CHECK(c.certificate == Certificate::proved_hit);
  CHECK(crossings[0].iso == 0);
  CHECK(crossings[1].iso == 1);
  CHECK(crossings[2].iso == 1);
  CHECK(crossings[3].iso == 0);
  check_places(along(shell, {0, 0, 0}, {1, 0, 0}), {0.5, 1});
  check_places(along(shell, {0.7, 0, 0}, {2, 0, 0}), {0.15});
  check_places(along(shell, {-3, 0.7, 0}, {1, 0, 0}), {3 - std::sqrt(0.51), 3 + std::sqrt(0.51)});
  check_places(along(CsgSurface(join(CsgOperation::unite, {small, big}), kObject), {-3, 0, 0}, {1, 0, 0}),
               {2, 4});
  const CsgSurface core(join(CsgOperation::intersect, {small, big}), kObject);
  check_places(along(core, {-3, 0, 0}, {1, 0, 0}), {2.5, 3.5});
  check_places(along(CsgSurface(join(CsgOperation::subtract, {small, big}), kObject), {-3, 0, 0}, {1, 0, 0}),
               {});
  CHECK(shell.iso_count() == 2);
  CHECK(shell.proves());

  // misses are proved as well
  Certificate last[kStreamSize];
  (void)all_crossings(shell, *one_ray({-3, 1.5, 0}, {1, 0, 0}), last);
  CHECK(last[0] == Certificate::proved_miss);
}

TEST_CASE("an operand that has no crossing along the ray is known to be there or not") {
  // all of the domain lies in the first, nothing in the second
  const CsgPart all = formula("x^2 + y^2 + z^2 - 100"), none = formula("x^2 + y^2 + z^2 + 1"),
                ball = formula(kBig);
  const auto count = [&](CsgOperation operation, const CsgPart& a, const CsgPart& b) {
    return along(CsgSurface(join(operation, {a, b}), kObject), {-3, 0.1, 0}, {1, 0, 0}).size();
  };
  CHECK(count(CsgOperation::intersect, all, ball) == 2);
  CHECK(count(CsgOperation::subtract, all, ball) == 2);
  CHECK(count(CsgOperation::subtract, ball, all) == 0);
  CHECK(count(CsgOperation::unite, all, ball) == 0);
  CHECK(count(CsgOperation::intersect, none, ball) == 0);
  CHECK(count(CsgOperation::subtract, ball, none) == 2);
  CHECK(count(CsgOperation::unite, none, ball) == 2);
}

TEST_CASE("a surface that ends at its domain is closed by the domain's faces") {
  const Box box = {{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}};
  CsgOperand half = formula("z").operand;
  const CsgSurface solid(closed(half, box, Transform(), kObject), kObject);
  CHECK(solid.iso_count() == 2);
  const std::vector<Crossing> down = along(solid, {0.1, 0.2, 3}, {0, 0, -1});
  check_places(down, {3, 3.5});
  CHECK(down[0].iso == 0);
  CHECK(down[1].iso == 1);
  const std::vector<Crossing> across = along(solid, {-2, 0.1, -0.3}, {1, 0, 0});
  check_places(across, {1.5, 2.5});
  for (const Crossing& c : across) CHECK(c.certificate == Certificate::proved_hit);
  check_places(along(solid, {-2, 0.1, 0.3}, {1, 0, 0}), {});
  half.above = true;
  const CsgSurface upper(closed(half, box, Transform(), kObject), kObject);
  check_places(along(upper, {-2, 0.1, 0.3}, {1, 0, 0}), {1.5, 2.5});
  check_places(along(upper, {0.1, 0.2, 3}, {0, 0, -1}), {2.5, 3});
}

TEST_CASE("inner iso-values are there where the solid is, because of their operand") {
  const CsgPart onion = formula("x^2 + y^2 + z^2", {1, 0.25}), cut = formula("x");
  const std::vector<Crossing> half =
      along(CsgSurface(join(CsgOperation::subtract, {onion, cut}), kObject), {-3, 0, 0}, {1, 0, 0});
  check_places(half, {3, 3.5, 4});
  CHECK(half[0].iso == 2);
  CHECK(half[1].iso == 1);
  CHECK(half[2].iso == 0);
  // what a ball that holds all of it hides
  check_places(
      along(CsgSurface(join(CsgOperation::unite, {onion, formula(kBig)}), kObject), {-3, 0, 0}, {1, 0, 0}),
      {2, 4});
}

TEST_CASE("a CSG is an operand, like the tree of its parts") {
  const CsgPart big = formula(kBig), small = formula(kSmall), slab = formula("z^2 - 0.04");
  const CsgPart shell = join(CsgOperation::subtract, {big, small});
  const auto nested = std::make_shared<CsgSurface>(shell, kObject);
  const CsgSurface a(join(CsgOperation::intersect, {slab, operand(nested)}), kObject),
      b(join(CsgOperation::intersect, {slab, shell}), kObject);
  CHECK(a.iso_count() == 3);
  std::mt19937 random(3);
  for (int round = 0; round < 4; ++round) {
    const auto rays = random_rays(random, {0, 0, 0}, 2.5);
    Certificate la[kStreamSize], lb[kStreamSize];
    const auto of_a = all_crossings(a, *rays, la), of_b = all_crossings(b, *rays, lb);
    for (std::size_t i = 0; i < of_a.size(); ++i) CHECK(places(of_a[i]) == places(of_b[i]));
  }
}

TEST_CASE("random trees of depth 4: all crossings, by point membership", "[property]") {
  std::mt19937 random(11);
  std::int64_t rays_checked = 0, crossings_checked = 0, undecided = 0;
  const std::int64_t trees = cases(12, 400);
  for (std::int64_t tree = 0; tree < trees; ++tree) {
    RandomTree maker{random, {}};
    const auto [part, inside] = maker.make(4);
    const CsgSurface surface(part, kObject);
    const auto rays = random_rays(random, {0, 0, 0}, 2.9);
    Certificate last[kStreamSize];
    const auto found = all_crossings(surface, *rays, last);
    for (int i = 0; i < rays->size; ++i) {
      const Double3 o = at(*rays, i, 0), d = at(*rays, i, 1) - o;
      std::vector<double> roots = {0};
      for (const auto& [c, r] : maker.spheres) {
        const double b = dot(o - c, d) / dot(d, d), disc = b * b - (dot(o - c, o - c) - r * r) / dot(d, d);
        if (disc < 0) continue;
        for (const double t : {-b - std::sqrt(disc), -b + std::sqrt(disc)})
          if (t > 0) roots.push_back(t);
      }
      std::ranges::sort(roots);
      bool clear_cut = true;
      for (std::size_t n = 1; n < roots.size(); ++n) clear_cut = clear_cut && roots[n] - roots[n - 1] > 1e-5;
      if (!clear_cut) continue;
      std::vector<double> expected;
      roots.push_back(roots.back() + 1);
      for (std::size_t n = 1; n + 1 < roots.size(); ++n) {
        const bool before = inside(at(*rays, i, 0.5 * (roots[n - 1] + roots[n]))),
                   behind = inside(at(*rays, i, 0.5 * (roots[n] + roots[n + 1])));
        if (before != behind) expected.push_back(roots[n]);
      }
      const std::vector<Crossing>& crossings = found[static_cast<std::size_t>(i)];
      ++rays_checked;
      REQUIRE(crossings.size() == expected.size());
      for (std::size_t n = 0; n < expected.size(); ++n) {
        ++crossings_checked;
        CHECK(crossings[n].t == Approx(expected[n]).margin(1e-6));
        const bool proved = crossings[n].certificate == Certificate::proved_hit;
        undecided += !proved;
        if (proved)
          CHECK((crossings[n].t_lo <= expected[n] + 1e-12 && expected[n] <= crossings[n].t_hi + 1e-12));
      }
    }
  }
  CHECK(rays_checked > trees * 200);
  CHECK(crossings_checked > trees * 80);
  CHECK(undecided < crossings_checked / 50);
}

TEST_CASE("a volume minus a formula, against membership along dense rays", "[property]") {
  constexpr int n = 24;
  const auto f = [](double i, double j, double k) {
    return std::sin(0.5 * i) * std::cos(0.4 * j) + std::sin(0.45 * j) * std::cos(0.5 * k) +
           std::sin(0.4 * k) * std::cos(0.3 * i);
  };
  const auto volume = make_volume(
      {n, n, n}, SampleType::f32,
      [&](std::int64_t i, std::int64_t j, std::int64_t k) { return f(double(i), double(j), double(k)); });
  // turned and moved into [-2, 2]^3
  const double h = 4.0 / (n - 1) * 0.7;
  const double rows[3][4] = {{0.8 * h, -0.6 * h, 0, -0.3}, {0.6 * h, 0.8 * h, 0, -2}, {0, 0, h, -1.4}};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) volume->world_from_grid.m[r][c] = rows[r][c];
  VolumeSurfaceOptions options = surface_options(0.2);
  options.object = kObject;
  options.double_precision = true;
  const auto solid = std::make_shared<VolumeSurface>(volume, options);
  const Box grid = {{0, 0, 0}, {n - 1, n - 1, n - 1}};
  const std::string tubes = "(sin(5*x) + cos(4*y) + sin(3*z)) - 0.4";
  CsgPart minus = formula(tubes);
  const CsgSurface surface(
      join(CsgOperation::subtract, {closed({solid, 1, true}, grid, volume->world_from_grid, kObject), minus}),
      kObject);
  const Transform grid_from_world = volume->world_from_grid.inverse();
  const auto* const samples = reinterpret_cast<const float*>(volume->samples);
  const auto inside = [&](const Double3& p) {
    const Double3 g = grid_from_world.point(p);
    int cell[3];
    double place[3];
    for (int a = 0; a < 3; ++a) {
      if (g[a] < 0 || g[a] > n - 1) return false;
      cell[a] = std::min(n - 2, static_cast<int>(g[a]));
      place[a] = g[a] - cell[a];
    }
    double value = 0;
    for (int k = 0; k < 8; ++k) {
      double weight = 1;
      for (int a = 0; a < 3; ++a) weight *= k >> a & 1 ? place[a] : 1 - place[a];
      value += weight *
               double(samples[cell[0] + (k & 1) + n * (cell[1] + (k >> 1 & 1) + n * (cell[2] + (k >> 2)))]);
    }
    return value >= 0.2 && std::sin(5 * p[0]) + std::cos(4 * p[1]) + std::sin(3 * p[2]) - 0.4 >= 0;
  };
  std::mt19937 random(7);
  constexpr double kStep = 1e-3;
  std::int64_t checked = 0, crossings = 0;
  for (std::int64_t round = 0; round < cases(2, 40); ++round) {
    const auto rays = random_rays(random, {0, 0, 0}, 2.8);
    Certificate last[kStreamSize];
    const auto found = all_crossings(surface, *rays, last);
    for (int i = 0; i < rays->size; ++i) {
      std::vector<double> expected;
      bool was = inside(at(*rays, i, 0));
      for (double t = kStep; t < 8; t += kStep) {
        const bool is = inside(at(*rays, i, t));
        if (is != was) expected.push_back(t - 0.5 * kStep);
        was = is;
      }
      const std::vector<double> t = places(found[static_cast<std::size_t>(i)]);
      // what lies closer than the steps cannot be told apart
      bool near = false;
      for (std::size_t k = 1; k < t.size(); ++k) near = near || t[k] - t[k - 1] < 2 * kStep;
      if (near) continue;
      ++checked;
      REQUIRE(t.size() == expected.size());
      for (std::size_t k = 0; k < t.size(); ++k) CHECK(std::abs(t[k] - expected[k]) < kStep);
      crossings += std::ssize(t);
    }
  }
  CHECK(checked > 400);
  CHECK(crossings > 400);
}

TEST_CASE("rays that start on a solid do not meet it where they start") {
  const CsgPart big = formula(kBig, {0}, false),
                cube = closed(formula("x - 5").operand, {{-0.8, -0.8, -0.8}, {0.8, 0.8, 0.8}}, Transform(),
                              kObject);
  const CsgSurface convex(join(CsgOperation::intersect, {big, cube}), kObject);
  std::mt19937 random(23);
  const auto rays = random_rays(random, {0, 0, 0}, 2.5);
  const auto hits = std::make_unique<HitStream>();
  clear(*hits);
  TraceCounts counts;
  convex.first_hit(*rays, *hits, counts);
  DressedHits dressed;
  convex.dress(*rays, *hits, {true, true, true}, dressed);
  auto mirrored = std::make_unique<RayStream>();
  mirrored->kind = RayKind::shadow;
  int outside = 0, on_faces = 0;
  for (int i = 0; i < rays->size; ++i) {
    if (!is_hit(*hits, i) || length(at(*rays, i, 0)) < 1.5) continue;
    const int m = mirrored->size++;
    const Double3 d = at(*rays, i, 1) - at(*rays, i, 0),
                  normal = {dressed.normal[0][i], dressed.normal[1][i], dressed.normal[2][i]};
    set_ray(*mirrored, m, at(*rays, i, hits->t_lo[i]), d - 2 * dot(d, normal) * normal);
    mirrored->start_object[m] = kObject;
    mirrored->start_sides[m] = hits->sides[i];
    ++outside;
    on_faces += hits->iso[i] == 2;
    const Double3 p = at(*rays, i, hits->t[i]);
    for (int a = 0; a < 3; ++a) CHECK(dressed.position[a][i] == Approx(p[a]).margin(1e-6));
    if (hits->iso[i] == 0)
      for (int a = 0; a < 3; ++a) CHECK(normal[a] == Approx(p[a]).margin(1e-3));
  }
  bool blocked[kStreamSize] = {};
  convex.any_hit(*mirrored, blocked, counts);
  CHECK(outside > 80);
  CHECK(on_faces > 20);
  CHECK(std::count(blocked, blocked + mirrored->size, true) == 0);
}

TEST_CASE("bounds are those of what can be there") {
  const CsgPart cube = closed(formula("x - 5").operand, {{-0.5, -1, -2}, {0.25, 1, 2}}, Transform(), kObject),
                other = closed(formula("x - 5").operand, {{0, -2, -1}, {1, 2, 1}}, Transform(), kObject),
                far = closed(formula("x - 5").operand, {{2, 2, 2}, {3, 3, 3}}, Transform(), kObject);
  const auto bounds = [](const CsgPart& part) { return CsgSurface(part, kObject).bounds(); };
  const Box both = bounds(join(CsgOperation::intersect, {cube, other}));
  CHECK(both.lo == Double3{0, -1, -1});
  CHECK(both.hi == Double3{0.25, 1, 1});
  CHECK(bounds(join(CsgOperation::unite, {cube, other})).hi == Double3{1, 2, 2});
  CHECK(bounds(join(CsgOperation::subtract, {cube, other})).lo == Double3{-0.5, -1, -2});
  const CsgSurface nothing(join(CsgOperation::intersect, {cube, far}), kObject);
  CHECK(nothing.bounds().empty());
  CHECK(along(nothing, {0, 0, 0}, {1, 1, 1}).empty());
}

TEST_CASE("solids are blended in order, each operand with its own material") {
  Scene scene;
  scene.background = {0, 0, 0};
  const CsgPart big = operand(formula_surface(kBig, {0}, 0)),
                small = operand(formula_surface(kSmall, {0}, 0));
  const auto shell = std::make_shared<CsgSurface>(join(CsgOperation::subtract, {big, small}), 0);
  scene.objects.push_back({shell, {{{1, 0, 0}, 0.5f}, {{0, 1, 0}, 0.25f}}});
  const Pixel pixel = pixel_along(scene, {0, -9, 0}, {0, 0, 0});
  const double red = 0.9, white = 0.12, t[] = {1, 0.5, 0.375, 0.28125};
  CHECK(pixel.color[0] == Approx(red * (t[0] * 0.5 + t[3] * 0.5) + white * (1 - 0.140625)));
  CHECK(pixel.color[1] == Approx(red * (t[1] * 0.25 + t[2] * 0.25) + white * (1 - 0.140625)));
  CHECK(pixel.alpha == Approx(1 - 0.140625));
}

TEST_CASE("what cannot be a solid is an error") {
  CHECK_THROWS_MATCHES(CsgSurface(join(CsgOperation::unite, {}), 0), InputError, says("without operands"));
  std::vector<CsgPart> many(300, formula(kBig));
  CHECK_THROWS_MATCHES(CsgSurface(join(CsgOperation::unite, many), 0), InputError, says("at most 256"));
}
