// VolumeSurface: one answer whatever the instruction set, sample type or number of iso-values; all crossings
// in order.
#include <isocast/base/error.h>
#include <isocast/volume/cell/marmitt.h>
#include <isocast/volume/traverse.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "make_tree.h"
#include "make_volume.h"
#include "rays.h"

using namespace isocast;
using namespace isocast::test;

namespace {

double noise(std::int64_t i, std::int64_t j, std::int64_t k) {
  std::uint64_t x = static_cast<std::uint64_t>(i + 1000 * j + 1000000 * k) * 0x9e3779b97f4a7c15u;
  x ^= x >> 29;
  x *= 0xbf58476d1ce4e5b9u;
  return static_cast<double>(x >> 40 & 127);
}

// A stream of awkward rays from in and around a grid of n^3 samples.
std::unique_ptr<Streams> awkward_streams(std::mt19937_64& random, double n) {
  std::uniform_real_distribution<double> around(-0.5 * n, 1.5 * n);
  auto s = make_streams();
  while (s->rays.size < kStreamSize) {
    Double3 o = {around(random), around(random), around(random)};
    if (random() % 4 == 0) o = {std::floor(o[0]), std::floor(o[1]), std::floor(o[2])};
    const Double3 target = {around(random) * 0.5 + 0.25 * n, around(random) * 0.5 + 0.25 * n,
                            around(random) * 0.5 + 0.25 * n};
    add_ray(s->rays, o, random() % 2 ? target - o : awkward_direction(random, o),
            random() % 8 ? std::numeric_limits<double>::infinity() : 1.5);
  }
  return s;
}

void require_same(const HitStream& a, const HitStream& b, int size) {
  for (int i = 0; i < size; ++i) {
    INFO("ray " << i);
    REQUIRE(a.t[i] == b.t[i]);
    REQUIRE(a.cost[i] == b.cost[i]);
    if (std::isinf(a.t[i])) continue;
    REQUIRE(a.t_lo[i] == b.t_lo[i]);
    REQUIRE(a.t_hi[i] == b.t_hi[i]);
    for (int axis = 0; axis < 3; ++axis) REQUIRE(a.cell[axis][i] == b.cell[axis][i]);
    REQUIRE(a.iso[i] == b.iso[i]);
    REQUIRE(a.sides[i] == b.sides[i]);
    REQUIRE(a.certificate[i] == b.certificate[i]);
  }
}

HitStream first_hits(const VolumeSurface& surface, const RayStream& rays) {
  HitStream hits;
  clear(hits);
  TraceCounts counts;
  surface.first_hit(rays, hits, counts);
  return hits;
}

}  // namespace

TEST_CASE("every instruction set gives the same bits") {
  std::mt19937_64 random(1);
  const auto dense = make_volume({19, 22, 18}, SampleType::u8, noise),
             tree = make_full_tree({19, 22, 18}, SparseType::i16, 50, noise);
  for (const char* method : {"midpoint", "linear", "neubauer", "schwarze", "marmitt"})
    for (const auto& volume : {dense, tree}) {
      const bool precise = random() % 2;
      VolumeSurfaceOptions options = surface_options(40, Isa::scalar, method);
      options.iso = {40, 64, 90.5};
      options.double_precision = precise;
      VolumeSurface surface(volume, options);
      for (int n = 0; n < 20; ++n) {
        const auto s = awkward_streams(random, 20);
        options.isa = Isa::scalar;
        surface.set_options(options);
        const HitStream scalar = first_hits(surface, s->rays);
        for (const Isa isa : available_isas()) {
          options.isa = isa;
          surface.set_options(options);
          HitStream hits = first_hits(surface, s->rays), next = scalar;
          INFO(method << " " << name_of(isa));
          require_same(scalar, hits, s->rays.size);
          TraceCounts counts;
          surface.next_hit(s->rays, hits, counts);
          if (isa == Isa::scalar) continue;
          options.isa = Isa::scalar;
          surface.set_options(options);
          surface.next_hit(s->rays, next, counts);
          require_same(next, hits, s->rays.size);
        }
      }
    }
}

