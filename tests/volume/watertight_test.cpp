// No ray slips through a closed surface between cells (design.md, decision 5).
#include <isocast/volume/cell/cell.h>
#include <test_size.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "make_tree.h"
#include "make_volume.h"
#include "rays.h"

using namespace isocast;
using namespace isocast::test;

namespace {

constexpr std::int64_t kN = 20;

// Closed surfaces: above every iso-value on the border, so whoever starts below must cross.
double smooth(std::int64_t i, std::int64_t j, std::int64_t k) {
  const double c = 0.5 * (kN - 1), x = double(i) - c, y = double(j) - c, z = double(k) - c;
  return std::sqrt(x * x + 1.3 * y * y + z * z) - 6.37 + 0.9 * std::sin(x) * std::cos(1.7 * y) + 0.05 * z;
}
double rough(std::int64_t i, std::int64_t j, std::int64_t k) {
  const bool border = i == 0 || j == 0 || k == 0 || i == kN - 1 || j == kN - 1 || k == kN - 1;
  const std::uint64_t x = static_cast<std::uint64_t>(i + 100 * j + 10000 * k + 1) * 0x9e3779b97f4a7c15u;
  return border ? 100.0 : static_cast<double>(x >> 40 & 127);
}

// f at a point of grid space, in double.
double value_at(const std::function<double(std::int64_t, std::int64_t, std::int64_t)>& f, const Double3& p,
                double iso) {
  std::int64_t c[3];
  for (int a = 0; a < 3; ++a) c[a] = std::min<std::int64_t>(static_cast<std::int64_t>(p[a]), kN - 2);
  double corners[8];
  for (int i = 0; i < 8; ++i) corners[i] = f(c[0] + (i & 1), c[1] + (i >> 1 & 1), c[2] + (i >> 2)) - iso;
  return trilinear(corners, Vec3<double>{p[0] - double(c[0]), p[1] - double(c[1]), p[2] - double(c[2])});
}

// Shoots `count` awkward rays from points well below the iso-value; returns how many hit nothing.
std::int64_t count_escapes(const VolumeSurface& surface,
                           const std::function<double(std::int64_t, std::int64_t, std::int64_t)>& f,
                           double iso, double margin, std::int64_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> inside(1, kN - 2);
  std::int64_t escaped = 0;
  for (std::int64_t shot = 0; shot < count; shot += kStreamSize) {
    const auto s = make_streams();
    while (s->rays.size < kStreamSize) {
      Double3 o = {inside(random), inside(random), inside(random)};
      const auto kind = random() % 4;
      for (int a = 0; a < 3; ++a)
        if (kind == 3 || (kind > 0 && random() % 2)) o[a] = std::floor(o[a] * 2) / 2;
      if (value_at(f, o, iso) < -margin) add_ray(s->rays, o, awkward_direction(random, o));
    }
    TraceCounts counts;
    surface.first_hit(s->rays, s->hits, counts);
    for (int i = 0; i < s->rays.size; ++i) escaped += std::isinf(s->hits.t[i]);
  }
  return escaped;
}

}  // namespace

TEST_CASE("of rays shot from inside closed surfaces none escapes", "[property]") {
  const std::int64_t total = test::cases(1000000, 100000000);
  struct Case {
    const char* method;
    SampleType type;
    bool precise, smooth;
    double share;
    bool tree = false;
  };
  for (const Case& c :
       {Case{"marmitt", SampleType::f32, false, true, 0.3},
        Case{"marmitt", SampleType::u8, false, false, 0.2}, Case{"marmitt", SampleType::f64, true, true, 0.1},
        Case{"neubauer", SampleType::f32, false, true, 0.1},
        Case{"marmitt", SampleType::f32, false, true, 0.2, true},
        Case{"marmitt", SampleType::f32, false, false, 0.1, true},
        Case{"linear", SampleType::u8, false, false, 0.1}}) {
    VolumeSurfaceOptions options = surface_options(c.smooth ? 0 : 57, widest_isa(), c.method);
    options.double_precision = c.precise;
    const std::function<double(std::int64_t, std::int64_t, std::int64_t)> f = c.smooth ? smooth : rough;
    const VolumeSurface surface(
        c.tree ? make_full_tree({kN, kN, kN}, SparseType::f32, 100, f) : make_volume({kN, kN, kN}, c.type, f),
        options);
    INFO(c.method << " " << name_of(c.type) << (c.tree ? " in a tree" : ""));
    CHECK(count_escapes(surface, f, options.iso[0], 1e-3, static_cast<std::int64_t>(double(total) * c.share),
                        17) == 0);
  }
}

TEST_CASE("none escapes where the values are denormal", "[property]") {
  const auto tiny = [](std::int64_t i, std::int64_t j, std::int64_t k) {
    return (rough(i, j, k) - 57) * 1e-44;
  };
  const VolumeSurface surface(make_volume({kN, kN, kN}, SampleType::f32, tiny), surface_options(0));
  CHECK(count_escapes(surface, tiny, 0, 1e-44, test::cases(50000, 1000000), 18) == 0);
}
