// How far the points of a ray may truly be from where double precision puts them, in grid space.
#pragma once

#include <isocast/math/real.h>
#include <isocast/volume/query.h>

namespace isocast::inline ISO_ISA {

/// What the roundings of double precision can move the points of a ray by: at_origin + |t| along.
struct RaySlack {
  double at_origin, along;
};

/// 16 unit roundoffs of everything that the points of the ray o + t d of the world are sums of.
ISO_HD inline RaySlack ray_slack(const VolumeQuery& query, const double (&o)[3], const double (&d)[3]) {
  RaySlack slack = {};
  for (const double(&row)[4] : query.grid_from_world) {
    const double x = abs(row[0]), y = abs(row[1]), z = abs(row[2]);
    slack.at_origin = max(slack.at_origin, x * abs(o[0]) + y * abs(o[1]) + z * abs(o[2]) + abs(row[3]));
    slack.along = max(slack.along, x * abs(d[0]) + y * abs(d[1]) + z * abs(d[2]));
  }
  return {0x1p-49 * slack.at_origin, 0x1p-49 * slack.along};
}

/// How far the ends of a chord may truly be from where they are: the ray's slack, twice for what a face cuts
/// off, and the rounding to T.
template <class T> ISO_HD inline T chord_slack(const RaySlack& ray, double t_in, double t_out) {
  const double t = max(abs(t_in), abs(t_out));
  const double slack = 2 * (ray.at_origin + t * ray.along);
  return T(slack * 1.0001) + T(kUnitRoundoff<T>);
}

}  // namespace isocast::inline ISO_ISA
