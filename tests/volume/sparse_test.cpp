// Sparse grids: a tree gives the surface of the dense grid with the same samples, in the cells that exist.
#include <isocast/volume/sample.h>
#include <isocast/volume/volume_surface.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <ostream>

#include "make_tree.h"
#include "make_volume.h"
#include "rays.h"

using namespace isocast;
using namespace isocast::test;

namespace {

const double kNan = std::nan("");

double noise(std::int64_t i, std::int64_t j, std::int64_t k) {
  std::uint64_t x = static_cast<std::uint64_t>(i + 1000 * j + 1000000 * k) * 0x9e3779b97f4a7c15u;
  x ^= x >> 29;
  x *= 0xbf58476d1ce4e5b9u;
  return static_cast<double>(x >> 40 & 127);
}

// A segment between two points of a box, with coordinates that a shift of the grid leaves exact.
void add_segment(RayStream& rays, std::mt19937_64& random, const GridPoint& lo, std::int32_t n) {
  const auto point = [&] {
    Double3 p;
    for (int a = 0; a < 3; ++a) {
      p[a] = lo[static_cast<std::size_t>(a)] +
             static_cast<double>(random() % (static_cast<unsigned>(n) << 10)) / 1024;
      if (random() % 8 == 0) p[a] = std::floor(p[a]);
    }
    return p;
  };
  const Double3 from = point(), to = point();
  // inside a face between cells, whose field a ray takes there depends on where the grid ends
  for (int a = 0; a < 3; ++a)
    if (from[a] == to[a] && from[a] == std::floor(from[a])) return;
  add_ray(rays, from, to - from, 1);
}

struct Crossing {
  double t, t_lo, t_hi;
  GridPoint cell;
  int iso;
  bool operator==(const Crossing&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Crossing& c) {
  return out << "t " << c.t << " in cell " << c.cell[0] << " " << c.cell[1] << " " << c.cell[2] << " iso "
             << c.iso;
}
using Crossings = std::vector<std::vector<Crossing>>;

// All crossings of every ray, in order. `origin` is added to the cells.
Crossings crossings(const VolumeSurface& surface, const RayStream& rays, const GridPoint& origin = {}) {
  Crossings lists(static_cast<std::size_t>(rays.size));
  HitStream hits;
  clear(hits);
  TraceCounts counts;
  surface.first_hit(rays, hits, counts);
  for (bool some = true; some;) {
    some = false;
    for (int i = 0; i < rays.size; ++i) {
      if (std::isinf(hits.t[i])) continue;
      lists[static_cast<std::size_t>(i)].push_back(
          {hits.t[i],
           hits.t_lo[i],
           hits.t_hi[i],
           {hits.cell[0][i] + origin[0], hits.cell[1][i] + origin[1], hits.cell[2][i] + origin[2]},
           hits.iso[i]});
      some = true;
    }
    surface.next_hit(rays, hits, counts);
  }
  return lists;
}

VolumeSurfaceOptions two_isos(bool precise) {
  VolumeSurfaceOptions options = surface_options(40);
  options.iso = {40, 64.5};
  options.double_precision = precise;
  return options;
}

// Leaves, tiles of every size and background of few whole numbers, active or not, some NaN, around `corner`,
// a corner of all kinds of blocks.
TreeMaker random_tree(SparseType type, std::mt19937_64& random, const GridPoint& corner) {
  const auto value = [&] { return static_cast<double>(random() % 6) * 20; };
  const bool has_nan = type == SparseType::f32 || type == SparseType::f64;
  TreeMaker tree(type, value());
  const auto block_at = [&](int side, std::int32_t edge) {
    GridPoint p = corner;
    for (std::size_t a = 0; a < 3; ++a)
      if (!(side >> a & 1)) p[a] -= 1 << edge;
    return p;
  };
  for (int side = 0; side < 8; ++side) {
    const auto kind = random() % 4;
    if (kind == 0) continue;  // background
    if (kind == 1) {
      tree.tile(block_at(side, 12), 12, value(), random() % 2);
    } else if (kind == 2) {
      tree.tile(block_at(side, 7), 7, value(), random() % 2);
    } else {
      const GridPoint near = block_at(side, 3);
      for (int b = 0; b < 27; ++b) {  // the three blocks nearest to the corner along each axis
        GridPoint p = near;
        const int steps[3] = {b % 3, b / 3 % 3, b / 9};
        for (std::size_t a = 0; a < 3; ++a) p[a] += (side >> a & 1 ? 8 : -8) * steps[a];
        if (random() % 3 == 0) {
          tree.tile(p, 3, value(), random() % 2);
        } else if (random() % 2) {
          const bool dense = random() % 2;
          for (int n = 0; n < kLeafSamples; ++n) {
            const double v = has_nan && random() % 64 == 0 ? kNan : value();
            tree.set({p[0] + (n >> 6), p[1] + (n >> 3 & 7), p[2] + (n & 7)}, v, dense || random() % 4 == 0);
          }
        }
      }
    }
  }
  return tree;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("a tree with all samples active has the bits of the dense grid", "",
                       ((SparseType sparse, SampleType dense), sparse, dense),
                       (SparseType::f32, SampleType::f32), (SparseType::f64, SampleType::f64),
                       (SparseType::i16, SampleType::i16), (SparseType::i32, SampleType::i32),
                       (SparseType::i64, SampleType::f64)) {
  std::mt19937_64 random(1);
  // the border of the active samples holds no surface: its cells have corners outside, beyond every iso-value
  const auto f = [](std::int64_t i, std::int64_t j, std::int64_t k) {
    return i == 0 || j == 0 || k == 0 || i == 20 || j == 17 || k == 18 ? 0 : noise(i, j, k);
  };
  for (const bool precise : {false, true}) {
    const VolumeSurface expected(make_volume({21, 18, 19}, dense, f), two_isos(precise)),
        surface(make_full_tree({21, 18, 19}, sparse, 0, f), two_isos(precise));
    for (int n = 0; n < 10; ++n) {
      const auto s = make_streams();
      while (s->rays.size < kStreamSize) add_segment(s->rays, random, {-5, -5, -5}, 32);
      REQUIRE(crossings(surface, s->rays) == crossings(expected, s->rays));
    }
  }
}

TEMPLATE_TEST_CASE_SIG("random trees have the crossings of their dense samples in the cells that exist", "",
                       ((SparseType sparse, SampleType dense), sparse, dense),
                       (SparseType::f32, SampleType::f32), (SparseType::f64, SampleType::f64),
                       (SparseType::i16, SampleType::i16), (SparseType::i32, SampleType::i32),
                       (SparseType::i64, SampleType::f64)) {
  std::mt19937_64 random(2);
  constexpr std::int32_t kReach = 26;
  std::size_t found = 0, left_out = 0;
  for (int round = 0; round < 24; ++round) {
    const GridPoint corner = round % 3 == 0   ? GridPoint{0, 0, 0}
                             : round % 3 == 1 ? GridPoint{4096, -4096, 8192}
                                              : GridPoint{-128, 4224, 136},
                    lo = {corner[0] - kReach, corner[1] - kReach, corner[2] - kReach};
    const TreeMaker tree = random_tree(sparse, random, round % 3 == 2 ? GridPoint{0, 4096, 0} : corner);
    const auto volume = tree.volume();
    if (volume->tree->active_count() == 0) continue;
    const auto dense_volume =
        make_volume({2 * kReach, 2 * kReach, 2 * kReach}, dense, [&](auto i, auto j, auto k) {
          return tree
              .at({lo[0] + static_cast<std::int32_t>(i), lo[1] + static_cast<std::int32_t>(j),
                   lo[2] + static_cast<std::int32_t>(k)})
              .value;
        });
    for (int a = 0; a < 3; ++a) dense_volume->world_from_grid.m[a][3] = lo[static_cast<std::size_t>(a)];
    const VolumeSurface surface(volume, two_isos(round % 2)), all(dense_volume, two_isos(round % 2));

    const auto exists = [&](const GridPoint& c) {
      bool active = false;
      for (int k = 0; k < 8; ++k) {
        const TreeMaker::Sample sample = tree.at({c[0] + (k & 1), c[1] + (k >> 1 & 1), c[2] + (k >> 2)});
        if (std::isnan(sample.value)) return false;
        active = active || sample.active;
      }
      return active;
    };
    const auto s = make_streams();
    while (s->rays.size < kStreamSize) add_segment(s->rays, random, lo, 2 * kReach - 1);
    Crossings expected = crossings(all, s->rays, lo);
    for (auto& list : expected)
      left_out += std::erase_if(list, [&](const Crossing& c) { return !exists(c.cell); });
    const Crossings got = crossings(surface, s->rays);
    for (std::size_t i = 0; i < got.size(); ++i) {
      INFO("round " << round << " ray " << i);
      REQUIRE(got[i] == expected[i]);
      found += got[i].size();
    }
  }
  CHECK(found > 5000);
  CHECK(left_out > 1000);
}

TEST_CASE("codes stand for the floats that they decode to") {
  std::mt19937_64 random(3);
  struct Kind {
    SparseType type;
    int bits;
  };
  for (const Kind& kind : {Kind{SparseType::fp4, 4}, Kind{SparseType::fp8, 8}, Kind{SparseType::fp16, 16},
                           Kind{SparseType::fpn, 1}, Kind{SparseType::fpn, 2}, Kind{SparseType::fpn, 4},
                           Kind{SparseType::fpn, 8}, Kind{SparseType::fpn, 16}}) {
    INFO(name_of(kind.type) << " " << kind.bits);
    const std::size_t size = leaf_bytes(kind.type, kind.bits);
    REQUIRE(size == 16 + 64 * static_cast<std::size_t>(kind.bits));
    auto buffer = std::make_shared<std::vector<std::byte>>(2 * (size + 64), std::byte(255));
    std::vector<SparseLeaf> leaves;
    TreeMaker floats(SparseType::f32, 7);
    for (std::int32_t l = 0; l < 2; ++l) {
      std::byte* const values = buffer->data() + static_cast<std::size_t>(l) * (size + 64);
      const float minimum = 10 + 3 * static_cast<float>(l),
                  quantum = 77.0f / static_cast<float>((1 << kind.bits) - 1);
      std::memcpy(values, &minimum, 4);
      std::memcpy(values + 4, &quantum, 4);
      for (std::size_t i = 16; i < size; ++i) values[i] = std::byte(random() & 255);
      leaves.push_back({values, values + size, {0, 8 * l, 0}, kind.bits});
      for (int n = 0; n < kLeafSamples; ++n) {
        unsigned code = 0;  // bit by bit
        for (int b = 0; b < kind.bits; ++b) {
          const int at = n * kind.bits + b;
          code |= (static_cast<unsigned>(values[16 + at / 8]) >> at % 8 & 1) << b;
        }
        floats.set({n >> 6, (n >> 3 & 7) + 8 * l, n & 7}, static_cast<float>(code) * quantum + minimum, true);
      }
    }
    auto coded = std::make_shared<Volume>();
    coded->tree = std::make_shared<SparseTree>(kind.type, bits_in(kind.type, 7), leaves,
                                               std::span<const TileBlock>(), buffer);
    const VolumeSurface surface(coded, two_isos(false)), expected(floats.volume(), two_isos(false));
    const auto s = make_streams();
    while (s->rays.size < kStreamSize) add_segment(s->rays, random, {-4, -4, -4}, 24);
    const Crossings got = crossings(surface, s->rays);
    REQUIRE(got == crossings(expected, s->rays));
    CHECK(std::ranges::any_of(got, [](const auto& list) { return !list.empty(); }));
  }
}

TEST_CASE("the surface of a fog closes outside its active samples, where the background takes over") {
  TreeMaker fog(SparseType::f32, 0);
  for (std::int32_t i = 0; i < 4; ++i)
    for (std::int32_t j = 0; j < 4; ++j)
      for (std::int32_t k = 0; k < 4; ++k) fog.set({i, j, k}, 1, true);
  const VolumeSurface surface(fog.volume(), surface_options(0.25));
  auto s = make_streams();
  add_ray(s->rays, {-9, 1.5, 1.5}, {1, 0, 0});
  const Crossings got = crossings(surface, s->rays);
  REQUIRE(got[0].size() == 2);
  CHECK(got[0][0].t == Approx(9 - 0.75));
  CHECK(got[0][1].t == Approx(9 + 3.75));
}

TEST_CASE("without an active corner there is no cell, whatever the values") {
  TreeMaker tree(SparseType::f32, 0);
  for (std::int32_t i = 0; i < 8; ++i) tree.set({i, 3, 3}, 1, false);
  tree.set({7, 7, 7}, 0, true);
  const VolumeSurface surface(tree.volume(), surface_options(0.5));
  auto s = make_streams();
  add_ray(s->rays, {3.5, 3.25, -9}, {0, 0, 1});
  CHECK(crossings(surface, s->rays)[0].empty());
  const VolumeSurface nothing(TreeMaker(SparseType::f32, 1).volume(), surface_options(0.5));
  CHECK(nothing.bounds().empty());
  CHECK(crossings(nothing, s->rays)[0].empty());
}

TEST_CASE("a tree knows its active samples") {
  TreeMaker tree(SparseType::i32, 5);
  tree.set({-3, 9, 70}, 1, true);
  tree.set({-5, 10, 71}, 1, true);
  tree.set({-8, 8, 64}, 1, false);
  const auto volume = tree.volume();
  CHECK(volume->tree->active_count() == 2);
  CHECK(volume->tree->first_active() == GridPoint{-5, 9, 70});
  CHECK(volume->tree->last_active() == GridPoint{-3, 10, 71});
  tree.tile({4096, 0, 0}, 12, 3, true);
  tree.tile({0, 0, 0}, 7, 3, false);
  CHECK(tree.volume()->tree->active_count() == 2 + 4096.0 * 4096 * 4096);
  CHECK(tree.volume()->tree->last_active() == GridPoint{8191, 4095, 4095});
}

TEST_CASE("parts that make no tree are refused") {
  const std::vector<std::byte> bytes(2048 + 64);
  const auto leaf = [&](GridPoint o) {
    return SparseLeaf{bytes.data(), bytes.data() + 2048, {o[0], o[1], o[2]}, 0};
  };
  const auto make = [](std::vector<SparseLeaf> leaves, std::vector<TileBlock> tiles) {
    return SparseTree(SparseType::f32, 0, leaves, tiles, nullptr);
  };
  CHECK_NOTHROW(make({leaf({0, 0, 0}), leaf({8, 0, 0})}, {}));
  CHECK_THROWS_AS(make({leaf({0, 0, 0}), leaf({0, 0, 0})}, {}), SparseTreeError);
  CHECK_THROWS_AS(make({leaf({0, 4, 0})}, {}), SparseTreeError);
  CHECK_THROWS_AS(make({leaf({0, 0, 1 << 30})}, {}), SparseTreeError);
  CHECK_THROWS_AS(make({leaf({8, 8, 8})}, {{{0, 0, 0}, 7, {1, 1}}}), SparseTreeError);
  CHECK_THROWS_AS(make({}, {{{0, 0, 0}, 7, {1, 1}}, {{0, 0, 0}, 12, {1, 1}}}), SparseTreeError);
  CHECK_THROWS_AS(make({}, {{{8, 0, 0}, 7, {1, 1}}}), SparseTreeError);
}
