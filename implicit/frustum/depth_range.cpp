#include <isocast/implicit/frustum/depth_range.h>

#include <vector>

namespace isocast {
namespace {

struct Plane {
  Double3 normal;
  double offset;
  [[nodiscard]] double distance(const Double3& p) const { return dot(normal, p) - offset; }
};

Double3 point_at(const PixelLines& lines, double u, double v, double s) {
  Double3 p;
  for (int a = 0; a < 3; ++a)
    p[a] = lines.o[a] + u * lines.o_u[a] + v * lines.o_v[a] +
           s * (lines.d[a] + u * lines.d_u[a] + v * lines.d_v[a]);
  return p;
}

// The plane through the rays of two pixel positions, with `inside` on its positive side.
Plane plane_through(const PixelLines& lines, const double (&a)[2], const double (&b)[2],
                    const Double3& inside) {
  const Double3 p = point_at(lines, a[0], a[1], 1), q = point_at(lines, b[0], b[1], 1),
                further = point_at(lines, a[0], a[1], 2);
  Plane plane{normalized(cross(further - p, q - p)), 0};
  plane.offset = dot(plane.normal, p);
  if (plane.distance(inside) < 0) plane = {-1.0 * plane.normal, -plane.offset};
  return plane;
}

// What of a convex polygon lies on the positive side, and a little more (Sutherland and Hodgman).
std::vector<Double3> clipped(const std::vector<Double3>& polygon, const Plane& plane, double room) {
  std::vector<Double3> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Double3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double a = plane.distance(p) + room, b = plane.distance(q) + room;
    if (a >= 0) result.push_back(p);
    if ((a < 0) != (b < 0)) result.push_back(p + (a / (a - b)) * (q - p));
  }
  return result;
}

}  // namespace

std::optional<DepthRange> depth_range(const PixelLines& lines, double u0, double u1, double v0, double v1,
                                      const Box& box) {
  const double corners[4][2] = {{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}};
  const Double3 middle = point_at(lines, 0.5 * (u0 + u1), 0.5 * (v0 + v1), 1);
  Plane sides[4];
  for (int i = 0; i < 4; ++i) sides[i] = plane_through(lines, corners[i], corners[(i + 1) % 4], middle);
  // depth is a linear function of the point: 1 at any s = 1
  const Double3 eye = point_at(lines, u0, v0, 0),
                across = cross(point_at(lines, u1, v0, 1) - point_at(lines, u0, v0, 1),
                               point_at(lines, u0, v1, 1) - point_at(lines, u0, v0, 1));
  const Double3 axis = normalized(across);
  const double per_depth = dot(axis, point_at(lines, u0, v0, 1) - eye);
  const auto depth = [&](const Double3& p) { return dot(axis, p - eye) / per_depth; };

  const double room = 1e-9 * (box.diagonal() + length(eye - box.center()));
  DepthRange range{Box::inf, -Box::inf};
  const auto add = [&range](double s) {
    range.near = std::min(range.near, s), range.far = std::max(range.far, s);
  };
  bool eye_inside = true;
  for (int a = 0; a < 3; ++a) {
    eye_inside = eye_inside && eye[a] >= box.lo[a] && eye[a] <= box.hi[a];
    for (const double at : {box.lo[a], box.hi[a]}) {
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      std::vector<Double3> face(4);
      for (std::size_t i = 0; i < 4; ++i) {
        face[i][a] = at;
        face[i][b] = i == 1 || i == 2 ? box.hi[b] : box.lo[b];
        face[i][c] = i >= 2 ? box.hi[c] : box.lo[c];
      }
      for (const Plane& side : sides) face = clipped(face, side, room);
      for (const Double3& p : face) add(depth(p));
    }
  }
  if (eye_inside) add(0);
  if (!(range.near <= range.far) || !(range.far > 0)) return std::nullopt;
  const double more = room / std::abs(per_depth) + 1e-9 * range.far;
  return DepthRange{std::max(0.0, range.near - more), range.far + more};
}

}  // namespace isocast
