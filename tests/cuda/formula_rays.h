// Rays through a formula's domain, solved one by one, and what two surfaces may say of them.
#pragma once

#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/implicit_surface.h>

#include <catch2/catch.hpp>
#include <random>

#include "../volume/rays.h"
#include "../volume/same_hits.h"

namespace isocast::test {

// Rays one by one, as a device has them.
struct FormulaChoice {
  const char* method;
  std::map<std::string, std::string> values;
};
inline const std::vector<FormulaChoice>& formula_choices() {
  static const std::vector<FormulaChoice> choices = {
      {"interval", {{"beams", "0"}, {"prune", "0"}}},
      {"affine", {{"beams", "0"}, {"prune", "0"}}},
      {"affine", {{"beams", "0"}, {"prune", "0"}, {"trim", "0"}}},
      {"interval", {{"beams", "0"}, {"prune", "0"}, {"rounding", "nearest"}}},
      {"mitchell", {{"beams", "0"}, {"prune", "0"}}},
      {"interval-newton", {{"beams", "0"}, {"prune", "0"}}},
      {"amp-sign", {{"prune", "0"}}},
      {"amp-taylor", {{"prune", "0"}}},
      {"frustum-lr", {}},
      {"frustum-mr", {}},
      {"frustum-lr-mult", {}},
      {"frustum-mr-mult", {}},
      {"frustum-schneider", {}},
      {"frustum-clip", {}}};
  return choices;
}

inline std::unique_ptr<Streams> rays_through(std::mt19937_64& random, const Box& box) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto point = [&](double reach) {
    return box.center() + reach * box.diagonal() * Double3{unit(random), unit(random), unit(random)};
  };
  auto streams = make_streams();
  clear(streams->hits);
  streams->rays.size = 0;
  const int count = 1 + static_cast<int>(random() % kStreamSize);
  for (int i = 0; i < count; ++i) {
    const Double3 o = point(1);
    add_ray(streams->rays, o, random() % 4 ? point(0.4) - o : awkward_direction(random, o));
  }
  return streams;
}

// Marching points look at the slopes of all rays in work where one of them asks: their cost depends on the
// others.
inline void require_same_hits(const Streams& a, const Streams& b, bool cost) {
  for (int i = 0; i < a.rays.size; ++i) {
    INFO("slot " << i << ": t " << a.hits.t[i] << " and " << b.hits.t[i]);
    REQUIRE(is_hit(a.hits, i) == is_hit(b.hits, i));
    REQUIRE(a.hits.certificate[i] == b.hits.certificate[i]);
    if (cost) REQUIRE(a.hits.cost[i] == b.hits.cost[i]);
    if (!is_hit(a.hits, i)) continue;
    REQUIRE((same(a.hits.t[i], b.hits.t[i]) && same(a.hits.t_lo[i], b.hits.t_lo[i]) &&
             same(a.hits.t_hi[i], b.hits.t_hi[i])));
    REQUIRE(a.hits.iso[i] == b.hits.iso[i]);
    REQUIRE(a.hits.sides[i] == b.hits.sides[i]);
  }
}

// What one proves the other does not deny.
inline void require_no_contradiction(const Streams& a, const Streams& b) {
  for (int i = 0; i < a.rays.size; ++i) {
    INFO("slot " << i << ": t " << a.hits.t[i] << " and " << b.hits.t[i]);
    const Certificate one = a.hits.certificate[i], other = b.hits.certificate[i];
    REQUIRE_FALSE((one == Certificate::proved_hit && other == Certificate::proved_miss));
    REQUIRE_FALSE((one == Certificate::proved_miss && other == Certificate::proved_hit));
    if (one != Certificate::proved_hit || other != Certificate::proved_hit) continue;
    REQUIRE(a.hits.t_lo[i] <= b.hits.t_hi[i]);
    REQUIRE(b.hits.t_lo[i] <= a.hits.t_hi[i]);
  }
}

// A choice that the surface's formula can have.
inline const FormulaChoice& random_choice(std::mt19937_64& random, const CatalogueSurface& surface) {
  for (;;) {
    const FormulaChoice& choice = formula_choices()[random() % formula_choices().size()];
    if (surface.degree || !choose_formula_method(choice.method, choice.values).has_form()) return choice;
  }
}

inline ImplicitSurfaceOptions options_of(const FormulaChoice& choice, std::mt19937_64& random) {
  ImplicitSurfaceOptions options;
  options.method = choose_formula_method(choice.method, choice.values);
  options.isa = Isa::scalar;
  options.double_precision = random() % 2;
  if (random() % 2) options.iso = {0.125, 0, -0.125};
  return options;
}

}  // namespace isocast::test
