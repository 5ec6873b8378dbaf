// The walk visits every cell that the exact ray meets, in order, and its intervals chain bit for bit.
#include <gmpxx.h>
#include <isocast/volume/traverse.h>
#include <test_size.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace isocast;

namespace {

constexpr std::int32_t kDims[3] = {21, 18, 6};  // samples: 20 x 17 x 5 cells
const double kInfinity = std::numeric_limits<double>::infinity();

// The blocks of dense grids, and those of sparse ones, across the borders of all kinds of blocks.
struct DenseBlocks {
  static constexpr std::int32_t kShifts[] = {4, 2, 0};
  static constexpr std::int32_t kFirst[3] = {0, 0, 0};
};
struct SparseBlocks {
  static constexpr std::int32_t kShifts[] = {12, 7, 3, 0};
  static constexpr std::int32_t kFirst[3] = {-9, 4087, -132};
};
template <class Blocks> struct TestGrid {
  static constexpr int kLevels = static_cast<int>(std::size(Blocks::kShifts));
  using Walk = GridWalk<kLevels>;
  SampleBox samples;
  BlockBox whole;
  TestGrid() {
    for (int a = 0; a < 3; ++a) {
      samples.first[a] = Blocks::kFirst[a];
      samples.last[a] = Blocks::kFirst[a] + kDims[a] - 1;
      whole.lo[a] = samples.first[a] >> Blocks::kShifts[0];
      whole.hi[a] = (samples.last[a] - 1) >> Blocks::kShifts[0];
    }
  }
};

struct Visit {
  std::array<std::int32_t, 3> cell;
  double t_in, t_out;
};

// Every cell by single steps, or only some blocks entered: `enter(level, block)` decides whether the walk
// goes into a block.
template <class Blocks, class Enter>
std::vector<Visit> walk_cells(const GridRay& ray, double t_min, double t_max, Enter enter) {
  std::vector<Visit> visits;
  typename TestGrid<Blocks>::Walk walk;
  if (!enter_grid(ray, Blocks::kShifts, TestGrid<Blocks>().whole, t_min, t_max, walk)) return visits;
  const auto step = [&](auto level) {
    if constexpr (level == TestGrid<Blocks>::Walk::kCells) {
      walk_level<level>(ray, Blocks::kShifts, walk, false, [&](const std::int32_t(&c)[3]) {
        visits.push_back({{c[0], c[1], c[2]}, walk.t_in, 0});
        return false;
      });
    } else if (walk_level<level>(ray, Blocks::kShifts, walk, false,
                                 [&](const std::int32_t(&b)[3]) { return enter(level, b); })) {
      descend<level>(ray, Blocks::kShifts, walk);
      return true;
    }
    return ascend<level>(ray, Blocks::kShifts, walk);
  };
  while (at_index<TestGrid<Blocks>::kLevels>(walk.depth, step)) {}
  for (Visit& v : visits) {  // exits by the one expression for planes
    v.t_out = kInfinity;
    for (int a = 0; a < 3; ++a)
      if (ray.step[a]) v.t_out = std::min(v.t_out, ray.plane_t(a, v.cell[a] + (ray.step[a] > 0)));
  }
  return visits;
}

template <class Blocks> std::vector<Visit> walk_all(const GridRay& ray, double t_min, double t_max) {
  return walk_cells<Blocks>(ray, t_min, t_max, [](int, const std::int32_t(&)[3]) { return true; });
}

// The open interval of t in which the exact ray is inside a cell, in rationals; empty: lo >= hi.
struct ExactInterval {
  mpq_class lo, hi;
};
ExactInterval exact_interval(const std::array<double, 3>& o, const std::array<double, 3>& d,
                             const std::array<std::int32_t, 3>& cell, double t_min, double t_max) {
  ExactInterval t{mpq_class(t_min), mpq_class(t_max)};
  for (int a = 0; a < 3; ++a) {
    const mpq_class oa(o[a]), da(d[a]);
    if (da == 0) {
      if (oa <= cell[a] || oa >= cell[a] + 1) return {1, 0};
      continue;
    }
    mpq_class t0 = (cell[a] - oa) / da, t1 = (cell[a] + 1 - oa) / da;
    if (t0 > t1) std::swap(t0, t1);
    t.lo = std::max(t.lo, t0);
    t.hi = std::min(t.hi, t1);
  }
  return t;
}

struct TestRay {
  std::array<double, 3> o, d;
  double t_max;
};

// Rays of every awkward kind at a grid of 21 x 18 x 6 samples.
template <class Blocks> TestRay random_ray(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1), sign(-1, 1);
  const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  TestRay ray;
  // where to, and from where: inside, outside, far away, on lattice planes
  std::array<double, 3> target;
  for (int a = 0; a < 3; ++a) {
    target[a] = unit(random) * (kDims[a] - 1);
    if (pick(3) == 0) target[a] = std::floor(target[a]);
  }
  const int place = pick(4);
  for (int a = 0; a < 3; ++a) {
    ray.o[a] =
        place == 0 ? unit(random) * (kDims[a] - 1) : target[a] + sign(random) * (place == 3 ? 1e6 : 50);
    if (pick(4) == 0) ray.o[a] = std::floor(ray.o[a]);
  }
  for (int a = 0; a < 3; ++a) {
    ray.d[a] = target[a] - ray.o[a];
    const int special = pick(12);
    if (special == 0) ray.d[a] = 0;
    if (special == 1) ray.d[a] = std::copysign(1e-310, sign(random));
    if (special == 2) ray.d[a] = 1e-9 * sign(random);
  }
  if (pick(6) == 0)
    ray.d = {double(pick(3) - 1), double(pick(3) - 1), double(pick(3) - 1)};  // edges and corners
  const double scales[] = {1e-6, 1, 1e6};
  const double scale = scales[pick(3)];
  for (double& x : ray.d) x *= scale;
  ray.t_max = pick(4) == 0 ? unit(random) / scale : kInfinity;
  for (int a = 0; a < 3; ++a) ray.o[a] += Blocks::kFirst[a];
  return ray;
}

