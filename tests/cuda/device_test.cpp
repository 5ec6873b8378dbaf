// A device against the scalar CPU: the same bits where only basic arithmetic is used, certificates that never
// contradict each other elsewhere.
#include <isocast/base/error.h>
#include <isocast/base/module.h>
#include <isocast/cuda/cuda_module.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/implicit_surface.h>
#include <isocast/isa/cpu.h>
#include <test_size.h>

#include <catch2/catch.hpp>
#include <cstdio>

#include "../volume/random_streams.h"
#include "../volume/test_fields.h"
#include "formula_rays.h"

using namespace isocast;
using namespace isocast::test;

namespace {

const ComputeDevice* device() {
  static const std::shared_ptr<const ComputeDevice> opened = []() -> std::shared_ptr<const ComputeDevice> {
    try {
      return module_table<CudaModule>("cuda", "this test").open();
    } catch (const InputError& error) {
      std::printf("skipped: no device (%s)\n", error.what());
      return nullptr;
    }
  }();
  return opened.get();
}

// Functions of the library have bits of their own on a device.
bool is_basic(const CatalogueSurface& surface) { return surface.degree.has_value(); }

}  // namespace

TEST_CASE("volumes on a device", "[cuda][property]") {
  if (!device()) return;
  std::mt19937_64 random(61);
  const std::vector<std::shared_ptr<Volume>> volumes = {
      make_volume(kDims, SampleType::u8, wavy), with_holes(make_volume(kDims, SampleType::f32, wavy)),
      make_volume(kDims, SampleType::f64, flat), patchy_tree(SparseType::f32), patchy_tree(SparseType::i16)};
  for (std::int64_t round = 0; round < test::cases(100, 20000); ++round) {
    const auto& volume = volumes[random() % volumes.size()];
    constexpr const char* kMethods[] = {"midpoint", "linear", "neubauer", "marmitt", "certified"};
    VolumeSurfaceOptions options = surface_options(0, Isa::scalar, kMethods[random() % std::size(kMethods)]);
    options.iso = random() % 2 ? std::vector<double>{41} : std::vector<double>{60, 20, 41};
    options.double_precision = random() % 2;
    options.order = RayOrder::walk;
    const VolumeSurface walk(volume, options);
    options.device = device()->volumes;
    const VolumeSurface there(volume, options);
    const std::unique_ptr<Streams> asked = make_streams();
    fill_random(random, walk.bounds(), *asked);
    INFO("round " << round);
    compare_hits(random, walk, there, *asked, 1);
  }
}

TEST_CASE("formulas on a device", "[cuda][property]") {
  if (!device()) return;
  std::mt19937_64 random(62);
  for (const CatalogueSurface& surface : catalogue()) {
    if (test::cases(0, 1) == 0 && surface.id.size() % 4 != 0) continue;
    INFO(surface.id);
    for (int round = 0; round < 4; ++round) {
      const FormulaChoice& choice = random_choice(random, surface);
      ImplicitSurfaceOptions options = options_of(choice, random);
      const Expression expression = surface_expression(surface);
      const ImplicitSurface alone(expression, surface.domain, options);
      options.device = device()->formulas;
      const ImplicitSurface there(expression, surface.domain, options);
      const auto a = rays_through(random, alone.bounds()), b = std::make_unique<Streams>(*a);
      TraceCounts counts;
      alone.first_hit(a->rays, a->hits, counts);
      there.first_hit(b->rays, b->hits, counts);
      if (is_basic(surface)) require_same_hits(*a, *b, !options.method.marches());
      else require_no_contradiction(*a, *b);
    }
  }
}
