// Beams of a device, cast by this processor thread after thread on an interpreted tape: the scalar CPU's
// bits, whatever the blocks and their order; and rays that begin where beams left off.
#include <implicit/framed_rays.h>
#include <implicit/random_camera.h>
#include <isocast/cuda/formula_device.h>
#include <isocast/cuda/host_engine.h>
#include <isocast/implicit/expression/parse.h>
#include <isocast/implicit/implicit_surface.h>
#include <test_size.h>

#include <catch2/catch.hpp>
#include <map>
#include <vector>

#include "formula_rays.h"

using namespace isocast;
using namespace isocast::test;

namespace {

const Domain kBox = {{-2, -2, -2}, {2, 2, 2}};
using Settings = std::map<std::string, std::string>;

constexpr const char* kFormulas[] = {"x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8",
                                     "sin(4*x)+sin(4*y)+sin(4*z)",
                                     "x^2 + y^2 - 0.0004",
                                     "1/x + y*z",
                                     "exp(-4*(x^2+y^2)) - z^2",
                                     "min(x^2+y^2+z^2-1, abs(x-1)+y^2-0.1)"};

std::shared_ptr<const FormulaDevice> host_device(std::mt19937_64& random) {
  constexpr int kThreads[] = {1, 32, 77, 256, 1000};
  return make_formula_device(std::make_shared<QueuePool>(
      make_host_engine({kThreads[random() % std::size(kThreads)], random() % 3})));
}

ImplicitSurface surface_of(const char* formula, const char* method, const Settings& settings, bool precise,
                           std::shared_ptr<const FormulaDevice> device = {}) {
  ImplicitSurfaceOptions options;
  options.method = choose_formula_method(method, settings);
  options.double_precision = precise;
  options.isa = Isa::scalar;
  if (precise) options.iso = {0, 0.3};
  options.device = std::move(device);
  return ImplicitSurface(parse_expression(formula), kBox, options);
}

struct Picture {
  std::vector<Streams> tiles;
  std::int64_t hits = 0, cost = 0;
};
Picture picture_of(const Surface& surface, const View& view) {
  Picture picture;
  each_tile_of_pass(surface, view, [&](const RayStream& rays, const HitStream& hits) {
    picture.tiles.push_back({rays, hits});
    for (int i = 0; i < rays.size; ++i) picture.hits += is_hit(hits, i), picture.cost += hits.cost[i];
  });
  return picture;
}

}  // namespace

TEST_CASE("a thread's beam has the scalar CPU's bits", "[property]") {
  std::mt19937_64 random(71);
  std::int64_t hits = 0;
  for (std::int64_t n = 0, count = cases(24, 600); n < count; ++n) {
    const char *formula = kFormulas[n % 6], *method = n % 4 < 2 ? "beam-adaptive" : "beam-uniform";
    constexpr const char* kDepths[] = {"0", "1", "2"};
    const Settings settings = {
        {"form", n % 2 ? "affine" : "interval"}, {"depth", kDepths[random() % 3]}, {"eps", "0.004"}};
    const bool precise = n % 5 == 0;
    INFO(formula << " " << method << " " << settings.at("form") << " depth " << settings.at("depth"));
    // of one block and of some
    const View view(random_camera(random), n % 8 == 0 ? 150 : 37, 45);
    const Picture alone = picture_of(surface_of(formula, method, settings, precise), view),
                  device =
                      picture_of(surface_of(formula, method, settings, precise, host_device(random)), view);
    REQUIRE(alone.tiles.size() == device.tiles.size());
    for (std::size_t tile = 0; tile < alone.tiles.size(); ++tile)
      require_same_hits(alone.tiles[tile], device.tiles[tile], true);
    hits += alone.hits;
  }
  CHECK(hits > 5000);
}

TEST_CASE("rays from where beams left off meet what whole rays meet, sooner", "[property]") {
  std::mt19937_64 random(72);
  std::int64_t hits = 0, cost = 0, whole_cost = 0, undecided = 0, whole_undecided = 0;
  for (std::int64_t n = 0, count = cases(18, 600); n < count; ++n) {
    const char* formula = kFormulas[n % 6];
    const bool precise = n % 4 == 0;
    INFO(formula);
    const View view(random_camera(random), 48, 40);
    const std::shared_ptr<const FormulaDevice> device = host_device(random);
    const Picture beamed = picture_of(surface_of(formula, "certified", {}, precise, device), view),
                  whole = picture_of(surface_of(formula, "affine", {}, precise, device), view);
    for (std::size_t tile = 0; tile < whole.tiles.size(); ++tile)
      require_no_contradiction(whole.tiles[tile], beamed.tiles[tile]);
    const auto count_undecided = [](const Picture& picture) {
      std::int64_t rays = 0;
      for (const Streams& tile : picture.tiles)
        for (int i = 0; i < tile.rays.size; ++i) rays += tile.hits.certificate[i] == Certificate::undecided;
      return rays;
    };
    undecided += count_undecided(beamed), whole_undecided += count_undecided(whole);
    hits += beamed.hits, cost += beamed.cost, whole_cost += whole.cost;
  }
  CHECK(hits > 2000);
  CHECK(cost < whole_cost);
  CHECK(undecided <= whole_undecided);
}
