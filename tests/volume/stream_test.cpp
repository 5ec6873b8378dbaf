// Streams in any order give the bits of the walk, ray for ray: first hits, those behind them, and rays that
// start on the surface.
#include <isocast/isa/cpu.h>
#include <isocast/volume/sure_hits.h>
#include <test_size.h>

#include <catch2/catch.hpp>

#include "random_streams.h"
#include "test_fields.h"

using namespace isocast;
using namespace isocast::test;

namespace {

std::int64_t compare(std::mt19937_64& random, const std::shared_ptr<Volume>& volume, const Box& near,
                     VolumeSurfaceOptions options) {
  const VolumeSurface stream(volume, options);
  options.order = RayOrder::walk;
  const VolumeSurface walk(volume, options);
  const std::unique_ptr<Streams> asked = make_streams();
  fill_random(random, near.empty() ? walk.bounds() : near, *asked);
  return compare_hits(random, walk, stream, *asked, 2);
}

// What is asked of the blocks of a dense volume.
VolumeQuery query_of(const Volume& volume, const MacroCells& ranges, const std::vector<double>& iso) {
  VolumeQuery query = {};
  query.grid.type = volume.type;
  for (int i = 0; i < kMacroLevels; ++i) query.grid.levels[i] = ranges.level(i);
  const Transform grid_from_world = volume.world_from_grid.inverse();
  for (int a = 0; a < 3; ++a) {
    query.samples.last[a] = static_cast<std::int32_t>(volume.dims[static_cast<std::size_t>(a)]) - 1;
    std::copy_n(grid_from_world.m[a], 4, query.grid_from_world[a]);
  }
  for (const double value : iso)
    query.key[query.iso_count++] = iso_key(volume.type, (value - volume.intercept) / volume.slope, false);
  return query;
}

}  // namespace

TEST_CASE("dense grids: every ray has the hits of the walk", "[property]") {
  std::mt19937_64 random(21);
  const auto smooth = make_volume(kDims, SampleType::f32, wavy),
             noise = make_volume(kDims, SampleType::u8, rough),
             plane = make_volume(kDims, SampleType::i16, flat),
             holes = with_holes(make_volume(kDims, SampleType::f32, wavy)),
             wide = make_volume(kDims, SampleType::f64, wavy),
             thin = make_volume({2, 300, 3}, SampleType::u8, rough),
             tall = make_volume({30, 25, 700}, SampleType::u8, wavy);  // three levels of cubes of bricks
  struct Case {
    std::shared_ptr<Volume> volume;
    std::vector<double> iso;
    const char* method;
    bool precise = false;
  };
  const std::vector<Case> cases = {
      {smooth, {41}, "marmitt"},
      {smooth, {60, 20, 41}, "marmitt"},
      {smooth, {41}, "linear", true},
      {smooth, {41, 42}, "certified"},
      {noise, {63.5}, "marmitt"},
      {noise, {10, 63.5, 64, 100}, "midpoint"},
      {noise, {90, 5, 15, 25, 35, 45, 55, 65, 75, 85, 95, 105, 115, 4, 3, 2}, "marmitt"},
      {noise, {63.5}, "certified"},
      {plane, {50}, "marmitt"},
      {plane, {50, 51}, "neubauer", true},
      {holes, {41}, "marmitt"},
      {holes, {41}, "certified"},
      {wide, {41}, "schwarze", true},
      {thin, {63.5}, "marmitt"},
      {tall, {41}, "marmitt"}};
  std::int64_t hits = 0;
  const std::int64_t rounds = test::cases(1300, 130000);
  for (std::int64_t round = 0; round < rounds; ++round) {
    const Case& c = cases[static_cast<std::size_t>(round) % cases.size()];
    VolumeSurfaceOptions options =
        surface_options(0, available_isas()[random() % available_isas().size()], c.method);
    options.iso = c.iso;
    options.double_precision = c.precise;
    INFO("round " << round << ", " << c.method << ", " << name_of(options.isa));
    hits += compare(random, c.volume, {}, options);
  }
  CHECK(hits > 100 * rounds);
}

