// Parts of solids, and all crossings of rays with them.
#pragma once

#include <isocast/ray/csg_surface.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "../render/formula_scene.h"
#include "ray_maker.h"

namespace isocast::test {

inline constexpr std::uint16_t kObject = 2;

inline CsgPart operand(std::shared_ptr<const Surface> surface, int isos = 1, bool above = false) {
  return {CsgOperation::operand, {std::move(surface), isos, above}, {}};
}
inline CsgPart formula(const std::string& text, std::vector<double> iso = {0}, bool precise = true) {
  const int isos = static_cast<int>(iso.size());
  return operand(formula_surface(text, std::move(iso), kObject, precise), isos);
}
inline CsgPart join(CsgOperation operation, std::vector<CsgPart> parts) {
  return {operation, {}, std::move(parts)};
}

// All crossings of a stream: hits[n] is what the n-th query found.
struct Crossing {
  double t, t_lo, t_hi;
  int iso;
  std::uint32_t sides;
  Certificate certificate;
};
inline std::vector<std::vector<Crossing>> all_crossings(const Surface& surface, const RayStream& rays,
                                                        Certificate (&last)[kStreamSize]) {
  std::vector<std::vector<Crossing>> all(static_cast<std::size_t>(rays.size));
  auto hits = std::make_unique<HitStream>();
  clear(*hits);
  std::ranges::fill(hits->certificate, Certificate::proved_miss);
  TraceCounts counts;
  surface.first_hit(rays, *hits, counts);
  for (bool any = true; any;) {
    any = false;
    for (int i = 0; i < rays.size; ++i) {
      if (all[static_cast<std::size_t>(i)].empty() && !is_hit(*hits, i)) last[i] = hits->certificate[i];
      if (!is_hit(*hits, i)) continue;
      any = true;
      all[static_cast<std::size_t>(i)].push_back(
          {hits->t[i], hits->t_lo[i], hits->t_hi[i], hits->iso[i], hits->sides[i], hits->certificate[i]});
      REQUIRE(all[static_cast<std::size_t>(i)].size() < 200);
    }
    surface.next_hit(rays, *hits, counts);
  }
  return all;
}
inline std::vector<Crossing> along(const Surface& surface, const Double3& o, const Double3& d) {
  Certificate last[kStreamSize];
  return all_crossings(surface, *one_ray(o, d), last)[0];
}
inline std::vector<double> places(const std::vector<Crossing>& crossings) {
  std::vector<double> t;
  for (const Crossing& c : crossings) t.push_back(c.t);
  return t;
}
inline void check_places(const std::vector<Crossing>& crossings, const std::vector<double>& expected) {
  const std::vector<double> t = places(crossings);
  CHECK_THAT(t, Catch::Approx(expected).margin(1e-6));
}

}  // namespace isocast::test
