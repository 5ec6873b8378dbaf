#include <fmt/format.h>
#include <isocast/apps/viewer/clip_planes.h>

#include <cmath>

namespace isocast::viewer {

std::vector<std::string> clip_formulas(const std::vector<ClipPlane>& planes, const Box& bounds) {
  std::vector<std::string> formulas;
  for (const ClipPlane& plane : planes) {
    if (!plane.on || bounds.empty()) continue;
    const double place = std::lerp(bounds.lo[plane.axis], bounds.hi[plane.axis], plane.place);
    const char axis = "xyz"[plane.axis];
    formulas.push_back(plane.above ? fmt::format("({})-{}", place, axis)
                                   : fmt::format("{}-({})", axis, place));
  }
  return formulas;
}

}  // namespace isocast::viewer
