#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/ray/copy_ray.h>
#include <isocast/render/stream_pass.h>
#include <isocast/volume/dress.h>
#include <isocast/volume/primary/volume_pass.h>
#include <isocast/volume/sample.h>
#include <isocast/volume/stream/stream_tracer.h>
#include <isocast/volume/sure_hits.h>
#include <isocast/volume/volume_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace isocast {
namespace {

void check_dims(const Volume& volume) {
  for (const std::int64_t n : volume.dims)
    if (n < 2 || n > kMaxDim)
      throw InputError(
          fmt::format("a volume of {} x {} x {} samples cannot be rendered: 2 to {} per axis are needed",
                      volume.dims[0], volume.dims[1], volume.dims[2], kMaxDim));
}

// Real samples of double precision lie below iso as they are; floats below iso as the corner value sees it.
double real_key(double iso, bool wide, bool double_precision) {
  if (wide) return iso;
  const double value = double_precision ? iso : static_cast<double>(static_cast<float>(iso));
  const float nearest = static_cast<float>(value);  // the smallest float that is not below
  return nearest < value ? std::nextafter(nearest, std::numeric_limits<float>::infinity()) : nearest;
}

// Clamped to far outside every integer type, which is still inside the keys' own type.
double integer_key(double iso, bool wide, bool double_precision) {
  const double value = wide || double_precision ? iso : static_cast<double>(static_cast<float>(iso)),
               limit = wide ? 0x1p33 : 0x1p20;
  return std::min(std::max(std::ceil(value), -limit), limit);
}

template <class S> double key_of(double iso, bool double_precision) {
  using Traits = SampleTraits<S>;
  return std::is_floating_point_v<typename Traits::Key> ? real_key(iso, Traits::wide, double_precision)
                                                        : integer_key(iso, Traits::wide, double_precision);
}

}  // namespace

double iso_key(SampleType type, double iso, bool double_precision) {
  return visit_sample_type(type, [&]<class S>(SampleTag<S>) { return key_of<S>(iso, double_precision); });
}
double iso_key(SparseType type, double iso, bool double_precision) {
  return visit_sparse_type(type, [&]<class S>(SparseTag<S>) {
    return key_of<typename SparseSample<S>::Type>(iso, double_precision);
  });
}

VolumeSurface::VolumeSurface(std::shared_ptr<const Volume> volume, const VolumeSurfaceOptions& options)
    : volume_(std::move(volume)) {
  const Transform grid_from_world = volume_->world_from_grid.inverse();
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) query_.grid_from_world[r][c] = grid_from_world.m[r][c];
  if (volume_->tree) use_tree();
  else use_dense_grid();
  set_options(options);
}

void VolumeSurface::use_dense_grid() {
  check_dims(*volume_);
  macrocells_.emplace(*volume_);
  GridView& grid = query_.grid;
  grid.samples = volume_->samples;
  grid.type = volume_->type;
  for (int i = 0; i < kMacroLevels; ++i) grid.levels[i] = macrocells_->level(i);
  Double3 last;
  for (int a = 0; a < 3; ++a) {
    grid.dims[a] = static_cast<std::int32_t>(volume_->dims[a]);
    query_.samples.last[a] = grid.dims[a] - 1;
    last[a] = query_.samples.last[a];
  }
  bricks_ = dense_bricks(grid);
  directory_ = BrickDirectory(bricks_, grid, query_.samples);
  bounds_ = world_box({0, 0, 0}, last);
}

// Cells with an active corner reach one sample beyond the active ones.
void VolumeSurface::use_tree() {
  const SparseTree& tree = *volume_->tree;
  query_.sparse = true;
  query_.tree = tree.view();
  if (tree.first_active()[0] > tree.last_active()[0]) return;
  ranges_.emplace(tree);
  query_.tree_ranges = ranges_->view();
  bricks_ = sparse_bricks(tree);
  Double3 first, last;
  for (int a = 0; a < 3; ++a) {
    query_.samples.first[a] = tree.first_active()[a] - 1;
    query_.samples.last[a] = tree.last_active()[a] + 1;
    query_.active.lo[a] = query_.samples.first[a] >> kTreeShifts[0];
    query_.active.hi[a] = (query_.samples.last[a] - 1) >> kTreeShifts[0];
    first[a] = query_.samples.first[a];
    last[a] = query_.samples.last[a];
  }
  directory_ = BrickDirectory(bricks_, query_.grid, query_.samples);
  bounds_ = active_bounds_ = world_box(first, last);
}

std::size_t VolumeSurface::acceleration_bytes() const {
  return directory_.bytes() + (macrocells_ ? macrocells_->bytes() : ranges_ ? ranges_->bytes() : 0);
}

MaskUse VolumeSurface::mask_use() const {
  MaskUse use;
  for (const auto& masks : masks_) {
    use.bricks += masks->bricks();
    use.masks += masks->count();
    use.bytes += masks->bytes();
  }
  if (united_) use.bytes += united_->bytes();
  use.bytes += pyramid_->bricks.bytes();
  return use;
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
    // what proves subtracts in double
    const bool precise = options.double_precision || options.method.proves();
    query_.key[i] = volume_->tree ? iso_key(volume_->tree->type(), stored, precise)
                                  : iso_key(volume_->type, stored, precise);
  }
  if (macrocells_) {
    query_.active = macrocells_->active_box({query_.key, static_cast<std::size_t>(query_.iso_count)});
    active_bounds_ = Box();
    if (const BlockBox& b = query_.active; b.lo[0] <= b.hi[0]) {
      const double size = 1 << query_.grid.levels[0].shift;
      active_bounds_ = world_box({b.lo[0] * size, b.lo[1] * size, b.lo[2] * size},
                                 {(b.hi[0] + 1) * size, (b.hi[1] + 1) * size, (b.hi[2] + 1) * size});
    }
  }
  choose_masks();
  query_.method = options.method.method;
  query_.options = options.method.options;
  query_.proves = options.method.proves();
  query_.double_precision = options.double_precision;
  query_.object = options.object;
  normals_ = options.normals;
  query_.cells = &cell_kernels(options.isa);
  isa_ = options.isa;
  order_ = options.order;
  use_device(options.device);
}