TEST_CASE("the sample type does not change the surface of small whole numbers") {
  std::mt19937_64 random(2);
  const auto bytes = make_volume({18, 17, 20}, SampleType::u8, noise);
  for (const bool precise : {false, true}) {
    VolumeSurfaceOptions options = surface_options(51.25);
    options.double_precision = precise;
    const VolumeSurface expected(bytes, options);
    for (const SampleType type : {SampleType::i8, SampleType::u16, SampleType::i16, SampleType::u32,
                                  SampleType::i32, SampleType::f32, SampleType::f64}) {
      const VolumeSurface surface(make_volume({18, 17, 20}, type, noise), options);
      const auto s = awkward_streams(random, 18);
      INFO(name_of(type));
      require_same(first_hits(expected, s->rays), first_hits(surface, s->rays), s->rays.size);
    }
    // f16 holds whole numbers up to 2048: their bits from those of the float
    const VolumeSurface half(
        make_volume({18, 17, 20}, SampleType::f16,
                    [](auto i, auto j, auto k) {
                      const float value = static_cast<float>(noise(i, j, k));
                      return value == 0
                                 ? 0.0
                                 : static_cast<double>((__builtin_bit_cast(std::uint32_t, value) >> 13) -
                                                       (112u << 10));
                    }),
        options);
    const auto s = awkward_streams(random, 18);
    require_same(first_hits(expected, s->rays), first_hits(half, s->rays), s->rays.size);
  }
}

TEST_CASE("the first hit is the first root over all cells, found without walk or macrocells") {
  std::mt19937_64 random(3);
  const std::int32_t n = 7;
  const auto volume = make_volume({n, n, n}, SampleType::u8, noise);
  VolumeSurfaceOptions options = surface_options(60.5);
  options.double_precision = true;
  const VolumeSurface surface(volume, options);
  CellOptions cell_options;
  cell_options.adaptive = true;
  int found = 0;
  for (int round = 0; round < 20; ++round) {
    const auto s = awkward_streams(random, n);
    const HitStream hits = first_hits(surface, s->rays);
    for (int i = 0; i < s->rays.size; ++i) {
      const double o[3] = {s->rays.ox[i], s->rays.oy[i], s->rays.oz[i]},
                   d[3] = {s->rays.dx[i], s->rays.dy[i], s->rays.dz[i]};
      double best = std::numeric_limits<double>::infinity();
      for (int c = 0; c < (n - 1) * (n - 1) * (n - 1); ++c) {
        const int cell[3] = {c % (n - 1), c / (n - 1) % (n - 1), c / ((n - 1) * (n - 1))};
        double t0 = s->rays.t_min[i], t1 = std::numeric_limits<double>::infinity();
        for (int a = 0; a < 3; ++a) {
          if (d[a] == 0) {
            if (o[a] < cell[a] || o[a] > cell[a] + 1) t1 = -1;
            continue;
          }
          const double ta = (cell[a] - o[a]) / d[a], tb = (cell[a] + 1 - o[a]) / d[a];
          t0 = std::max(t0, std::min(ta, tb));
          t1 = std::min(t1, std::max(ta, tb));
        }
        if (!(t0 < t1)) continue;
        Cell<double> q{};
        for (int k = 0; k < 8; ++k)
          q.f[k] = noise(cell[0] + (k & 1), cell[1] + (k >> 1 & 1), cell[2] + (k >> 2)) - 60.5;
        const auto at = [&](double t, int a) { return std::clamp(o[a] + t * d[a] - cell[a], 0.0, 1.0); };
        q.entry = {at(t0, 0), at(t0, 1), at(t0, 2)};
        q.exit = {at(t1, 0), at(t1, 1), at(t1, 2)};
        q.carry = std::nan("");
        const Root<double> root = marmitt(q, cell_options);
        if (root.hit) best = std::min(best, t0 + root.s * (t1 - t0));
      }
      if (best > s->rays.t_max[i]) best = std::numeric_limits<double>::infinity();
      INFO("ray " << i << " found " << hits.t[i] << " expected " << best);
      if (std::isinf(best)) REQUIRE(std::isinf(hits.t[i]));
      else REQUIRE(std::abs(hits.t[i] - best) * length({d[0], d[1], d[2]}) < 1e-8);
      found += !std::isinf(best);
    }
  }
  REQUIRE(found > 1000);
}

