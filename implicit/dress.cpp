#include <isocast/implicit/expression/evaluate.h>
#include <isocast/implicit/implicit_surface.h>
#include <isocast/implicit/register_memory.h>
#include <isocast/implicit/solve/inclusion.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isocast {

Double3 ImplicitSurface::difference_normal(const Double3& p, double distance) const {
  double longest = 0, largest = 0;
  for (int a = 0; a < 3; ++a) {
    longest = std::max(longest, bounds_.hi[a] - bounds_.lo[a]);
    largest = std::max({largest, std::abs(bounds_.lo[a]), std::abs(bounds_.hi[a])});
  }
  const double grows = options_.method.normal_grows ? distance / longest : 1;
  // below it roundings of f outweigh its change
  const double h =
      std::max(options_.method.normal_step * eps_ * grows, std::cbrt(kSpacing<double>) * largest);
  auto* const registers = static_cast<double*>(registers_of(tape_.registers * sizeof(double)));
  Double3 normal;
  for (int a = 0; a < 3; ++a) {
    double inputs[4] = {p[0], p[1], p[2], options_.time};
    inputs[a] = p[a] + h;
    const double ahead = evaluate(tape_.view(), inputs, registers);
    inputs[a] = p[a] - h;
    normal[a] = ahead - evaluate(tape_.view(), inputs, registers);
  }
  return normalized(normal);
}

void ImplicitSurface::dress(const RayStream& rays, const HitStream& hits, const DressWishes& wishes,
                            DressedHits& dressed) const {
  const DefaultFloatEnvironment environment;
  using F = Gradient<double>;
  auto* const registers = static_cast<F*>(registers_of(tape_.registers * sizeof(F)));
  for (int i = 0; i < rays.size; ++i) {
    if (hits.object[i] != options_.object || !(hits.t[i] < std::numeric_limits<double>::infinity())) continue;
    const Double3 d = {rays.dx[i], rays.dy[i], rays.dz[i]},
                  p = Double3{rays.ox[i], rays.oy[i], rays.oz[i]} + hits.t[i] * d;
    if (wishes.position)
      for (int a = 0; a < 3; ++a) dressed.position[a][i] = p[a];
    if (!wishes.normal && !wishes.value) continue;
    const F inputs[4] = {{p[0], 1, 0, 0}, {p[1], 0, 1, 0}, {p[2], 0, 0, 1}, F(options_.time)};
    const F f = evaluate(tape_.view(), inputs, registers);
    if (wishes.value) dressed.value[i] = f.value;
    if (!wishes.normal) continue;
    const Double3 normal = options_.normals == NormalKind::gradient
                               ? normalized({f.dx, f.dy, f.dz})
                               : difference_normal(p, hits.t[i] * length(d));
    const double turn = dot(normal, d) > 0 ? -1 : 1;
    for (int a = 0; a < 3; ++a) dressed.normal[a][i] = turn * normal[a];
  }
}

}  // namespace isocast
