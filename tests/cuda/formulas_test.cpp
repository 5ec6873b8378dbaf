// A device's kernels of formulas, run by this processor on an interpreted tape: the scalar CPU's bits,
// whatever the blocks and their order.
#include <isocast/cuda/formula_device.h>
#include <isocast/cuda/host_engine.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/implicit_surface.h>
#include <isocast/isa/cpu.h>
#include <test_size.h>

#include <catch2/catch.hpp>

#include "../volume/rays.h"
#include "../volume/same_hits.h"

using namespace isocast;
using namespace isocast::test;

namespace {

// Rays one by one, as a device has them.
struct Choice {
  const char* method;
  std::map<std::string, std::string> values;
};
const std::vector<Choice> kChoices = {{"interval", {{"beams", "0"}, {"prune", "0"}}},
                                      {"affine", {{"beams", "0"}, {"prune", "0"}}},
                                      {"affine", {{"beams", "0"}, {"prune", "0"}, {"trim", "0"}}},
                                      {"interval", {{"beams", "0"}, {"prune", "0"}, {"rounding", "nearest"}}},
                                      {"mitchell", {{"beams", "0"}, {"prune", "0"}}},
                                      {"interval-newton", {{"beams", "0"}, {"prune", "0"}}},
                                      {"amp-sign", {{"prune", "0"}}},
                                      {"amp-taylor", {{"prune", "0"}}}};

std::unique_ptr<Streams> random_streams(std::mt19937_64& random, const Box& box) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto point = [&](double reach) {
    return box.center() + reach * box.diagonal() * Double3{unit(random), unit(random), unit(random)};
  };
  auto streams = make_streams();
  clear(streams->hits);
  streams->rays.size = 0;
  const int count = 1 + static_cast<int>(random() % kStreamSize);
  for (int i = 0; i < count; ++i) {
    const Double3 o = point(1);
    add_ray(streams->rays, o, random() % 4 ? point(0.4) - o : awkward_direction(random, o));
  }
  return streams;
}

// Marching points look at the slopes of all rays in work where one of them asks: their cost depends on the
// others.
void require_same(const Streams& a, const Streams& b, bool cost) {
  for (int i = 0; i < a.rays.size; ++i) {
    INFO("slot " << i << ": t " << a.hits.t[i] << " and " << b.hits.t[i]);
    REQUIRE(is_hit(a.hits, i) == is_hit(b.hits, i));
    REQUIRE(a.hits.certificate[i] == b.hits.certificate[i]);
    if (cost) REQUIRE(a.hits.cost[i] == b.hits.cost[i]);
    if (!is_hit(a.hits, i)) continue;
    REQUIRE((same(a.hits.t[i], b.hits.t[i]) && same(a.hits.t_lo[i], b.hits.t_lo[i]) &&
             same(a.hits.t_hi[i], b.hits.t_hi[i])));
    REQUIRE(a.hits.iso[i] == b.hits.iso[i]);
    REQUIRE(a.hits.sides[i] == b.hits.sides[i]);
  }
}

// First hits and two more behind them; returns the number of all hits.
std::int64_t compare(std::mt19937_64& random, const CatalogueSurface& surface, const Choice& choice) {
  ImplicitSurfaceOptions options;
  options.method = choose_formula_method(choice.method, choice.values);
  options.isa = Isa::scalar;
  options.double_precision = random() % 2;
  if (random() % 2) options.iso = {0.125, 0, -0.125};
  const Expression expression = surface_expression(surface);
  const ImplicitSurface alone(expression, surface.domain, options);
  constexpr int kThreads[] = {1, 32, 77, 256, 1000};
  options.device = make_formula_device(std::make_shared<QueuePool>(
      make_host_engine({kThreads[random() % std::size(kThreads)], random() % 3})));
  const ImplicitSurface device(expression, surface.domain, options);
  const std::unique_ptr<Streams> a = random_streams(random, alone.bounds()),
                                 b = std::make_unique<Streams>(*a);
  const bool cost = !options.method.marches();
  std::int64_t count = 0;
  TraceCounts counts_a, counts_b;
  alone.first_hit(a->rays, a->hits, counts_a);
  device.first_hit(b->rays, b->hits, counts_b);
  require_same(*a, *b, cost);
  for (int behind = 0; behind < 2; ++behind) {
    for (int i = 0; i < a->rays.size; ++i) count += is_hit(a->hits, i);
    alone.next_hit(a->rays, a->hits, counts_a);
    device.next_hit(b->rays, b->hits, counts_b);
    require_same(*a, *b, cost);
  }
  if (cost) REQUIRE(counts_a.evaluations == counts_b.evaluations);
  return count;
}

}  // namespace

TEST_CASE("a thread's ray has the scalar CPU's bits", "[property]") {
  std::mt19937_64 random(41);
  std::int64_t hits = 0;
  for (const CatalogueSurface& surface : catalogue()) {
    if (surface.kind == "csg" && test::cases(0, 1) == 0) continue;
    const std::int64_t rounds = test::cases(1, 40);
    for (std::int64_t round = 0; round < rounds; ++round) {
      const Choice& choice = kChoices[random() % kChoices.size()];
      INFO(surface.id << " " << choice.method << ", round " << round);
      hits += compare(random, surface, choice);
    }
  }
  CHECK(hits > 2000);
}
