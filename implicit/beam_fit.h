// Beams around rays: planes of an axis that all of them cross, and linear models of their points there.
#pragma once

#include <isocast/implicit/ray_segments.h>
#include <isocast/implicit/solve/beam.h>

namespace isocast {

/// Where a ray meets the planes of one axis: t = t0 + k dt for 0 <= k <= 1, within `rounding`.
struct AxisPath {
  double t0, dt, rounding;
};

/// The planes from `from` to `to` along `sign` times an axis, between which all rays run.
struct BeamPlanes {
  int axis = 0;
  double sign = 1, from = __builtin_inf(), to = -__builtin_inf();

  /// False where a ray is too slanted for any axis.
  [[nodiscard]] bool enclose(const ClippedRay* rays, int size);
  [[nodiscard]] AxisPath path(const ClippedRay& ray) const;
};

/// Points start + k span at places (u, v) of the picture; every true point lies within `rounding`.
struct BeamPoints {
  static constexpr int kMost = 64;
  int count = 0;
  double u[kMost], v[kMost], start[3][kMost], span[3][kMost], rounding[3] = {};

  void add(const BeamPlanes& planes, const ClippedRay& ray, const AxisPath& path, double at_u, double at_v);
};

/// The place of beam b in the picture: its u and v run from -1 to 1.
struct BeamFrame {
  double u, v, half_u, half_v;
};

/// Fits beam b to its points by least squares, with what is left over as slack and spread.
template <class T> BeamFrame fit_beam(const BeamPoints& points, BeamStream<T>& beams, int b);

/// The corners of beam b as points of a wider one.
template <class T>
void add_corners(const BeamStream<T>& beams, int b, const BeamFrame& frame, BeamPoints& points);

}  // namespace isocast
