// Solids of solids in closed form.
#include "../input_error.h"
#include "csg_parts.h"

using namespace isocast;
using namespace isocast::test;

namespace {

const char* const kBig = "x^2 + y^2 + z^2 - 1";
const char* const kSmall = "x^2 + y^2 + z^2 - 0.25";

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

TEST_CASE("a ray that follows an operand's surface comes to an end, undecided") {
  // along the plane, on which f stays 0, and within roundings of it
  const CsgSurface half(join(CsgOperation::intersect, {formula("z", {0}, false), formula(kBig, {0}, false)}),
                        kObject);
  for (const double height : {0.0, 1e-9, -1e-9, 1e-6, -1e-6})
    for (const Double3& d : {Double3{1, 0, 0}, {0.8, 0.6, 1e-9}, {0.8, 0.6, -1e-7}}) {
      const auto rays = one_ray({-2.5 * d[0], -2.5 * d[1], height}, d);
      const auto hits = std::make_unique<HitStream>();
      clear(*hits);
      TraceCounts counts;
      int crossings = 0;
      for (half.first_hit(*rays, *hits, counts); is_hit(*hits, 0) && crossings < 100; ++crossings) {
        CHECK((hits->t[0] > 1.4 && hits->t[0] < 3.6));
        half.next_hit(*rays, *hits, counts);
      }
      CHECK(crossings < 20);
      CHECK(counts.evaluations < 3'000'000);
    }
}

TEST_CASE("next_hit goes on from the crossing before, also when other rays come between") {
  const CsgSurface comb(join(CsgOperation::subtract, {formula(kBig), formula("sin(40*x)")}), kObject);
  const auto rays = one_ray({-3, 0.1, 0.2}, {1, 0, 0}), others = one_ray({0.3, -3, 0.1}, {0, 1, 0});
  const std::vector<Crossing> crossings = along(comb, {-3, 0.1, 0.2}, {1, 0, 0});
  REQUIRE(crossings.size() > 20);

  const auto hits = std::make_unique<HitStream>();
  clear(*hits);
  TraceCounts first;
  comb.first_hit(*rays, *hits, first);
  std::int64_t most = 0;
  for (std::size_t n = 1; n < crossings.size(); ++n) {
    const bool disturbed = n % 5 == 0;
    if (disturbed) {
      const auto other = std::make_unique<HitStream>();
      clear(*other);
      TraceCounts ignored;
      comb.first_hit(*others, *other, ignored);
      comb.next_hit(*others, *other, ignored);
    }
    TraceCounts counts;
    comb.next_hit(*rays, *hits, counts);
    REQUIRE(is_hit(*hits, 0));
    CHECK(hits->t[0] == crossings[n].t);
    if (!disturbed && n > 1) most = std::max(most, counts.evaluations);
  }
  CHECK(most > 0);
  CHECK(most < first.evaluations);

  // the same question twice has the same answer
  clear(*hits);
  comb.first_hit(*rays, *hits, first);
  const auto again = std::make_unique<HitStream>(*hits);
  comb.next_hit(*rays, *hits, first);
  comb.next_hit(*rays, *hits, first);
  comb.next_hit(*rays, *again, first);
  CHECK(hits->t[0] == crossings[2].t);
  CHECK(again->t[0] == crossings[1].t);
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