template <class Blocks> GridRay grid_ray(const TestRay& ray) {
  const double o[3] = {ray.o[0], ray.o[1], ray.o[2]}, d[3] = {ray.d[0], ray.d[1], ray.d[2]};
  return make_grid_ray(o, d, TestGrid<Blocks>().samples);
}

double four_ulp(double t) { return 4 * (std::nextafter(std::abs(t), kInfinity) - std::abs(t)); }

}  // namespace

TEMPLATE_TEST_CASE("the walk visits every cell that the exact ray meets longer than 4 ulp, in order",
                   "[property]", DenseBlocks, SparseBlocks) {
  std::mt19937_64 random(1);
  const std::int64_t count = test::cases(3000, 300000);
  std::int64_t met = 0, visited = 0;
  for (std::int64_t n = 0; n < count; ++n) {
    const TestRay ray = random_ray<TestType>(random);
    const std::vector<Visit> visits = walk_all<TestType>(grid_ray<TestType>(ray), 0, ray.t_max);
    visited += static_cast<std::int64_t>(visits.size());

    // in order, each once, neighbours by a face, intervals chained bit for bit
    for (std::size_t i = 1; i < visits.size(); ++i) {
      int moved = 0;
      for (int a = 0; a < 3; ++a) moved += std::abs(visits[i].cell[a] - visits[i - 1].cell[a]);
      REQUIRE(moved == 1);
      REQUIRE(visits[i].t_in == visits[i - 1].t_out);
      REQUIRE(visits[i].t_out >= visits[i].t_in);
    }
    std::vector<char> seen(20 * 17 * 5);
    for (const Visit& v : visits) {
      std::int32_t c[3];
      for (int a = 0; a < 3; ++a) {
        c[a] = v.cell[a] - TestType::kFirst[a];
        REQUIRE((c[a] >= 0 && c[a] < kDims[a] - 1));
      }
      char& mark = seen[static_cast<std::size_t>((c[2] * 17 + c[1]) * 20 + c[0])];
      REQUIRE(mark == 0);
      mark = 1;
    }

    // none missing: only every 10th ray, rationals are slow
    if (n % 10) continue;
    const double t_max = std::isfinite(ray.t_max) ? ray.t_max : 1e300;
    for (std::int32_t z = 0; z < 5; ++z)
      for (std::int32_t y = 0; y < 17; ++y)
        for (std::int32_t x = 0; x < 20; ++x) {
          const ExactInterval t = exact_interval(
              ray.o, ray.d, {x + TestType::kFirst[0], y + TestType::kFirst[1], z + TestType::kFirst[2]}, 0,
              t_max);
          if (t.lo >= t.hi) continue;
          const double largest = std::max(std::abs(t.lo.get_d()), std::abs(t.hi.get_d()));
          if (t.hi - t.lo <= mpq_class(four_ulp(largest))) continue;
          ++met;
          INFO("ray " << n << ": o " << ray.o[0] << " " << ray.o[1] << " " << ray.o[2] << " d " << ray.d[0]
                      << " " << ray.d[1] << " " << ray.d[2] << " cell " << x << " " << y << " " << z << " t "
                      << t.lo.get_d() << " " << t.hi.get_d());
          REQUIRE(seen[static_cast<std::size_t>((z * 17 + y) * 20 + x)]);
        }
  }
  REQUIRE(met > count / 10);
  REQUIRE(visited > count);
}

