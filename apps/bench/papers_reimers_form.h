// The frustum form as its paper makes it: one for the whole picture.
#pragma once

#include <isocast/apps/scene_build/description.h>
#include <isocast/implicit/frustum/depth_range.h>
#include <isocast/render/camera.h>

namespace isocast::bench {

/// The depths at which the picture sees a box, which it does.
[[nodiscard]] DepthRange depths_of(const View& view, const Box& box);

/// The largest |Bernstein coefficient| of f over the picture and these depths: what errors of f are measured
/// in. Good to some digits up to degree 16.
///
/// degree  of f in all, at most kMostFormDegree
/// source  Reimers, Seland 2008, sections 3 and 6.1
[[nodiscard]] double largest_coefficient(const FormulaSource& f, int degree, const View& view,
                                         const DepthRange& depths);

/// Where f is asked for, in [0, 1]: Chebyshev's points; j / d; (2j + 1) / (2d + 2).
enum class Nodes : std::uint8_t { chebyshev, even, even_inside };

/// |Omega| |Omega^-1| in the row-sum norm, Omega being the matrix from Bernstein coefficients of a degree of
/// at least 1 to values at the nodes.
[[nodiscard]] double collocation_condition(int degree, Nodes nodes);

}  // namespace isocast::bench
