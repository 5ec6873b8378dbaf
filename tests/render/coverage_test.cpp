// The shares that a formula covers of pixels: never too small, nearly right, proved where they say so.
#include <isocast/base/error.h>
#include <isocast/isa/cpu.h>
#include <isocast/ray/tile_slot.h>
#include <render/formula_scene.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <numbers>

using namespace isocast;
using namespace isocast::test;

namespace {

constexpr int kSize = 64;

std::unique_ptr<BlockCover> cover_of(const std::string& text, const View& view, Isa isa = widest_isa(),
                                     bool double_precision = false) {
  ImplicitSurfaceOptions options;
  options.isa = isa;
  options.double_precision = double_precision;
  const ImplicitSurface surface(parse_expression(text), Domain{{-3, -3, -3}, {3, 3, 3}}, options);
  auto cover = std::make_unique<BlockCover>();
  TraceCounts counts;
  surface.coverage(view)->cover(0, 0, *cover, counts);
  CHECK(counts.evaluations > 0);
  return cover;
}

float at(const float (&shares)[kBlockStreams][kStreamSize], int x, int y) {
  const int slot = tile_slot(x % 16, y % 16);
  return shares[x / 16 + kBlockTiles * (y / 16)][slot];
}

// The part of pixel (x, y) within `radius` pixels of the picture's middle, by many points.
double share_of_disc(int x, int y, double radius) {
  constexpr int kPoints = 32;
  int inside = 0;
  for (int j = 0; j < kPoints; ++j)
    for (int i = 0; i < kPoints; ++i)
      inside +=
          std::hypot(x + (i + 0.5) / kPoints - 0.5 * kSize, y + (j + 0.5) / kPoints - 0.5 * kSize) < radius;
  return double(inside) / (kPoints * kPoints);
}

}  // namespace

TEST_CASE("a disc: shares are at least the truth and a sixteenth or two more, and proofs at most the truth") {
  const View view = view_along({0, -5, 0}, {0, 0, 0}, kSize, 2.5);
  for (const bool precise : {false, true}) {
    const auto cover = cover_of("x^2 + y^2 + z^2 - 1", view, widest_isa(), precise);
    double sum = 0, proved = 0;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const double share = at(cover->share, x, y), open = at(cover->open, x, y),
                     truth = share_of_disc(x, y, kSize / 2.5);
        INFO(x << ' ' << y << ": " << share << ", open " << open << ", truth " << truth);
        CHECK(share >= truth - 1.0 / 512);
        if (share < 1) CHECK(share - open <= truth + 1.0 / 512);
        CHECK(share <= truth + 0.5);
        sum += share, proved += share - open;
      }
    const double area = std::numbers::pi * (kSize / 2.5) * (kSize / 2.5);
    CHECK(sum < 1.03 * area);
    CHECK(proved > 0.95 * area);
  }
}

TEST_CASE("a plate much thinner than a pixel does not vanish") {
  const View view = view_along({0, -5, 0}, {0, 0, 0}, kSize, 2.5);
  // seen along its edge, slanted across the pixels
  const std::string plate = "(x - 0.31*z)^2 - 1e-9";
  const auto cover = cover_of(plate, view, widest_isa(), true);
  for (int y = 0; y < kSize; ++y) {
    double row = 0;
    for (int x = 0; x < kSize; ++x) row += at(cover->share, x, y);
    INFO(y);
    CHECK(row > 0);
    CHECK(row < 1);
  }
  Scene scene;
  add_formula(scene, plate, {Material{}});
  RenderCounts counts;
  const Film film = picture(scene, view, {.coverage = true}, &counts);
  CHECK(counts.hits < kSize / 2);  // of the middles of pixels
  for (int y = 0; y < kSize; ++y) {
    double row = 0;
    for (int x = 0; x < kSize; ++x) row += film.color()[4 * static_cast<std::size_t>(x + kSize * y) + 3];
    CHECK(row > 0);
  }
}

TEST_CASE("pictures by shares are closer to those of many samples") {
  Scene scene;
  add_formula(scene, "x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8", {Material{}});
  const View view = view_along({2, -5, 3}, {0, 0, 0}, 96, 7);
  RenderCounts counts;
  const Film hard = picture(scene, view, {}), soft = picture(scene, view, {.coverage = true}, &counts),
             many = picture(scene, view, {.spp = 64});
  CHECK(counts.blended > 100);
  CHECK(counts.blended_open <= counts.blended);
  CHECK(mean_difference(soft, many) < 0.75 * mean_difference(hard, many));
}

TEST_CASE("the same shares on every instruction set") {
  const View view = view_along({2, -5, 3}, {0, 0, 0}, kSize, 7);
  const auto expected = cover_of("sin(x*y) + z^2 - 1", view, Isa::scalar);
  for (const Isa isa : available_isas()) {
    const auto found = cover_of("sin(x*y) + z^2 - 1", view, isa);
    CHECK(std::memcmp(expected->share, found->share, sizeof found->share) == 0);
    CHECK(std::memcmp(expected->open, found->open, sizeof found->open) == 0);
  }
}

TEST_CASE("a jump covers nothing for sure") {
  const View view = view_along({2, -5, 3}, {0, 0, 0}, kSize, 7);
  const auto cover = cover_of("sign(x^2 + y^2 + z^2 - 1)", view);
  int some = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const float share = at(cover->share, x, y);
      some += share > 0 && share < 1;
      if (share < 1) CHECK(at(cover->open, x, y) == share);
    }
  CHECK(some > 20);
}

TEST_CASE("who cannot tell shares says so") {
  Scene scene;
  add_formula(scene, "x^2 + y^2 + z^2 - 1", {Material{}});
  add_formula(scene, "z", {Material{}});
  Film film(16, 16, {});
  CHECK_THROWS_AS(render(scene, view_along({0, -5, 0}, {0, 0, 0}, 16, 2.5), {.coverage = true}, film),
                  InputError);
}
