// Solids of solids against point membership: random trees, and a volume without a formula.
#include <fmt/format.h>

#include <functional>

#include "../test_size.h"
#include "../volume/make_volume.h"
#include "csg_parts.h"

using namespace isocast;
using namespace isocast::test;

namespace {

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