TEST_CASE("next_hit gives every crossing once, in order, for several iso-values as for each alone") {
  std::mt19937_64 random(4);
  // zero on the border: closed surfaces, so that a ray from outside crosses each an even number of times
  const std::int64_t n = 14;
  const auto closed = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
    const bool border = i == 0 || j == 0 || k == 0 || i == n - 1 || j == n - 1 || k == n - 1;
    return border ? 0.0 : noise(i, j, k);
  };
  const auto volume = GENERATE_COPY(make_volume({n, n, n}, SampleType::u8, closed),
                                    make_full_tree({n, n, n}, SparseType::i16, 0, closed));
  const std::vector<double> isos = {30.5, 70.5, 71};
  VolumeSurfaceOptions options = surface_options(0);
  options.iso = isos;
  options.double_precision = true;
  const VolumeSurface together(volume, options);
  std::vector<std::unique_ptr<VolumeSurface>> alone;
  for (const double iso : isos) {
    options.iso = {iso};
    alone.push_back(std::make_unique<VolumeSurface>(volume, options));
  }

  // all crossings of every ray: (t, iso)
  const auto crossings = [](const VolumeSurface& surface, const RayStream& rays) {
    std::vector<std::vector<std::pair<double, int>>> lists(static_cast<std::size_t>(rays.size));
    TraceCounts counts;
    HitStream hits = first_hits(surface, rays);
    for (bool some = true; some;) {
      some = false;
      for (int i = 0; i < rays.size; ++i) {
        if (std::isinf(hits.t[i])) continue;
        auto& list = lists[static_cast<std::size_t>(i)];
        if (!list.empty()) REQUIRE(hits.t[i] >= list.back().first - 1e-9);
        REQUIRE(list.size() < 200);
        list.push_back({hits.t[i], hits.iso[i]});
        some = true;
      }
      surface.next_hit(rays, hits, counts);
    }
    return lists;
  };

  int total = 0;
  for (int round = 0; round < 20; ++round) {
    auto s = make_streams();
    while (s->rays.size < kStreamSize) {
      const Double3 target = {1 + double(random() % 1000) * 0.011, 1 + double(random() % 1000) * 0.011,
                              1 + double(random() % 1000) * 0.011};
      Double3 d = awkward_direction(random, target);
      add_ray(s->rays, target - (40 / length(d)) * d, d);
    }
    const auto all = crossings(together, s->rays);
    for (std::size_t v = 0; v < isos.size(); ++v) {
      const auto single = crossings(*alone[v], s->rays);
      for (std::size_t i = 0; i < all.size(); ++i) {
        std::vector<double> mine;
        for (const auto& [t, iso] : all[i])
          if (iso == static_cast<int>(v)) mine.push_back(t);
        INFO("round " << round << " ray " << i << " iso " << isos[v]);
        REQUIRE(mine.size() == single[i].size());
        REQUIRE(mine.size() % 2 == 0);
        for (std::size_t k = 0; k < mine.size(); ++k) REQUIRE(std::abs(mine[k] - single[i][k].first) < 1e-7);
        total += static_cast<int>(mine.size());
      }
    }
  }
  REQUIRE(total > 10000);
}

TEST_CASE("cells with a NaN or infinite corner are no cells") {
  const auto volume = make_volume({4, 3, 3}, SampleType::f32, [](auto i, auto j, auto k) {
    if (i == 1 && j == 1 && k == 1) return std::nan("");
    return i < 3 ? -1.0 : 1.0;
  });
  const VolumeSurface surface(volume, surface_options(0));
  auto s = make_streams();
  add_ray(s->rays, {-1, 0.5, 0.5},
          {1, 0, 0});  // cells (0..1, 0, 0) touch the NaN, cell (2, 0, 0) holds the surface
  const HitStream hits = first_hits(surface, s->rays);
  REQUIRE(hits.t[0] == Approx(3.5));
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    const VolumeSurface gone(make_volume({2, 2, 2}, SampleType::f32,
                                         [&](auto i, auto j, auto) {
                                           return i == 0 ? -1.0 : j == 0 ? bad : 1.0;
                                         }),
                             surface_options(0));
    const HitStream none = first_hits(gone, s->rays);
    REQUIRE(std::isinf(none.t[0]));
  }
}

