// Object order gives the bits of the walk: the same hits for every primary ray, whatever camera looks.
#include <isocast/ray/clipped_surface.h>
#include <isocast/render/camera.h>
#include <test_size.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "same_hits.h"
#include "test_fields.h"

using namespace isocast;
using namespace isocast::test;

namespace {

// Compares all blocks of a view; returns the number of hits.
std::int64_t compare(const Surface& surface, const View& view, double u = 0.5, double v = 0.5,
                     double bound = std::numeric_limits<double>::infinity()) {
  const std::unique_ptr<PrimaryPass> pass = surface.primary(view);
  REQUIRE(pass);
  const auto rays = std::make_unique<RayStream>();
  const auto expected = std::make_unique<HitStream>(), none = std::make_unique<HitStream>();
  const auto block = std::make_unique<BlockHits>();
  std::int64_t hits = 0;
  const auto prepare = [&](HitStream& stream) {  // what another object has hit
    for (int i = 0; i < kStreamSize; i += 3) {
      stream.t[i] = bound;
      stream.object[i] = 7;
    }
  };
  const int block_pixels = kBlockTiles * kTileSize;
  for (int by = 0; by * block_pixels < view.height(); ++by)
    for (int bx = 0; bx * block_pixels < view.width(); ++bx) {
      TraceCounts counts;
      block->reset(surface.proves());
      if (std::isfinite(bound))
        for (int t = 0; t < kBlockStreams; ++t) prepare(block->tile(t % kBlockTiles, t / kBlockTiles));
      pass->first_hits(bx, by, u, v, *block, counts);
      for (int t = 0; t < kBlockStreams; ++t) {
        const int x = t % kBlockTiles, y = t / kBlockTiles;
        view.fill(bx * kBlockTiles + x, by * kBlockTiles + y, u, v, *rays);
        clear(*expected);
        if (surface.proves()) std::ranges::fill(expected->certificate, Certificate::proved_miss);
        if (std::isfinite(bound)) prepare(*expected);
        surface.first_hit(*rays, *expected, counts);
        const HitStream* found = block->is_open(x, y) ? &block->tile(x, y) : nullptr;
        if (!found) {
          clear(*none);
          if (surface.proves()) std::ranges::fill(none->certificate, Certificate::proved_miss);
          found = none.get();
        }
        const int slot = first_difference(*expected, *found);
        if (slot >= 0) {
          INFO("slot " << slot << ": t " << expected->t[slot] << " and " << found->t[slot] << ", cells "
                       << expected->cell[0][slot] << ' ' << expected->cell[1][slot] << ' '
                       << expected->cell[2][slot] << " and " << found->cell[0][slot] << ' '
                       << found->cell[1][slot] << ' ' << found->cell[2][slot]);
          REQUIRE(slot == -1);
        }
        for (int i = 0; i < kStreamSize; ++i) hits += found->object[i] == 0;
      }
    }
  return hits;
}

// Cameras far and near, inside, behind, looking along axes, perspective and orthographic.
Camera random_camera(std::mt19937_64& random, const Box& box) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto pick = [&](unsigned n) { return random() % n; };
  const double reach = box.diagonal() * (pick(3) == 0 ? 0.2 : pick(2) ? 0.6 : 2.5);
  Camera camera;
  camera.position = box.center() + reach * Double3{unit(random), unit(random), unit(random)};
  camera.target =
      pick(3) ? box.center() : camera.position + Double3{unit(random), unit(random), unit(random)};
  camera.up = {unit(random), unit(random), 1};
  camera.fov = pick(4) ? 20 + 60 * std::abs(unit(random)) : 150;
  if (pick(4) == 0) {  // onto samples, along an axis or a diagonal
    for (double& x : camera.position) x = std::round(x);
    camera.target = camera.position;
    camera.target[pick(3)] += pick(2) ? 1 : -1;
    if (pick(2)) camera.target[pick(3)] += 1;
    camera.up = {0.3, 0.5, 0.8};
    if (length(camera.target - camera.position) == 0) camera.target[0] += 1;
  }
  if (pick(3) == 0) camera.ortho_height = box.diagonal() * (pick(2) ? 1 : 0.15);
  return camera;
}

// What lies below a plane, all of it sure; it cuts no rays.
class Below final : public Region {
 public:
  Below(const Double3& normal, double level) : normal_(normal), level_(level) {}
  void locate(const RayStream& rays, const HitStream& hits, Place (&places)[kStreamSize]) const override {
    for (int i = 0; i < rays.size; ++i) {
      const Double3 o = {rays.ox[i], rays.oy[i], rays.oz[i]}, d = {rays.dx[i], rays.dy[i], rays.dz[i]};
      places[i] = {dot(normal_, o + hits.t[i] * d) < level_, true};
    }
  }

 private:
  Double3 normal_;
  double level_;
};

}  // namespace

