// Rays that are chosen for what they meet.
#pragma once

#include <isocast/math/box.h>
#include <isocast/ray/stream.h>

#include <vector>

namespace isocast::bench {

/// size x size rays, numbered by their ids. All start at t = 0, and no direction is shorter than 1.
using MakeRays = std::vector<RayStream> (*)(const Box& box, int size);

/// Those of a camera in front of the box, which fills the picture.
[[nodiscard]] std::vector<RayStream> framing_rays(const Box& box, int size);
/// Along one of the axes, from outside, through a lattice that holds the box's middle planes and faces.
[[nodiscard]] std::vector<RayStream> axis_rays(const Box& box, int size);
/// From random points inside in random directions.
[[nodiscard]] std::vector<RayStream> inner_rays(const Box& box, int size);

// Of volumes with samples at whole coordinates.

/// In faces of cells; a third of them along edges, a third through corners.
[[nodiscard]] std::vector<RayStream> face_rays(const Box& box, int size);
/// Along z through the middles of cells.
[[nodiscard]] std::vector<RayStream> central_rays(const Box& box, int size);
/// From points with x = 7.
[[nodiscard]] std::vector<RayStream> rays_from_x7(const Box& box, int size);

// Of formulas; numbers are such that f is zero exactly where it is meant to be.

/// From points with x^2 + y^2 + z^2 = (9/16)^2.
[[nodiscard]] std::vector<RayStream> rays_from_sphere(const Box&, int size);
/// Nearly along x, from x between 0 and 1.
[[nodiscard]] std::vector<RayStream> lengthwise_rays(const Box&, int size);
/// Across the double lines of the catalogue's surfaces, where nothing else is.
[[nodiscard]] std::vector<RayStream> across_steiner(const Box&, int size);
[[nodiscard]] std::vector<RayStream> across_cross_cap(const Box&, int size);
/// Across the axis of the catalogue's teardrop, whose radius at x is x^2 sqrt((x + 1) / 2).
[[nodiscard]] std::vector<RayStream> across_teardrop_tip(const Box&, int size);

}  // namespace isocast::bench