TEST_CASE("exactly the iso-value at the start of a ray is a hit there, elsewhere it counts as positive") {
  const auto plane = [](auto i, auto, auto) { return double(i) - 2; };
  const VolumeSurface surface(make_volume({6, 4, 4}, SampleType::f32, plane), surface_options(0));
  auto s = make_streams();
  add_ray(s->rays, {2, 1.5, 1.5}, {-1, 0, 0});
  add_ray(s->rays, {2.5, 1.5, 1.5}, {-1, 0, 0});
  add_ray(s->rays, {1.5, 1.5, 1.5}, {1, 0, 0});
  add_ray(s->rays, {2.5, 1.5, 1.5}, {1, 0, 0});
  const HitStream hits = first_hits(surface, s->rays);
  CHECK(hits.t[0] == 0);
  CHECK(hits.t[1] == Approx(0.5));
  CHECK(hits.t[2] == Approx(0.5));
  CHECK(std::isinf(hits.t[3]));
}

TEST_CASE("iso_key parts the samples as the sign of sample minus iso does") {
  for (const bool precise : {false, true})
    for (const double iso : {0.0, 3.0, 3.25, -7.5, 127.5, 300.0, 1e-40, 0.1, -1e300, 1e300, 2147483647.5}) {
      const auto check = [&](SampleType type, double sample, double difference) {
        INFO(name_of(type) << " sample " << sample << " iso " << iso);
        CHECK((sample < iso_key(type, iso, precise)) == std::signbit(difference));
      };
      const auto narrow = [&](double s) { return precise ? s - iso : double(float(s) - float(iso)); };
      for (const double s : {0.0, 3.0, 4.0, 127.0, 128.0}) check(SampleType::u8, s, narrow(s));
      for (const double s : {-2147483648.0, 0.0, 3.0, 4.0, 2147483647.0}) check(SampleType::i32, s, s - iso);
      for (const float s : {0.0f, 0.1f, 3.25f, std::nextafter(3.25f, 0.0f), 1e-45f, 1e-40f, -1e30f})
        check(SampleType::f32, s, narrow(s));
      for (const double s : {0.1, std::nextafter(0.1, 0.0), 3.25, 1e-320}) check(SampleType::f64, s, s - iso);
    }
}

TEST_CASE("options that cannot be used are refused in one sentence") {
  const auto volume = make_volume({4, 4, 4}, SampleType::u8, noise);
  VolumeSurfaceOptions options = surface_options(1);
  options.iso.clear();
  CHECK_THROWS_WITH(VolumeSurface(volume, options), Catch::Contains("0 iso-values were given"));
  options.iso.assign(17, 1.0);
  CHECK_THROWS_WITH(VolumeSurface(volume, options), Catch::Contains("1 to 16"));
  options.iso = {std::nan("")};
  CHECK_THROWS_WITH(VolumeSurface(volume, options), Catch::Contains("no finite number"));
  CHECK_THROWS_WITH(VolumeSurface(make_volume({4, 1, 4}, SampleType::u8, noise), surface_options(1)),
                    Catch::Contains("4 x 1 x 4"));
  CHECK_THROWS_WITH(choose_cell_method("marmit", {}),
                    Catch::Contains("midpoint, linear, neubauer, schwarze, marmitt"));
  CHECK_THROWS_WITH(choose_cell_method("linear", {{"iterations", "3"}}),
                    Catch::Contains("has no option 'iterations'; it has: face"));
  CHECK_THROWS_WITH(choose_cell_method("marmitt", {{"iterations", "2.5"}}),
                    Catch::Contains("an integer between 1 and 100"));
  CHECK(choose_cell_method("marmitt", {}).options.adaptive);
  CHECK_FALSE(choose_cell_method("marmitt", {{"iterations", "5"}}).options.adaptive);
}