void VolumeSurface::use_device(std::shared_ptr<const VolumeDevice> device) {
  if (device == device_) return;
  tracer_ = device ? device->tracer_of(query_, {*volume_, macrocells_ ? &*macrocells_ : nullptr,
                                                ranges_ ? &*ranges_ : nullptr})
                   : nullptr;
  device_ = std::move(device);
}

// Those of iso-values that stay are kept.
void VolumeSurface::choose_masks() {
  std::vector<std::shared_ptr<const IsoMasks>> masks;
  for (int i = 0; i < query_.iso_count; ++i) {
    const double key = query_.key[i];
    const auto kept = std::ranges::find_if(masks_, [&](const auto& m) { return m->key() == key; });
    masks.push_back(kept != masks_.end() ? *kept : std::make_shared<const IsoMasks>(bricks_.count, key));
  }
  united_ = masks.size() > 1 ? std::make_shared<const BrickMasks>(bricks_.count) : nullptr;
  masks_ = std::move(masks);
  if (!pyramid_ || !query_.sparse) pyramid_ = std::make_unique<Pyramid>();
}

std::unique_ptr<PrimaryPass> VolumeSurface::primary(const View& view) const {
  if (tracer_)
    return std::make_unique<StreamPass>(*this, view, [this](auto rays, auto hits, TraceCounts& counts) {
      tracer_->trace(query_, false, rays, hits, counts);
    });
  if (bricks_.count == 0 || order_ != RayOrder::automatic) return nullptr;
  std::optional<BricksInView> bricks = find_bricks(query_, bricks_, volume_->world_from_grid, view);
  if (!bricks) return nullptr;
  return std::make_unique<VolumePass>(query_, masks_, view, std::move(*bricks), isa_);
}

MarchField VolumeSurface::march_field() const {
  MarchField field = {};
  field.query = &query_;
  field.bricks = directory_.view();
  std::call_once(pyramid_->made, [&] { pyramid_->bricks = BrickPyramid(field.bricks, query_); });
  field.pyramid = pyramid_->bricks.view();
  const double size = 1 << (query_.sparse ? kTreeShifts[0] : query_.grid.levels[0].shift);
  for (int a = 0; a < 3; ++a) {
    field.low[a] = std::max(query_.active.lo[a] * size, double(query_.samples.first[a]));
    field.high[a] = std::min((query_.active.hi[a] + 1) * size, double(query_.samples.last[a]));
  }
  for (std::size_t i = 0; i < masks_.size(); ++i) {
    field.masks[i] = masks_[i].get();
    field.made[i] = masks_[i]->made();
  }
  field.united = united_.get();
  field.all = united_ ? united_->made() : field.made[0];
  return field;
}

void VolumeSurface::first_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  if (active_bounds_.empty()) return;
  if (tracer_) return tracer_->trace(query_, false, {&rays, 1}, std::array{&hits}, counts);
  const DefaultFloatEnvironment environment;
  if (order_ == RayOrder::walk || !directory_.complete()) trace_first_hits(query_, rays, hits, counts);
  else trace_first_hits(march_field(), stream_kernels(isa_), rays, hits, counts);
}

void VolumeSurface::next_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  if (tracer_) return tracer_->trace(query_, true, {&rays, 1}, std::array{&hits}, counts);
  const DefaultFloatEnvironment environment;
  if (order_ == RayOrder::walk || !directory_.complete()) trace_next_hits(query_, rays, hits, counts);
  else trace_next_hits(march_field(), stream_kernels(isa_), rays, hits, counts);
}

void VolumeSurface::any_hit(const RayStream& rays, bool (&hit)[kStreamSize], TraceCounts& counts) const {
  if (active_bounds_.empty()) return;
  const DefaultFloatEnvironment environment;
  // what Schwarze's method loses of a surface casts no shadow
  const bool looks = !tracer_ && order_ != RayOrder::walk && macrocells_ && macrocells_->finite() &&
                     query_.method != CellMethod::schwarze;
  // a few that are known cost less than picking out the others
  if (!looks || find_sure_hits(query_, rays, hit, counts) * 8 < rays.size)
    return Surface::any_hit(rays, hit, counts);
  RayStream left;
  left.size = 0;
  left.kind = rays.kind;
  int slots[kStreamSize];
  for (int i = 0; i < rays.size; ++i) {
    if (hit[i]) continue;
    slots[left.size] = i;
    copy_ray(rays, i, left, left.size++);
  }
  bool found[kStreamSize] = {};
  if (left.size > 0) Surface::any_hit(left, found, counts);
  for (int n = 0; n < left.size; ++n) hit[slots[n]] = found[n];
}

void VolumeSurface::dress(const RayStream& rays, const HitStream& hits, const DressWishes& wishes,
                          DressedHits& dressed) const {
  const DefaultFloatEnvironment environment;
  dress_volume_hits({query_, dress_kernels(isa_), volume_->slope, volume_->intercept, normals_}, rays, hits,
                    wishes, dressed);
}

}  // namespace isocast
