// Formulas, chords through their boxes, and whether what methods say of them can be true.
#pragma once

#include <isocast/apps/reference/formula_reference.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/implicit_surface.h>
#include <volume/rays.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

namespace isocast::test {

using reference::FormulaReference, reference::FormulaRoots;

inline constexpr int kRays = 64;
/// Evaluations that one ray may take: parts that are judged, and the divisions around them.
inline constexpr std::uint32_t kMostEvaluations = 1 << 14;
inline constexpr const char* kProving[] = {"interval", "affine", "mitchell", "interval-newton"};
inline constexpr const char* kMarching[] = {"amp-sign", "amp-taylor"};

struct Formula {
  Expression expression;
  Domain domain;
  std::vector<double> iso = {0};
};
inline Formula formula_of(const std::string& text, double half_width = 1) {
  return {parse_expression(text),
          {{-half_width, -half_width, -half_width}, {half_width, half_width, half_width}}};
}
inline Formula of_catalogue(const char* id) {
  const CatalogueSurface& surface = require_surface(id);
  return {surface_expression(surface), surface.domain};
}

inline HitStream trace(const Formula& formula, const char* method, bool precise, const RayStream& rays) {
  ImplicitSurfaceOptions options;
  options.method = choose_formula_method(method, {});
  options.double_precision = precise;
  options.iso = formula.iso;
  HitStream hits;
  clear(hits);
  std::ranges::fill(hits.certificate, Certificate::proved_miss);
  TraceCounts counts;
  ImplicitSurface(formula.expression, formula.domain, options).first_hit(rays, hits, counts);
  return hits;
}

/// From p to q, both inside the box: t goes from 0 to 1.
inline void add_chord(RayStream& rays, const Double3& p, const Double3& q) { add_ray(rays, p, q - p, 1); }
inline std::unique_ptr<Streams> chords(const Domain& domain, int count) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.01, 0.99);
  const auto point = [&] {
    Double3 p;
    for (std::size_t a = 0; a < 3; ++a) p[a] = domain.lo[a] + unit(random) * (domain.hi[a] - domain.lo[a]);
    return p;
  };
  auto s = make_streams();
  while (s->rays.size < count) add_chord(s->rays, point(), point());
  return s;
}

/// What all methods made of a stream of chords.
struct Tally {
  int hits = 0, misses = 0, undecided = 0;
};

/// Of each ray the roots of every iso-value, as far as the first.
using Roots = std::vector<std::vector<FormulaRoots>>;
inline Roots roots_of(const Formula& formula, const RayStream& rays) {
  reference::ReferenceOptions options;
  options.max_roots = 1;
  options.max_operations = 1 << 14;
  Roots roots(static_cast<std::size_t>(rays.size));
  for (const double iso : formula.iso) {
    const FormulaReference reference(formula.expression, iso);
    for (int i = 0; i < rays.size; ++i)
      roots[static_cast<std::size_t>(i)].push_back(reference.solve(
          {rays.ox[i], rays.oy[i], rays.oz[i]}, {rays.dx[i], rays.dy[i], rays.dz[i]}, 0, 1, options));
  }
  return roots;
}

inline void check_proof(const HitStream& hits, int i, const std::vector<FormulaRoots>& all, Tally& tally) {
  if (hits.certificate[i] == Certificate::undecided) {
    ++tally.undecided;
    return;
  }
  const bool hit = hits.certificate[i] == Certificate::proved_hit;
  ++(hit ? tally.hits : tally.misses);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const FormulaRoots& roots = all[k];
    if (!hit) REQUIRE(roots.roots.empty());
    else if (!roots.roots.empty()) REQUIRE(roots.roots[0].hi >= hits.t_lo[i]);
    if (!hit || hits.iso[i] != k) continue;
    const bool doubtful =
        std::ranges::any_of(roots.doubts, [&](const auto& doubt) { return doubt.lo <= hits.t_hi[i]; });
    // the box's ends are off by roundings
    if (doubtful || hits.t_lo[i] <= 1e-12 || hits.t_hi[i] >= 1 - 1e-12) continue;
    REQUIRE_FALSE(roots.roots.empty());
    REQUIRE(roots.roots[0].lo <= hits.t_hi[i]);
  }
}

inline void check_order(const HitStream& hits, int i) {
  REQUIRE(hits.cost[i] <= kMostEvaluations);
  if (std::isinf(hits.t[i])) return;
  REQUIRE(std::isfinite(hits.t_lo[i]));
  REQUIRE(std::isfinite(hits.t_hi[i]));
  REQUIRE(hits.t_lo[i] <= hits.t[i]);
  REQUIRE(hits.t[i] <= hits.t_hi[i]);
}

/// Every proving method in both precisions, and the others for what they may not do.
inline Tally check(const Formula& formula, const RayStream& rays, const Roots& roots) {
  Tally tally;
  for (const bool precise : {false, true}) {
    for (const char* method : kProving) {
      const HitStream hits = trace(formula, method, precise, rays);
      for (int i = 0; i < rays.size; ++i) {
        INFO(method << (precise ? " double" : " float") << " ray " << i << std::hexfloat << " o "
                    << rays.ox[i] << " " << rays.oy[i] << " " << rays.oz[i] << " d " << rays.dx[i] << " "
                    << rays.dy[i] << " " << rays.dz[i] << " t " << hits.t_lo[i] << " " << hits.t_hi[i]);
        check_order(hits, i);
        check_proof(hits, i, roots[static_cast<std::size_t>(i)], tally);
      }
    }
    for (const char* method : kMarching) {
      const HitStream hits = trace(formula, method, precise, rays);
      for (int i = 0; i < rays.size; ++i) {
        INFO(method << (precise ? " double" : " float") << " ray " << i);
        check_order(hits, i);
        if (hits.t[i] < 1) REQUIRE(hits.certificate[i] == Certificate::no_proof);
      }
    }
  }
  return tally;
}
inline Tally check(const Formula& formula, const RayStream& rays) {
  return check(formula, rays, roots_of(formula, rays));
}
inline Tally check(const Formula& formula) { return check(formula, chords(formula.domain, kRays)->rays); }
inline Tally check(const std::string& text, double half_width = 1) {
  INFO(text);
  return check(formula_of(text, half_width));
}

}  // namespace isocast::test
