// What `certified` proves of rays through volumes, held against the reference's roots.
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

namespace {

struct Tally {
  std::int64_t hits = 0, misses = 0, undecided = 0;
  [[nodiscard]] double open() const {
    return static_cast<double>(undecided) / static_cast<double>(hits + misses + undecided);
  }
};

VolumeSurface certified(const std::shared_ptr<const Volume>& volume, double iso, bool precise) {
  VolumeSurfaceOptions options = test::surface_options(iso);
  options.method = choose_cell_method("certified", {});
  options.double_precision = precise;
  return {volume, options};
}

// The first hits, then the next ones behind proved hits, against all roots in order.
void compare(const VolumeSurface& surface, const RayReference& reference, const RayStream& rays,
             Tally& tally) {
  HitStream hits;
  clear(hits);
  std::ranges::fill(hits.certificate, Certificate::proved_miss);
  TraceCounts counts;
  surface.first_hit(rays, hits, counts);
  for (int i = 0; i < rays.size; ++i) {
    const Double3 o = {rays.ox[i], rays.oy[i], rays.oz[i]}, d = {rays.dx[i], rays.dy[i], rays.dz[i]};
    RayTruth truth = reference.solve(o, d, 0, 1e9);
    std::erase_if(truth.roots, [](const RayRoot& root) { return root.from_above; });
    INFO(std::hexfloat << "o " << o[0] << " " << o[1] << " " << o[2] << " d " << d[0] << " " << d[1] << " "
                       << d[2]);
    const bool hit = hits.t[i] < std::numeric_limits<double>::infinity();
    if (hits.certificate[i] == Certificate::undecided) {
      ++tally.undecided;
    } else if (!hit) {
      REQUIRE(hits.certificate[i] == Certificate::proved_miss);
      REQUIRE(truth.decided());
      REQUIRE(truth.roots.empty());
      ++tally.misses;
    } else {
      REQUIRE(hits.certificate[i] == Certificate::proved_hit);
      REQUIRE_FALSE(truth.roots.empty());
      const RayRoot& first = truth.roots.front();
      REQUIRE(first.crossing);
      REQUIRE(first.hi >= hits.t_lo[i]);
      REQUIRE(first.lo <= hits.t_hi[i]);
      for (const DoubtfulRange& doubt : truth.doubts) REQUIRE(doubt.hi >= hits.t_lo[i]);
      ++tally.hits;
    }
  }
}

}  // namespace

TEST_CASE("no proof about a ray through a volume is contradicted", "[property]") {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const bool precise : {false, true}) {
    Tally noise, smooth;
    for (std::int64_t n = 0, count = test::cases(30, 3000); n < count; ++n) {
      const bool is_smooth = n % 2 == 0;
      const double turn = 6 * unit(random);
      const auto volume = test::make_volume(
          {12, 11, 10}, n % 3 == 0 ? SampleType::f64 : SampleType::f32, [&](auto x, auto y, auto z) {
            return is_smooth ? 0.5 + 0.5 * std::sin(0.3 * double(x) + turn) * std::cos(0.4 * double(y)) -
                                   0.05 * double(z)
                             : unit(random);
          });
      const VolumeSurface surface = certified(volume, 0.25, precise);
      const VolumeReference reference(volume, {0.25});
      const auto s = test::make_streams();
      while (s->rays.size < 128) {
        // from inside, from around, and from far away
        const double far = s->rays.size % 3 == 0 ? 1 : s->rays.size % 3 == 1 ? 5 : 1e4;
        const Double3 o = {far * (unit(random) * 20 - 8) / 2, far * (unit(random) * 20 - 8) / 2,
                           far * (unit(random) * 20 - 8) / 2};
        const Double3 target = {unit(random) * 11, unit(random) * 10, unit(random) * 9};
        test::add_ray(s->rays, o, far > 1 ? target - o : test::awkward_direction(random, o));
      }
      compare(surface, reference, s->rays, is_smooth ? smooth : noise);
    }
    INFO("undecided: noise " << noise.open() << ", smooth " << smooth.open());
    CHECK(noise.hits > 500);
    CHECK(smooth.hits > 500);
    CHECK(smooth.misses > 100);
    // rays far away and through lattice points are among them
    CHECK(noise.open() < (precise ? 0.005 : 0.01));
    CHECK(smooth.open() < (precise ? 0.005 : 0.01));
  }
}
