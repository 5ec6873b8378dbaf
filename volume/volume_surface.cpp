#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/volume/dress.h>
#include <isocast/volume/volume_surface.h>

#include <cmath>
#include <limits>

namespace isocast {
namespace {

const Volume& checked(const Volume& volume) {
  for (const std::int64_t n : volume.dims)
    if (n < 2 || n > kMaxDim)
      throw InputError(
          fmt::format("a volume of {} x {} x {} samples cannot be rendered: 2 to {} per axis are needed",
                      volume.dims[0], volume.dims[1], volume.dims[2], kMaxDim));
  return volume;
}

}  // namespace

double iso_key(SampleType type, double iso, bool double_precision) {
  const bool wide = type == SampleType::u32 || type == SampleType::i32 || type == SampleType::f64;
  const double value = wide || double_precision ? iso : static_cast<double>(static_cast<float>(iso));
  if (type == SampleType::f64) return value;
  if (is_float(type)) {  // the smallest float that is not below
    const float nearest = static_cast<float>(value);
    return nearest < value ? std::nextafter(nearest, std::numeric_limits<float>::infinity()) : nearest;
  }
  constexpr double kBeyond =
      0x1p33;  // outside every integer type, inside the keys' for the narrow ones after the clamp
  const double limit = wide ? kBeyond : 0x1p20;
  return std::min(std::max(std::ceil(value), -limit), limit);
}

VolumeSurface::VolumeSurface(std::shared_ptr<const Volume> volume, const VolumeSurfaceOptions& options)
    : volume_(std::move(volume)),
      macrocells_(checked(*volume_)),
      grid_from_world_(volume_->world_from_grid.inverse()) {
  GridView& grid = query_.grid;
  grid.samples = volume_->samples;
  grid.type = volume_->type;
  for (int a = 0; a < 3; ++a) grid.dims[a] = static_cast<std::int32_t>(volume_->dims[a]);
  for (int i = 0; i < kMacroLevels; ++i) grid.levels[i] = macrocells_.level(i);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) query_.grid_from_world[r][c] = grid_from_world_.m[r][c];
  bounds_ =
      world_box({0, 0, 0}, {double(grid.dims[0] - 1), double(grid.dims[1] - 1), double(grid.dims[2] - 1)});
  set_options(options);
}

Box VolumeSurface::world_box(const Double3& lo, const Double3& hi) const {
  Box box;
  for (int i = 0; i < 8; ++i) box.add(volume_->world_from_grid.point(Box{lo, hi}.corner(i)));
  return box;
}

bool VolumeSurface::narrow(const TileFrustum& tile) const {
  return !active_bounds_.empty() && tile.may_meet(active_bounds_);
}

void VolumeSurface::set_options(const VolumeSurfaceOptions& options) {
  if (options.iso.empty() || options.iso.size() > kMaxIsos)
    throw InputError(fmt::format("{} iso-values were given; 1 to {} are possible for a volume",
                                 options.iso.size(), kMaxIsos));
  query_.iso_count = static_cast<std::int32_t>(options.iso.size());
  for (int i = 0; i < query_.iso_count; ++i) {
    const double value = options.iso[static_cast<std::size_t>(i)],
                 stored = (value - volume_->intercept) / volume_->slope;
    if (!std::isfinite(stored)) throw InputError(fmt::format("iso-value {} is no finite number", value));
    query_.iso[i] = stored;
    query_.key[i] = iso_key(volume_->type, stored, options.double_precision);
  }
  query_.active = macrocells_.active_box({query_.key, static_cast<std::size_t>(query_.iso_count)});
  active_bounds_ = Box();
  if (const BlockBox& b = query_.active; b.lo[0] <= b.hi[0]) {
    const double size = 1 << query_.grid.levels[0].shift;
    active_bounds_ = world_box({b.lo[0] * size, b.lo[1] * size, b.lo[2] * size},
                               {(b.hi[0] + 1) * size, (b.hi[1] + 1) * size, (b.hi[2] + 1) * size});
  }
  query_.method = options.method.method;
  query_.options = options.method.options;
  query_.double_precision = options.double_precision;
  query_.object = options.object;
  normals_ = options.normals;
  query_.cells = &cell_kernels(options.isa);
}

void VolumeSurface::first_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  if (active_bounds_.empty()) return;
  const DefaultFloatEnvironment environment;
  trace_first_hits(query_, rays, hits, counts);
}

void VolumeSurface::next_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  const DefaultFloatEnvironment environment;
  trace_next_hits(query_, rays, hits, counts);
}

void VolumeSurface::dress(const RayStream& rays, const HitStream& hits, const DressWishes& wishes,
                          DressedHits& dressed) const {
  const DefaultFloatEnvironment environment;
  dress_volume_hits({*volume_, grid_from_world_, query_.object, normals_}, rays, hits, wishes, dressed);
}

}  // namespace isocast
