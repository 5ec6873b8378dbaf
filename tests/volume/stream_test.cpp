// Streams in any order give the bits of the walk, ray for ray: first hits, those behind them, and rays that
// start on the surface.
#include <isocast/isa/cpu.h>
#include <test_size.h>

#include <catch2/catch.hpp>

#include "rays.h"
#include "same_hits.h"
#include "test_fields.h"

using namespace isocast;
using namespace isocast::test;

namespace {

// Rays from samples, faces, inside and far away, with ends here and there, and what another object has hit.
void fill(std::mt19937_64& random, const Box& box, Streams& streams) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto pick = [&](unsigned n) { return random() % n; };
  clear(streams.hits);
  RayStream& rays = streams.rays;
  rays.size = 0;
  const int count = 1 + static_cast<int>(pick(kStreamSize));
  for (int i = 0; i < count; ++i) {
    const double reach = pick(4) ? 0.6 : pick(3) ? 3 : 1e9;
    Double3 o = box.center() + reach * box.diagonal() * Double3{unit(random), unit(random), unit(random)};
    if (pick(4) == 0)
      for (double& x : o) x = std::round(x);
    if (pick(5) == 0) o[pick(3)] = std::round(o[0]);
    const bool aimed = pick(2);
    const Double3 target =
        box.center() + 0.4 * box.diagonal() * Double3{unit(random), unit(random), unit(random)};
    const Double3 d = aimed ? target - o : awkward_direction(random, o);
    add_ray(rays, o, (pick(3) ? 1.0 : 1e-3) * d);
    if (pick(4) == 0) rays.t_min[i] = 0.3 * std::abs(unit(random));
    if (pick(4) == 0) rays.t_max[i] = std::abs(unit(random));
    if (pick(8) == 0) rays.t_max[i] = rays.t_min[i] - 1;  // no ray
    if (pick(6) == 0) {
      streams.hits.t[i] = std::abs(unit(random));
      streams.hits.object[i] = 7;
    }
  }
}

// Rays that leave the hits, in new directions, from the side they came from.
void leave(std::mt19937_64& random, const Streams& from, Streams& to) {
  clear(to.hits);
  to.rays.size = 0;
  for (int i = 0; i < from.rays.size; ++i) {
    if (from.hits.object[i] != 0) continue;
    const double t = from.hits.t_lo[i];
    const Double3 o = {from.rays.ox[i] + t * from.rays.dx[i], from.rays.oy[i] + t * from.rays.dy[i],
                       from.rays.oz[i] + t * from.rays.dz[i]};
    add_ray(to.rays, o, awkward_direction(random, o));
    to.rays.start_object[to.rays.size - 1] = 0;
    to.rays.start_sides[to.rays.size - 1] = from.hits.sides[i];
  }
}

void require_same(const HitStream& a, const HitStream& b) {
  const int slot = first_difference(a, b);
  INFO("slot " << slot << ": t " << a.t[std::max(slot, 0)] << " and " << b.t[std::max(slot, 0)]);
  REQUIRE(slot == -1);
}

// First hits, three more behind them, and what rays meet that start there; returns the number of all hits.
std::int64_t compare(std::mt19937_64& random, const VolumeSurface& walk, const VolumeSurface& stream,
                     const Streams& asked, int depth) {
  std::int64_t count = 0;
  TraceCounts counts;
  const auto a = std::make_unique<Streams>(asked), b = std::make_unique<Streams>(asked);
  walk.first_hit(a->rays, a->hits, counts);
  stream.first_hit(b->rays, b->hits, counts);
  require_same(a->hits, b->hits);
  if (depth > 0) {
    const std::unique_ptr<Streams> left = make_streams();
    leave(random, *a, *left);
    count += compare(random, walk, stream, *left, depth - 1);
  }
  for (int behind = 0; behind < 3; ++behind) {
    for (int i = 0; i < a->rays.size; ++i) count += a->hits.object[i] == 0 && is_hit(a->hits, i);
    walk.next_hit(a->rays, a->hits, counts);
    stream.next_hit(b->rays, b->hits, counts);
    require_same(a->hits, b->hits);
  }
  return count;
}

std::int64_t compare(std::mt19937_64& random, const std::shared_ptr<Volume>& volume, const Box& near,
                     VolumeSurfaceOptions options) {
  const VolumeSurface stream(volume, options);
  options.order = RayOrder::walk;
  const VolumeSurface walk(volume, options);
  const std::unique_ptr<Streams> asked = make_streams();
  fill(random, near.empty() ? walk.bounds() : near, *asked);
  return compare(random, walk, stream, *asked, 2);
}

}  // namespace

TEST_CASE("dense grids: every ray has the hits of the walk", "[property]") {
  std::mt19937_64 random(21);
  const auto smooth = make_volume(kDims, SampleType::f32, wavy),
             noise = make_volume(kDims, SampleType::u8, rough),
             plane = make_volume(kDims, SampleType::i16, flat),
             holes = with_holes(make_volume(kDims, SampleType::f32, wavy)),
             wide = make_volume(kDims, SampleType::f64, wavy),
             thin = make_volume({2, 300, 3}, SampleType::u8, rough);
  struct Case {
    std::shared_ptr<Volume> volume;
    std::vector<double> iso;
    const char* method;
    bool precise = false;
  };
  const std::vector<Case> cases = {{smooth, {41}, "marmitt"},
                                   {smooth, {60, 20, 41}, "marmitt"},
                                   {smooth, {41}, "linear", true},
                                   {smooth, {41, 42}, "certified"},
                                   {noise, {63.5}, "marmitt"},
                                   {noise, {10, 63.5, 64, 100}, "midpoint"},
                                   {noise, {63.5}, "certified"},
                                   {plane, {50}, "marmitt"},
                                   {plane, {50, 51}, "neubauer", true},
                                   {holes, {41}, "marmitt"},
                                   {holes, {41}, "certified"},
                                   {wide, {41}, "schwarze", true},
                                   {thin, {63.5}, "marmitt"}};
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
