// Affine maps of space in double precision: host code only (a kernel receives its twelve numbers).
#pragma once

#include <array>
#include <cmath>

namespace isocast {

using Double3 = std::array<double, 3>;

/// p -> A p + b with rows {A | b}. Names carry the spaces, target first: world_from_grid maps grid to world.
struct Transform {
  double m[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};

  [[nodiscard]] Double3 point(const Double3& p) const {
    Double3 q;
    for (int r = 0; r < 3; ++r) q[r] = m[r][0] * p[0] + m[r][1] * p[1] + m[r][2] * p[2] + m[r][3];
    return q;
  }
  [[nodiscard]] Double3 vector(const Double3& v) const {
    Double3 q;
    for (int r = 0; r < 3; ++r) q[r] = m[r][0] * v[0] + m[r][1] * v[1] + m[r][2] * v[2];
    return q;
  }
  /// A^T v: with the inverse map this turns a gradient in this map's source space into one in its target
  /// space.
  [[nodiscard]] Double3 transposed_vector(const Double3& v) const {
    Double3 q;
    for (int c = 0; c < 3; ++c) q[c] = m[0][c] * v[0] + m[1][c] * v[1] + m[2][c] * v[2];
    return q;
  }
  [[nodiscard]] double determinant() const {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  }
  /// The inverse map; entries are infinite or NaN when the determinant is zero.
  [[nodiscard]] Transform inverse() const {
    Transform t;
    const double k = 1 / determinant();
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) {
        const int r1 = (c + 1) % 3, r2 = (c + 2) % 3, c1 = (r + 1) % 3, c2 = (r + 2) % 3;
        t.m[r][c] = k * (m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1]);
      }
    for (int r = 0; r < 3; ++r)
      t.m[r][3] = -(t.m[r][0] * m[0][3] + t.m[r][1] * m[1][3] + t.m[r][2] * m[2][3]);
    return t;
  }
};

/// Composition: (a * b)(p) = a(b(p)).
[[nodiscard]] inline Transform operator*(const Transform& a, const Transform& b) {
  Transform t;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c)
      t.m[r][c] =
          a.m[r][0] * b.m[0][c] + a.m[r][1] * b.m[1][c] + a.m[r][2] * b.m[2][c] + (c == 3 ? a.m[r][3] : 0);
  return t;
}

[[nodiscard]] inline double dot(const Double3& a, const Double3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
[[nodiscard]] inline Double3 cross(const Double3& a, const Double3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
[[nodiscard]] inline double length(const Double3& a) { return std::sqrt(dot(a, a)); }
/// a / |a|; the zero vector stays zero.
[[nodiscard]] inline Double3 normalized(const Double3& a) {
  const double n = length(a);
  return n > 0 ? Double3{a[0] / n, a[1] / n, a[2] / n} : a;
}
[[nodiscard]] inline Double3 operator+(const Double3& a, const Double3& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
[[nodiscard]] inline Double3 operator-(const Double3& a, const Double3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
[[nodiscard]] inline Double3 operator*(double k, const Double3& a) { return {k * a[0], k * a[1], k * a[2]}; }

}  // namespace isocast
