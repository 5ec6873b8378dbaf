// A device's kernels of formulas, run by this processor on an interpreted tape: the scalar CPU's bits,
// whatever the blocks and their order.
#include <isocast/cuda/formula_device.h>
#include <isocast/cuda/host_engine.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/implicit_surface.h>
#include <isocast/isa/cpu.h>
#include <test_size.h>

#include "formula_rays.h"

using namespace isocast;
using namespace isocast::test;

namespace {

// First hits and two more behind them; returns the number of all hits.
std::int64_t compare(std::mt19937_64& random, const CatalogueSurface& surface, const FormulaChoice& choice) {
  ImplicitSurfaceOptions options = options_of(choice, random);
  const Expression expression = surface_expression(surface);
  const ImplicitSurface alone(expression, surface.domain, options);
  constexpr int kThreads[] = {1, 32, 77, 256, 1000};
  options.device = make_formula_device(std::make_shared<QueuePool>(
      make_host_engine({kThreads[random() % std::size(kThreads)], random() % 3})));
  const ImplicitSurface device(expression, surface.domain, options);
  const std::unique_ptr<Streams> a = rays_through(random, alone.bounds()), b = std::make_unique<Streams>(*a);
  const bool cost = !options.method.marches();
  std::int64_t count = 0;
  TraceCounts counts_a, counts_b;
  alone.first_hit(a->rays, a->hits, counts_a);
  device.first_hit(b->rays, b->hits, counts_b);
  require_same_hits(*a, *b, cost);
  for (int behind = 0; behind < 2; ++behind) {
    for (int i = 0; i < a->rays.size; ++i) count += is_hit(a->hits, i);
    alone.next_hit(a->rays, a->hits, counts_a);
    device.next_hit(b->rays, b->hits, counts_b);
    require_same_hits(*a, *b, cost);
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
    const std::int64_t rounds = test::cases(2, 100);
    for (std::int64_t round = 0; round < rounds; ++round) {
      const FormulaChoice& choice = random_choice(random, surface);
      INFO(surface.id << " " << choice.method << ", round " << round);
      hits += compare(random, surface, choice);
    }
  }
  CHECK(hits > 2000);
}
