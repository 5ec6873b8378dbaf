#include <isocast/implicit/expression/evaluate.h>
#include <isocast/implicit/implicit_surface.h>
#include <isocast/implicit/register_memory.h>
#include <isocast/math/rounding.h>
#include <isocast/ray/neighbour_normals.h>

#include <algorithm>
#include <cmath>

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

namespace {

// Turned against the ray.
void put_normal(const RayStream& rays, int i, const Double3& normal, DressedHits& dressed) {
  const double turn = dot(normal, {rays.dx[i], rays.dy[i], rays.dz[i]}) > 0 ? -1 : 1;
  for (int a = 0; a < 3; ++a) dressed.normal[a][i] = turn * normal[a];
}

}  // namespace

// Normals that need no evaluation of f: made[i] where there is one. False where all hits have one.
bool ImplicitSurface::put_cheap_normals(const RayStream& rays, const HitStream& hits, DressedHits& dressed,
                                        bool (&made)[kStreamSize]) const {
  if (options_.normals == NormalKind::neighbour && rays.kind == RayKind::primary &&
      normal_kernels(options_.isa).find_neighbour_normals(rays, hits, options_.object, dressed, made) == 0)
    return false;
  if (!has_form_normals()) return true;
  for (int i = 0; i < rays.size; ++i) {
    if (made[i] || hits.object[i] != options_.object || !is_hit(hits, i)) continue;
    const auto normal = form_normal(hits, i);
    made[i] = normal.has_value();
    if (normal) put_normal(rays, i, *normal, dressed);
  }
  return true;
}

void ImplicitSurface::dress(const RayStream& rays, const HitStream& hits, const DressWishes& wishes,
                            DressedHits& dressed) const {
  const DefaultFloatEnvironment environment;
  bool made[kStreamSize] = {};
  const bool all = wishes.value || wishes.position;
  if (wishes.normal && !put_cheap_normals(rays, hits, dressed, made) && !all) return;

  GradientStream points;
  points.size = 0;
  int slots[kStreamSize];
  for (int i = 0; i < rays.size; ++i) {
    if ((made[i] && !all) || hits.object[i] != options_.object || !is_hit(hits, i)) continue;
    const double o[3] = {rays.ox[i], rays.oy[i], rays.oz[i]}, d[3] = {rays.dx[i], rays.dy[i], rays.dz[i]};
    slots[points.size] = i;
    for (int a = 0; a < 3; ++a) points.position[a][points.size] = o[a] + hits.t[i] * d[a];
    ++points.size;
  }
  if (wishes.position)
    for (int n = 0; n < points.size; ++n)
      for (int a = 0; a < 3; ++a) dressed.position[a][slots[n]] = points.position[a][n];
  if (points.size == 0 || (!wishes.normal && !wishes.value)) return;

  // what fills up the last of the kernels' packs
  for (int n = points.size; n % kPacketSize != 0; ++n)
    for (auto& axis : points.position) axis[n] = 0;
  const FormulaKernels& kernels = formula_kernels(options_.isa);
  // pruning takes about as long as the gradients of so many points
  constexpr int kFewPoints = 64;
  const Tape& tape =
      pruning_.prunes && points.size > kFewPoints ? pruned_around(points, tape_, options_.time) : tape_;
  kernels.find_gradients(tape.view(), options_.time, points,
                         registers_of(tape.registers * kernels.gradient_bytes));
  for (int n = 0; n < points.size; ++n) {
    const int i = slots[n];
    if (wishes.value) dressed.value[i] = points.value[n];
    if (!wishes.normal || made[i]) continue;
    const Double3 normal =
        options_.normals != NormalKind::difference
            ? Double3{points.normal[0][n], points.normal[1][n], points.normal[2][n]}
            : difference_normal({points.position[0][n], points.position[1][n], points.position[2][n]},
                                hits.t[i] * length({rays.dx[i], rays.dy[i], rays.dz[i]}));
    put_normal(rays, i, normal, dressed);
  }
}

}  // namespace isocast
