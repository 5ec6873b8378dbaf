#include <fmt/format.h>
#include <isocast/apps/scene_build/applicable_methods.h>
#include <isocast/apps/viewer/probe_work.h>
#include <isocast/base/error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

namespace isocast::viewer {
namespace {

// Where the ray is inside the box.
std::optional<std::array<double, 2>> chord(const Box& box, const Double3& o, const Double3& d) {
  double t0 = 0, t1 = std::numeric_limits<double>::infinity();
  for (int a = 0; a < 3; ++a) {
    const double lo = (box.lo[a] - o[a]) / d[a], hi = (box.hi[a] - o[a]) / d[a];
    if (d[a] == 0 && (o[a] < box.lo[a] || o[a] > box.hi[a])) return std::nullopt;
    if (d[a] != 0) t0 = std::max(t0, std::min(lo, hi)), t1 = std::min(t1, std::max(lo, hi));
  }
  if (box.empty() || !(t0 < t1) || !std::isfinite(t1)) return std::nullopt;
  return std::array{t0, t1};
}

// Where a coordinate of the grid is whole.
std::vector<double> cell_borders(const Volume& volume, const Double3& o, const Double3& d, double t0,
                                 double t1) {
  const Transform grid_from_world = volume.world_from_grid.inverse();
  const Double3 a = grid_from_world.point(o + t0 * d), b = grid_from_world.point(o + t1 * d);
  std::vector<double> borders;
  for (int axis = 0; axis < 3; ++axis) {
    const double lo = std::min(a[axis], b[axis]), hi = std::max(a[axis], b[axis]);
    constexpr double kMost = 1 << 16;
    if (!(hi - lo < kMost)) continue;
    for (double plane = std::ceil(lo); plane <= hi; ++plane)
      if (a[axis] != b[axis]) borders.push_back(t0 + (plane - a[axis]) / (b[axis] - a[axis]) * (t1 - t0));
  }
  std::ranges::sort(borders);
  return borders;
}

// The cell that holds a point of the world.
void set_cell(const Volume& volume, const Transform& grid_from_world, const Double3& p, HitStream& hits,
              int i) {
  const Double3 g = grid_from_world.point(p);
  for (int a = 0; a < 3; ++a) {
    const double last = volume.tree ? 1e9 : static_cast<double>(volume.dims[static_cast<std::size_t>(a)] - 2),
                 first = volume.tree ? -1e9 : 0;
    hits.cell[a][i] = static_cast<std::int32_t>(std::clamp(std::floor(g[a]), first, last));
  }
}

}  // namespace

RayProfile profile_along(const BuiltObject& object, const PixelRay& ray, int steps) {
  const Surface& surface = *object.unclipped.front();
  const Volume* const volume = object.volume.get();
  const auto& [o, d] = ray;
  RayProfile profile;
  const auto part = chord(surface.bounds(), o, d);
  if (!part) return profile;
  std::tie(profile.t0, profile.t1) = std::tie((*part)[0], (*part)[1]);
  if (volume) profile.borders = cell_borders(*volume, o, d, profile.t0, profile.t1);
  const Transform grid_from_world = volume ? volume->world_from_grid.inverse() : Transform();

  // points of the ray are dressed as hits are
  const auto rays = std::make_unique<RayStream>();
  const auto hits = std::make_unique<HitStream>();
  const auto dressed = std::make_unique<DressedHits>();
  rays->kind = RayKind::reflection;
  for (int from = 0; from <= steps; from += kStreamSize) {
    rays->size = std::min(kStreamSize, steps + 1 - from);
    clear(*hits);
    for (int i = 0; i < rays->size; ++i) {
      const double t = std::lerp(profile.t0, profile.t1, static_cast<double>(from + i) / steps);
      rays->ox[i] = o[0], rays->oy[i] = o[1], rays->oz[i] = o[2];
      rays->dx[i] = d[0], rays->dy[i] = d[1], rays->dz[i] = d[2];
      rays->t_min[i] = 0, rays->t_max[i] = profile.t1;
      hits->t[i] = hits->t_lo[i] = hits->t_hi[i] = t;
      hits->object[i] = static_cast<std::uint16_t>(object.place);
      dressed->value[i] = std::nan("");
      if (volume) set_cell(*volume, grid_from_world, o + t * d, *hits, i);
    }
    surface.dress(*rays, *hits, {.value = true}, *dressed);
    for (int i = 0; i < rays->size; ++i) profile.values.push_back(static_cast<float>(dressed->value[i]));
  }
  return profile;
}

PixelProbe probe_pixel(const JobScene& scene, int x, int y, std::size_t otherwise) {
  SceneKeeper& keeper = scene.keeper;
  const std::size_t number = object_at(keeper.built(), scene.view, x, y).value_or(otherwise);
  const BuiltObject& object = keeper.built().objects[number];
  PixelProbe result;
  result.x = x, result.y = y;
  if (keeper.built().objects.size() > 1)
    result.object = object.name.empty() ? fmt::format("number {}", number + 1) : object.name;
  if (!keeper.has_methods(number)) {
    result.error = "Only volumes and formulas are probed.";
    return result;
  }
  result.iso = object.iso;
  result.unit = object.volume ? "voxels" : "domain widths";
  const LoneObject lone = keeper.alone(number);
  std::vector<ProbeMethod> methods;
  for (const Method& method : applicable_methods(lone.description.objects.front()))
    methods.push_back({std::string(method.name), {}});
  const MethodRestorer restorer(keeper, number);
  try {
    result.probe =
        probe_ray(lone.description, lone.built, scene.view, x, y, methods, evaluation_of(keeper.words()).isa);
  } catch (const InputError& problem) { result.error = problem.what(); }
  constexpr int kSteps = 1023;
  result.profile = profile_along(object, pixel_ray(scene.view, x, y), kSteps);
  return result;
}

}  // namespace isocast::viewer