TEST_CASE("random cameras: every ray has the hit of the walk", "[property]") {
  std::mt19937_64 random(11);
  const auto smooth = make_volume(kDims, SampleType::f32, wavy),
             noise = make_volume(kDims, SampleType::u8, rough),
             plane = make_volume(kDims, SampleType::i16, flat),
             holes = with_holes(make_volume(kDims, SampleType::f32, wavy)),
             wide = make_volume(kDims, SampleType::f64, wavy);
  struct Case {
    std::shared_ptr<Volume> volume;
    std::vector<double> iso;
    const char* method;
    bool precise = false;
  };
  const std::vector<Case> cases = {
      {smooth, {41}, "marmitt"},          {smooth, {60, 20, 41}, "marmitt"},
      {smooth, {41}, "neubauer"},         {smooth, {41}, "linear", true},
      {smooth, {41}, "schwarze"},         {smooth, {41, 42}, "certified"},
      {noise, {63.5}, "marmitt"},         {noise, {10, 63.5, 64, 100}, "midpoint"},
      {noise, {63.5}, "certified"},       {plane, {50}, "marmitt"},
      {plane, {50, 51}, "marmitt", true}, {holes, {41}, "marmitt"},
      {holes, {41}, "certified"},         {wide, {41}, "marmitt", true}};
  std::int64_t hits = 0;
  for (std::int64_t round = 0; round < test::cases(140, 20000); ++round) {
    const Case& c = cases[static_cast<std::size_t>(round) % cases.size()];
    VolumeSurfaceOptions options =
        surface_options(0, available_isas()[random() % available_isas().size()], c.method);
    options.iso = c.iso;
    options.double_precision = c.precise;
    const VolumeSurface surface(c.volume, options);
    const View view(random_camera(random, surface.bounds()), 150, 90 + 30 * int(random() % 2));
    INFO("round " << round << ", " << c.method << ", " << name_of(options.isa));
    const double bound = random() % 4 ? std::numeric_limits<double>::infinity() : surface.bounds().diagonal();
    hits += compare(surface, view, random() % 2 ? 0.5 : 0.0, 0.5, bound);
  }
  CHECK(hits > 1000 * test::cases(140, 20000));
}

TEST_CASE("sparse grids: every ray has the hit of the walk") {
  std::mt19937_64 random(13);
  std::int64_t hits = 0;
  for (const SparseType type : {SparseType::f32, SparseType::i16, SparseType::f64})
    for (const std::vector<double>& iso : {std::vector<double>{41}, {20, 41, 55}})
      for (const char* method : {"marmitt", "certified"}) {
        VolumeSurfaceOptions options = surface_options(0, widest_isa(), method);
        options.iso = iso;
        const VolumeSurface surface(patchy_tree(type), options);
        Box near;
        near.add(Double3{-16, -24, -16});
        near.add(Double3{40, 24, 32});
        for (int round = 0; round < 4; ++round) {
          const View view(random_camera(random, round % 4 ? near : surface.bounds()), 170, 160);
          INFO("round " << round << ", " << method);
          if (surface.primary(view)) hits += compare(surface, view);
        }
      }
  CHECK(hits > 50000);
}

TEST_CASE("clipped volumes: every ray has the hit of the walk") {
  std::mt19937_64 random(14);
  std::int64_t hits = 0;
  for (const char* method : {"marmitt", "certified"}) {
    VolumeSurfaceOptions options = surface_options(0, widest_isa(), method);
    options.iso = {20, 41};
    const auto whole = std::make_shared<VolumeSurface>(make_volume(kDims, SampleType::f32, wavy), options);
    const Double3 middle = whole->bounds().center();
    for (int round = 0; round < 10; ++round) {
      std::uniform_real_distribution<double> unit(-1, 1);
      const Double3 normal = {unit(random), unit(random), unit(random)};
      const ClippedSurface surface(whole, {std::make_shared<Below>(normal, dot(normal, middle))}, 0);
      INFO("round " << round << ", " << method);
      hits += compare(surface, View(random_camera(random, surface.bounds()), 150, 120));
    }
  }
  CHECK(hits > 20000);
}

TEST_CASE("where bricks are many and pixels few the walk is left alone") {
  const VolumeSurface surface(make_volume({200, 200, 200}, SampleType::u8, rough), surface_options(64));
  const Camera camera = frame(surface.bounds(), {}, 1);
  CHECK_FALSE(surface.primary(View(camera, 64, 64)));
  CHECK(surface.primary(View(camera, 1024, 1024)));
}

TEST_CASE("grids that are turned, sheared and mirrored: every ray has the hit of the walk") {
  std::mt19937_64 random(12);
  const auto volume = make_volume(kDims, SampleType::u16, wavy);
  for (const Transform& transform :
       {Transform{{{0.5, 0.2, -0.1, 3}, {-0.3, 0.8, 0.2, 100}, {0, 0.1, 2.5, -7}}},
        Transform{{{-1, 0, 0, 0}, {0, 0, 1e-3, 5}, {0, 1e3, 0, 5}}}}) {
    volume->world_from_grid = transform;
    const VolumeSurface surface(volume, surface_options(41));
    for (int round = 0; round < 6; ++round) {
      const View view(random_camera(random, surface.bounds()), 130, 70);
      compare(surface, view);
    }
  }
}

TEST_CASE("masks follow the iso-values, and the answers with them") {
  VolumeSurfaceOptions options = surface_options(41);
  VolumeSurface surface(make_volume(kDims, SampleType::f32, wavy), options);
  const View view(frame(surface.bounds(), {}, 1), 96, 96);
  for (const std::vector<double>& iso : {std::vector<double>{41}, {55, 41}, {55}, {20, 55, 80}, {41}}) {
    options.iso = iso;
    surface.set_options(options);
    CHECK(compare(surface, view) > 1000);
  }
}

TEST_CASE("cameras beyond all measure are left to the walk") {
  const VolumeSurface surface(make_volume(kDims, SampleType::u8, wavy), surface_options(41));
  Camera camera;
  camera.target = {1, 2, 3};
  camera.up = {0, 0, 1};
  for (const double far : {1e14, 1e30, 1e200}) {
    camera.position = {far, 0.3 * far, 0};
    CHECK_FALSE(surface.primary(View(camera, 16, 16)));
  }
}
