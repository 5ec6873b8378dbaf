// Rays of all kinds, and whether two surfaces answer them with the same bits.
#pragma once

#include <isocast/ray/surface.h>

#include <catch2/catch.hpp>
#include <random>

#include "rays.h"
#include "same_hits.h"

namespace isocast::test {

// Rays from samples, faces, inside and far away, with ends here and there, and what another object has hit.
inline void fill_random(std::mt19937_64& random, const Box& box, Streams& streams) {
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
inline void leave(std::mt19937_64& random, const Streams& from, Streams& to) {
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

inline void require_same(const HitStream& a, const HitStream& b) {
  const int slot = first_difference(a, b);
  INFO("slot " << slot << ": t " << a.t[std::max(slot, 0)] << " and " << b.t[std::max(slot, 0)]);
  REQUIRE(slot == -1);
}

// Whether anything is hit.
inline void compare_any(const Surface& walk, const Surface& stream, const RayStream& rays) {
  TraceCounts counts;
  bool any[kStreamSize] = {};
  stream.any_hit(rays, any, counts);
  const auto first = std::make_unique<HitStream>();
  clear(*first);
  walk.first_hit(rays, *first, counts);
  for (int i = 0; i < rays.size; ++i) REQUIRE(any[i] == (first->t[i] < Box::inf));
}

// First hits, three more behind them, and what rays meet that start there; returns the number of all hits.
inline std::int64_t compare_hits(std::mt19937_64& random, const Surface& walk, const Surface& stream,
                                 const Streams& asked, int depth) {
  std::int64_t count = 0;
  TraceCounts counts;
  const auto a = std::make_unique<Streams>(asked), b = std::make_unique<Streams>(asked);
  walk.first_hit(a->rays, a->hits, counts);
  stream.first_hit(b->rays, b->hits, counts);
  require_same(a->hits, b->hits);
  compare_any(walk, stream, asked.rays);
  if (depth > 0) {
    const std::unique_ptr<Streams> left = make_streams();
    leave(random, *a, *left);
    count += compare_hits(random, walk, stream, *left, depth - 1);
  }
  for (int behind = 0; behind < 3; ++behind) {
    for (int i = 0; i < a->rays.size; ++i) count += a->hits.object[i] == 0 && is_hit(a->hits, i);
    walk.next_hit(a->rays, a->hits, counts);
    stream.next_hit(b->rays, b->hits, counts);
    require_same(a->hits, b->hits);
  }
  return count;
}

}  // namespace isocast::test
