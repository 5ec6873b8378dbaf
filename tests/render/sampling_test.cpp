// Sample patterns: their strata, their order, their filters, and what edges gain by them.
#include <isocast/render/sampling.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>

#include "../input_error.h"
#include "formula_scene.h"

using namespace isocast;
using namespace isocast::test;

TEST_CASE("every dyadic rectangle of area 1 / 2^m holds one of the first 2^m points, whatever the seeds") {
  for (const std::uint32_t seed : {0u, 1u, 77u, 0xffffffffu})
    for (int m = 1; m <= 8; ++m)
      for (int across = 0; across <= m; ++across) {
        std::set<std::pair<int, int>> boxes;
        for (std::uint32_t i = 0; i < 1u << m; ++i) {
          const UnitPoint p = scrambled_sobol(i, seed_of(seed), seed_of(seed + 1));
          REQUIRE((p.u >= 0 && p.u < 1 && p.v >= 0 && p.v < 1));
          boxes.insert(
              {static_cast<int>(std::ldexp(p.u, across)), static_cast<int>(std::ldexp(p.v, m - across))});
        }
        CHECK(boxes.size() == 1u << m);
      }
}

TEST_CASE("the first sample is the centre, and more samples keep those that were there") {
  for (const PixelFilter filter :
       {PixelFilter::box, PixelFilter::triangle, PixelFilter::gaussian, PixelFilter::blackman}) {
    const std::vector<PixelSample> few = pixel_samples(5, filter), many = pixel_samples(300, filter);
    CHECK(few[0].u == 0.5);
    CHECK(few[0].v == 0.5);
    CHECK(few[0].columns == 0);
    for (std::size_t i = 0; i < few.size(); ++i) CHECK((few[i].u == many[i].u && few[i].v == many[i].v));
    for (const PixelSample& s : many) CHECK((s.u >= 0 && s.u < 1 && s.v >= 0 && s.v < 1));
    CHECK(few.size() == 5);
  }
}

TEST_CASE("samples have the mean and variance of their filter") {
  // of the densities in closed form: 1/12, 1/6, the cut normal's, Blackman's
  const double pi = 3.14159265358979323846;
  const double blackman = 1.5 * 1.5 * (1.0 / 3 + (2 / (pi * pi)) * (-0.5 + 0.08 / 4) / 0.42);
  const double z = 3, phi = std::exp(-z * z / 2) / std::sqrt(2 * pi),
               gaussian = 0.25 * (1 - 2 * z * phi / std::erf(z / std::sqrt(2.0)));
  const std::array<double, 4> variances = {1.0 / 12, 1.0 / 6, gaussian, blackman};
  for (int f = 0; f < 4; ++f) {
    double mean[2] = {}, square[2] = {};
    constexpr int n = 4096;
    for (const PixelSample& s : pixel_samples(n, static_cast<PixelFilter>(f))) {
      const double p[2] = {s.columns + s.u - 0.5, s.rows + s.v - 0.5};
      for (int a = 0; a < 2; ++a) mean[a] += p[a] / n, square[a] += p[a] * p[a] / n;
    }
    INFO("filter " << f);
    for (int a = 0; a < 2; ++a) {
      CHECK(std::abs(mean[a]) < 2e-3);
      CHECK(square[a] == Approx(variances[static_cast<std::size_t>(f)]).epsilon(5e-3));
    }
  }
  CHECK(filter_from_name("blackman") == PixelFilter::blackman);
  CHECK_THROWS_MATCHES(filter_from_name("boxy"), InputError,
                       says("expected box, triangle, gaussian or blackman"));
}

