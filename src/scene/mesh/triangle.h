// One ray and one triangle, watertight.
#pragma once

#include <isocast/scene/mesh/projection.h>

#include <optional>

namespace isocast {

/// t, and the weights of the second and the third corner; enters: the ray comes from outside.
struct TriangleHit {
  double t, u, v;
  bool enters;
};

/// Ray `lane` of a packet and the triangle with these corners, in double precision.
///
/// Which side of each edge the ray passes is decided exactly for the corners as `project` has them, which
/// depend on ray and corner alone; a ray through an edge or a corner counts as a ray beside it, in one
/// direction for all triangles. So a ray through a closed mesh crosses exactly one triangle wherever it
/// crosses the surface. t is a mean of those of the corners. Nothing where the ray passes, or sees the
/// triangle from its edge.
///
/// source  Woop, Benthin, Wald: Watertight ray/triangle intersection, JCGT 2(1), 2013; Edelsbrunner, Mücke:
///         Simulation of simplicity, ACM Transactions on Graphics 9(1), 1990
[[nodiscard]] std::optional<TriangleHit> hit_triangle(const ProjectedPacket& packet, int lane,
                                                      const double* a, const double* b, const double* c);

/// The packet of the stream that begins at slot `first`, its planes scaled so that `size` is about 1. Rays
/// without a direction see no triangle.
[[nodiscard]] ProjectedPacket project_packet(const RayStream& rays, int first, double size);

}  // namespace isocast
