// The reference for volumes and the program's best method see the same first crossings.
#include <isocast/apps/reference/volume_reference.h>
#include <test_size.h>
#include <volume/make_volume.h>
#include <volume/rays.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

using namespace isocast;
using namespace isocast::reference;

TEST_CASE("marmitt in double finds the first crossing of random volumes", "[property]") {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> unit(0, 1);
  std::int64_t hits = 0, badly_conditioned = 0;
  for (std::int64_t n = 0, count = test::cases(20, 2000); n < count; ++n) {
    const auto volume =
        test::make_volume({9, 8, 7}, SampleType::f32, [&](auto, auto, auto) { return unit(random); });
    const VolumeReference reference(volume, {0.5});
    VolumeSurfaceOptions options = test::surface_options(0.5);
    options.double_precision = true;
    const VolumeSurface surface(volume, options);
    const auto s = test::make_streams();
    for (int i = 0; i < 64; ++i) {
      const Double3 o = {unit(random) * 8, unit(random) * 7, unit(random) * 6};
      test::add_ray(s->rays, o, test::awkward_direction(random, o));
    }
    TraceCounts counts;
    surface.first_hit(s->rays, s->hits, counts);
    for (int i = 0; i < s->rays.size; ++i) {
      const Double3 o = {s->rays.ox[i], s->rays.oy[i], s->rays.oz[i]},
                    d = {s->rays.dx[i], s->rays.dy[i], s->rays.dz[i]};
      const RayTruth truth = reference.solve(o, d, 0, 1e9);
      REQUIRE(truth.decided());
      const auto first = std::ranges::find(truth.roots, true, &RayRoot::crossing);
      INFO("volume " << n << " ray " << i);
      // what rounding may decide either way: the first root is nearly double
      if (first != truth.roots.end() && first->condition > 1e5) {
        ++badly_conditioned;
        continue;
      }
      REQUIRE((s->hits.t[i] < std::numeric_limits<double>::infinity()) == (first != truth.roots.end()));
      if (first == truth.roots.end()) continue;
      REQUIRE(std::abs(s->hits.t[i] - first->lo) * length(d) <= 1e-9);
      ++hits;
    }
  }
  CHECK(hits > 500);
  CHECK(badly_conditioned < hits / 100);
}