TEMPLATE_TEST_CASE("leaping over blocks changes neither the cells nor the crossings of the others",
                   "[property]", DenseBlocks, SparseBlocks) {
  std::mt19937_64 random(2);
  for (std::int64_t n = 0, count = test::cases(20000, 1000000); n < count; ++n) {
    const TestRay ray = random_ray<TestType>(random);
    const std::uint64_t salt = random();
    const auto wanted = [&](int level, const std::int32_t(&b)[3]) {
      return ((static_cast<std::uint64_t>(b[0] + 7 * b[1] + 49 * b[2] + 343 * level) * 0x9e3779b97f4a7c15u ^
               salt) >>
                  33 &
              3) != 0;
    };
    const std::vector<Visit> all = walk_all<TestType>(grid_ray<TestType>(ray), 0, ray.t_max),
                             some = walk_cells<TestType>(grid_ray<TestType>(ray), 0, ray.t_max, wanted);
    std::size_t k = 0;
    for (const Visit& v : all) {
      bool leapt = false;
      for (int level = 0; level < TestGrid<TestType>::kLevels - 1; ++level) {
        const std::int32_t shift = TestType::kShifts[level];
        leapt = leapt || !wanted(level, {v.cell[0] >> shift, v.cell[1] >> shift, v.cell[2] >> shift});
      }
      if (leapt) continue;
      REQUIRE(k < some.size());
      REQUIRE(some[k].cell == v.cell);
      REQUIRE(some[k].t_in == v.t_in);
      ++k;
    }
    REQUIRE(k == some.size());
  }
}

TEMPLATE_TEST_CASE("a walk resumed in a cell has the state of the walk that came there", "", DenseBlocks,
                   SparseBlocks) {
  std::mt19937_64 random(3);
  for (int n = 0; n < 5000; ++n) {
    const TestRay ray = random_ray<TestType>(random);
    const GridRay grid = grid_ray<TestType>(ray);
    for (const Visit& v : walk_all<TestType>(grid, 0, ray.t_max)) {
      typename TestGrid<TestType>::Walk walk;
      if (!enter_grid(grid, TestType::kShifts, TestGrid<TestType>().whole, 0, ray.t_max, walk)) continue;
      const std::int32_t cell[3] = {v.cell[0], v.cell[1], v.cell[2]};
      resume_in_cell(grid, TestType::kShifts, cell, 0, walk);
      REQUIRE(walk.t_in == v.t_in);
      REQUIRE(walk.t_out() == v.t_out);
      // and goes on alike: leave the cell, reach the next
      const bool stays = walk_level<TestGrid<TestType>::Walk::kCells>(
          grid, TestType::kShifts, walk, true, [](const std::int32_t(&)[3]) { return true; });
      if (stays) REQUIRE(walk.t_in == v.t_out);
    }
  }
}

TEMPLATE_TEST_CASE("rays that cannot meet the grid do not enter it", "", DenseBlocks, SparseBlocks) {
  const double nan = std::nan("");
  typename TestGrid<TestType>::Walk walk;
  for (const auto& [o, d] : std::vector<std::pair<std::array<double, 3>, std::array<double, 3>>>{
           {{nan, 1, 1}, {1, 0, 0}},
           {{1, 1, 1}, {nan, nan, nan}},
           {{-1, 1, 1}, {-1, 0, 0}},
           {{-1, 30, 1}, {1, 0, 0}},
           {{1e300, 1e300, 1e300}, {1, 1, 1}},
           {{kInfinity, 1, 1}, {-1, 0, 0}}}) {
    const GridRay ray = grid_ray<TestType>(
        {{o[0] + TestType::kFirst[0], o[1] + TestType::kFirst[1], o[2] + TestType::kFirst[2]}, d, kInfinity});
    INFO(o[0] << " " << d[0]);
    CHECK_FALSE(enter_grid(ray, TestType::kShifts, TestGrid<TestType>().whole, 0, kInfinity, walk));
  }
}