TEST_CASE("rays that are blocked for sure are blocked, and are many where a solid is thick", "[property]") {
  std::mt19937_64 random(8);
  const auto thick = [](std::int64_t i, std::int64_t j, std::int64_t k) {
    return 50 + 40 * std::sin(0.12 * double(i)) * std::cos(0.11 * double(j)) * std::sin(0.13 * double(k) + 1);
  };
  int sure = 0, blocked = 0;
  for (const SampleType type : {SampleType::f32, SampleType::u8, SampleType::i32, SampleType::f16}) {
    const auto volume = make_volume({70, 61, 83}, type, thick);
    const MacroCells ranges(*volume);
    REQUIRE(ranges.finite());
    for (const std::vector<double>& iso : {std::vector<double>{52.5}, {45.5, 60, 55}}) {
      VolumeSurfaceOptions options;
      options.iso = iso;
      const VolumeSurface stream(volume, options);
      options.order = RayOrder::walk;
      const VolumeSurface walk(volume, options);
      const VolumeQuery query = query_of(*volume, ranges, iso);
      for (std::int64_t n = test::cases(40, 4000); n > 0; --n) {
        const std::unique_ptr<Streams> asked = make_streams(), left = make_streams();
        fill_random(random, walk.bounds(), *asked);
        TraceCounts counts;
        walk.first_hit(asked->rays, asked->hits, counts);
        leave(random, *asked, *left);
        if (left->rays.size == 0) continue;
        bool sure_hit[kStreamSize] = {};
        sure += find_sure_hits(query, left->rays, sure_hit, counts);
        walk.first_hit(left->rays, left->hits, counts);
        for (int i = 0; i < left->rays.size; ++i) {
          blocked += left->hits.t[i] < Box::inf;
          if (sure_hit[i]) REQUIRE(left->hits.t[i] < Box::inf);
        }
        compare_any(walk, stream, left->rays);
      }
    }
  }
  CHECK(blocked > 5000);
  CHECK(sure > 0.2 * blocked);
  // f need not be continuous where samples are not finite
  CHECK(!MacroCells(*with_holes(make_volume(kDims, SampleType::f32, wavy))).finite());
}

// Up to its nearest root a ray is on the side of every other iso-value that the root's own value is on.
TEST_CASE("the sides in front of a first hit follow the order of the iso-values") {
  std::mt19937_64 random(25);
  VolumeSurfaceOptions options = surface_options(0);
  options.iso = {70, 20, 110, 41, 5, 64, 90, 64.5};
  for (const RayOrder order : {RayOrder::automatic, RayOrder::walk}) {
    options.order = order;
    const VolumeSurface surface(make_volume(kDims, SampleType::u8, rough), options);
    std::int64_t hits = 0;
    for (int round = 0; round < 100; ++round) {
      const std::unique_ptr<Streams> asked = make_streams();
      fill_random(random, surface.bounds(), *asked);
      TraceCounts counts;
      surface.first_hit(asked->rays, asked->hits, counts);
      for (int i = 0; i < asked->rays.size; ++i) {
        const HitStream& found = asked->hits;
        if (found.object[i] != 0 || found.certificate[i] == Certificate::undecided) continue;
        ++hits;
        for (std::size_t iso = 0; iso < options.iso.size(); ++iso)
          if (iso != found.iso[i])
            REQUIRE((found.sides[i] >> iso & 1) == (options.iso[found.iso[i]] < options.iso[iso]));
      }
    }
    CHECK(hits > 3000);
  }
}

TEST_CASE("sparse grids: every ray has the hits of the walk", "[property]") {
  std::mt19937_64 random(22);
  Box near;
  near.add(Double3{-16, -24, -16});
  near.add(Double3{40, 24, 32});
  std::int64_t hits = 0;
  for (const SparseType type : {SparseType::f32, SparseType::i16, SparseType::f64})
    for (const std::vector<double>& iso : {std::vector<double>{41}, {20, 41, 55}})
      for (const char* method : {"marmitt", "certified"})
        for (const Isa isa : available_isas()) {
          VolumeSurfaceOptions options = surface_options(0, isa, method);
          options.iso = iso;
          const std::shared_ptr<Volume> tree = patchy_tree(type);
          for (int round = 0; round < 4; ++round) {
            INFO("round " << round << ", " << method << ", " << name_of(isa));
            hits += compare(random, tree, round % 4 ? near : Box{}, options);
          }
        }
  CHECK(hits > 20000);
}

TEST_CASE("sheared grids: every ray has the hits of the walk") {
  std::mt19937_64 random(23);
  const auto volume = make_volume(kDims, SampleType::u16, wavy);
  for (const Transform& transform :
       {Transform{{{0.5, 0.2, -0.1, 3}, {-0.3, 0.8, 0.2, 100}, {0, 0.1, 2.5, -7}}},
        Transform{{{-1, 0, 0, 0}, {0, 0, 1e-3, 5}, {0, 1e3, 0, 5}}}}) {
    volume->world_from_grid = transform;
    for (int round = 0; round < 20; ++round) compare(random, volume, {}, surface_options(41));
  }
}

TEST_CASE("leaves that are far apart are left to the walk") {
  TreeMaker maker(SparseType::f32, 0);
  for (const std::int32_t place : {0, 1 << 20})
    for (int n = 0; n < 512; ++n)
      maker.set({place + (n & 7), place + (n >> 3 & 7), place + (n >> 6)}, n & 1, true);
  std::mt19937_64 random(24);
  Box near;
  near.add(Double3{0, 0, 0});
  near.add(Double3{8, 8, 8});
  CHECK(compare(random, maker.volume(), near, surface_options(0.5)) > 100);
}