TEST_CASE("edges come out better than with the plastic sequence") {
  // half planes through a pixel, their share by 400 x 400 points
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform;
  const auto fraction = [](double x) { return x - std::floor(x); };
  struct Edge {
    double x, y, offset, share;
    [[nodiscard]] bool covers(double u, double v) const { return x * (u - 0.5) + y * (v - 0.5) < offset; }
  };
  std::vector<Edge> edges;
  for (int i = 0; i < 400; ++i) {
    const double angle = 6.283185307 * uniform(random);
    Edge edge = {std::cos(angle), std::sin(angle), 1.4 * uniform(random) - 0.7, 0};
    constexpr int n = 100;
    for (int k = 0; k < n * n; ++k)
      edge.share += edge.covers((k % n + 0.5) / n, (k / n + 0.5) / n) / double(n * n);
    edges.push_back(edge);
  }
  for (const auto& [count, largest] : {std::pair{4, 0.105}, {16, 0.04}, {64, 0.0155}}) {
    const std::vector<PixelSample> samples = pixel_samples(count, PixelFilter::box);
    double error = 0, plastic = 0;
    for (const Edge& edge : edges) {
      double share = 0, other = 0;
      for (int i = 0; i < count; ++i) {
        share += edge.covers(samples[static_cast<std::size_t>(i)].u, samples[static_cast<std::size_t>(i)].v) /
                 double(count);
        other += edge.covers(fraction(0.5 + i * 0.7548776662466927), fraction(0.5 + i * 0.5698402909980532)) /
                 double(count);
      }
      error += (share - edge.share) * (share - edge.share);
      plastic += (other - edge.share) * (other - edge.share);
    }
    INFO(count << " samples: " << std::sqrt(error / 400) << ", plastic " << std::sqrt(plastic / 400));
    CHECK(std::sqrt(error / 400) < largest);
    CHECK(error < 0.75 * 0.75 * plastic);
  }
}

TEST_CASE("a filtered picture is the filter over many samples, with and without a pass") {
  Scene scene;
  add_formula(scene, "x^2 + y^2 + z^2 - 1", {{{0.9f, 0.9f, 0.9f}}});
  scene.background = {0, 0, 0};
  const View view = view_along({0, -9, 0}, {0, 0, 0}, 24, 3);
  for (const PixelFilter filter :
       {PixelFilter::box, PixelFilter::triangle, PixelFilter::gaussian, PixelFilter::blackman}) {
    RenderSettings settings;
    settings.filter = filter;
    settings.spp = 64;
    Film some(24, 24, {Layer::depth}), centre(24, 24, {Layer::depth});
    render(scene, view, settings, some);
    settings.spp = 1;
    render(scene, view, settings, centre);
    CHECK(same_bytes(some.layer(Layer::depth), centre.layer(Layer::depth)));
    // alpha: the disk's share under the filter, by a grid of points around each pixel
    constexpr int n = 90;
    double worst = 0;
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x) {
        double sum = 0, all = 0;
        for (int k = 0; k < n * n; ++k) {
          const double dx = 3.0 * (k % n + 0.5) / n - 1.5, dy = 3.0 * (k / n + 0.5) / n - 1.5;
          const auto weight = [&](double d) {
            d = std::abs(d);
            if (filter == PixelFilter::box) return d < 0.5 ? 1.0 : 0.0;
            if (filter == PixelFilter::triangle) return std::max(0.0, 1 - d);
            if (filter == PixelFilter::gaussian) return std::exp(-2 * d * d);
            const double a = 3.14159265358979 * d / 1.5;
            return 0.42 + 0.5 * std::cos(a) + 0.08 * std::cos(2 * a);
          };
          const double w = weight(dx) * weight(dy), px = (x + 0.5 + dx - 12) / 8,
                       py = (y + 0.5 + dy - 12) / 8;
          all += w;
          if (px * px + py * py < 1) sum += w;
        }
        worst = std::max(worst,
                         std::abs(sum / all - double(some.color(static_cast<std::uint32_t>(x + 24 * y))[3])));
      }
    INFO("filter " << static_cast<int>(filter));
    CHECK(worst < 0.05);
  }
}
