// Surfaces of formulas by every method, and rays into their box.
#pragma once

#include <isocast/implicit/expression/parse.h>
#include <isocast/implicit/implicit_surface.h>
#include <volume/rays.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace isocast::test {

inline constexpr Domain kBox = {{-2, -2, -2}, {2, 2, 2}};

// Methods with a setting: what proves, and what does not.
struct Choice {
  const char *method, *key, *value;
};
inline constexpr Choice kProving[] = {
    {"interval", "bisection", "t"},         {"interval", "bisection", "k"}, {"affine", "bisection", "t"},
    {"affine", "bisection", "k"},           {"affine", "trim", "0"},        {"mitchell", "eps-rel", "0.001"},
    {"interval-newton", "eps-rel", "0.001"}};
inline constexpr Choice kNearest[] = {{"interval", "rounding", "nearest"}, {"affine", "rounding", "nearest"}};
inline constexpr Choice kMarching[] = {{"amp-sign", "iterations", "20"}, {"amp-taylor", "iterations", "20"}};

inline ImplicitSurfaceOptions options_of(const Choice& choice, bool precise = false, Isa isa = widest_isa()) {
  ImplicitSurfaceOptions options;
  options.method = choose_formula_method(choice.method, {{choice.key, choice.value}});
  options.double_precision = precise;
  options.isa = isa;
  return options;
}
inline ImplicitSurface surface_of(const std::string& formula, const ImplicitSurfaceOptions& options) {
  return ImplicitSurface(parse_expression(formula), kBox, options);
}

// Rays from around the box into it.
inline std::unique_ptr<Streams> random_streams(std::mt19937_64& random) {
  std::uniform_real_distribution<double> around(-5, 5), inside(-2, 2);
  auto s = make_streams();
  while (s->rays.size < kStreamSize) {
    const Double3 o = {around(random), around(random), around(random)};
    const Double3 target = {inside(random), inside(random), inside(random)};
    add_ray(s->rays, o, random() % 4 ? target - o : awkward_direction(random, o));
  }
  return s;
}

inline HitStream first_hits(const ImplicitSurface& surface, const RayStream& rays) {
  HitStream hits;
  clear(hits);
  std::ranges::fill(hits.certificate, Certificate::proved_miss);
  TraceCounts counts;
  surface.first_hit(rays, hits, counts);
  return hits;
}

// The roots of |o + t d|^2 = r^2 for t >= 0 in long double; nothing close to a tangent.
inline std::vector<long double> sphere_roots(const RayStream& rays, int i, long double radius, bool& close) {
  const long double o[3] = {rays.ox[i], rays.oy[i], rays.oz[i]}, d[3] = {rays.dx[i], rays.dy[i], rays.dz[i]};
  long double a = 0, b = 0, c = -radius * radius;
  for (int k = 0; k < 3; ++k) a += d[k] * d[k], b += o[k] * d[k], c += o[k] * o[k];
  const long double discriminant = b * b - a * c;
  close = std::abs(discriminant) < 1e-12L * (b * b + std::abs(a * c));
  if (discriminant < 0) return {};
  const long double root = std::sqrt(discriminant);
  std::vector<long double> roots;
  for (const long double t : {(-b - root) / a, (-b + root) / a})
    if (t >= rays.t_min[i] && t <= rays.t_max[i]) roots.push_back(t);
  return roots;
}

}  // namespace isocast::test
