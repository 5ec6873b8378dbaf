// Compiled once per instruction set: object order over the native registers.
#include <isocast/volume/primary/draw_brick.h>

namespace isocast::inline ISO_ISA {

extern const PrimaryKernels primary_kernel_table;

namespace {

using R = Native<double>;

constexpr int kTile = 16;

// A ray in grid space, as grid_ray (trace_stream.h) has it.
template <Real R> PrimaryRay<R> to_grid(const VolumeQuery& query, const PrimaryRay<R>& world) {
  const auto point = [&](const double(&m)[4]) {
    return R(m[0]) * world.o.x + R(m[1]) * world.o.y + R(m[2]) * world.o.z + R(m[3]);
  };
  const auto vector = [&](const double(&m)[4]) {
    return R(m[0]) * world.d.x + R(m[1]) * world.d.y + R(m[2]) * world.d.z;
  };
  const double(&m)[3][4] = query.grid_from_world;
  return {{point(m[0]), point(m[1]), point(m[2])}, {vector(m[0]), vector(m[1]), vector(m[2])}};
}

bool is_parallel(double inverse) { return !(abs(inverse) < __builtin_inf()); }

// Whether float can tell where planes are met. inverse: in the unit of t
template <Real R> Mask<R> is_quick(R inverse) {
  return (abs(inverse) > R(0x1p-40)) & (abs(inverse) < R(0x1p40));
}

// The number of the cells that a ray keeps to along an axis that it is parallel to, as find_block
// (traverse.h) has it; a number that no cell has outside the active blocks.
double parallel_cell(const VolumeQuery& query, int a, double o, double d) {
  const int shift = query.sparse ? kTreeShifts[0] : query.grid.levels[0].shift;
  const double size = double(1 << shift),
               first = max(double(query.active.lo[a]) * size, double(query.samples.first[a])),
               end = min((double(query.active.hi[a]) + 1) * size, double(query.samples.last[a]));
  if (!(o >= first && o <= end)) return __builtin_inf();
  const double cell = min(floor(o), end - 1);
  return d < 0 && cell > first && cell >= o ? cell - 1 : cell;
}

// What a first look at orthographic rays needs. corner: where the first ray of the patch starts.
void start_quick(const VolumeQuery& query, const Vec3<double>& corner, PatchState& patch) {
  const double size = kPatchSize, u = patch.x + patch.offset_u, v = patch.y + patch.offset_v;
  const Vec3<double> across = to_grid(query, primary_ray(patch.frame, u + size, v)).o,
                     down = to_grid(query, primary_ray(patch.frame, u, v + size)).o;
  const double from[3] = {corner.x, corner.y, corner.z}, along[3] = {across.x, across.y, across.z},
               below[3] = {down.x, down.y, down.z};
  PatchLook& look = patch.look;
  for (int a = 0; a < 3; ++a) {
    const double inverse = look.shared_inverse[a] * patch.unit;
    look.corner[a] = from[a];
    look.shared_quick[a] = is_quick(inverse) ? inverse : 0;
    look.reach[a] = (abs(along[a] - from[a]) + abs(below[a] - from[a])) * abs(look.shared_quick[a]);
  }
}

void start_patch(const VolumeQuery& query, PatchState& patch) {
  const RayFrame& frame = patch.frame;
  const PrimaryRay<double> ray =
      to_grid(query, primary_ray(frame, patch.x + patch.offset_u, patch.y + patch.offset_v));
  const Vec3<double>& shared = frame.orthographic ? ray.d : ray.o;
  const double numbers[3] = {shared.x, shared.y, shared.z};
  for (int a = 0; a < 3; ++a) {
    patch.look.shared[a] = numbers[a];
    patch.look.shared_inverse[a] = 1 / numbers[a];
    patch.look.parallel[a] = frame.orthographic && is_parallel(1 / numbers[a]);
  }
  if (frame.orthographic) start_quick(query, ray.o, patch);
  patch.stale = ~std::uint64_t(0);
  for (auto* rows : {patch.met, patch.walk})
    for (int y = 0; y < kPatchSize; ++y) rows[y] = 0;
  patch.queue = {};
  (query.double_precision ? patch.cells_double.next : patch.cells_float.next) = 0;
}

// A ray that is almost parallel to an axis in perspective, which few are, is the walk's.
void settle_parallel(const VolumeQuery& query, bool orthographic, int at, PatchState& patch) {
  PatchRay& ray = patch.rays[at];
  for (int a = 0; a < 3; ++a) {
    if (orthographic && patch.look.parallel[a])
      ray.other[a] = parallel_cell(query, a, ray.own[a], patch.look.shared[a]);
    if (orthographic || is_quick(ray.other[a] * patch.unit)) continue;
    leave_to_walk(patch, at);
    set_depth(patch, at, -1);
  }
}

void fill_tile(const VolumeQuery& query, int x0, int y0, PatchState& patch) {
  const RayFrame& frame = patch.frame;
  constexpr double kLanes[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  PatchLook& look = patch.look;
  for (int y = y0; y < y0 + kTile; ++y) {
    Mask<R> quick = Mask<R>(true);
    for (int x = x0; x < x0 + kTile; x += kWidth<R>) {
      const R u = (R(patch.x + x) + load<R>(kLanes)) + R(patch.offset_u), v = R(patch.y + y + patch.offset_v);
      const PrimaryRay<R> ray = to_grid(query, primary_ray(frame, u, v));
      const Vec3<R>& own = frame.orthographic ? ray.o : ray.d;
      // what lies outside the picture hides nothing
      const R inside = select(R(x) + load<R>(kLanes) < R(patch.columns), R(__builtin_inf()), R(-1)),
              depth = y < patch.rows ? inside : R(-1), one = R(1);
      const RayColumns<R> rays = {
          {own.x, own.y, own.z}, {one / own.x, one / own.y, one / own.z}, depth, R(kNoHit)};
      const int at = y * kPatchPitch + x;
      for (int a = 0; a < 3; ++a) {
        const R inverse = rays.other[a] * R(patch.unit);
        store_as(look.quick[a] + at,
                 frame.orthographic ? (rays.own[a] - R(look.corner[a])) * R(look.shared_quick[a]) : inverse);
        quick = quick & is_quick(inverse);
      }
      store_rays(rays, patch.rays + at);
      store_as(patch.limit + at, depth);
    }
    const int row = y * kPatchPitch + x0;
    const bool settled = !any(!quick) && !frame.orthographic;
    for (int x = 0; x < kTile && !settled; ++x)
      if (x0 + x < patch.columns && y < patch.rows)
        settle_parallel(query, frame.orthographic, row + x, patch);
  }
  for (int y = y0 / kPartSize; y < (y0 + kTile) / kPartSize; ++y)
    for (int x = x0 / kPartSize; x < (x0 + kTile) / kPartSize; ++x)
      patch.stale |= std::uint64_t(1) << (y * kPatchParts + x);
}

template <class T>
void trace_brick(const DrawContext& context, const std::int32_t (&first)[3], const BrickMask& mask) {
  if (context.map.orthographic) draw_brick<T, true>(context, first, mask);
  else draw_brick<T, false>(context, first, mask);
}
void trace_brick(const VolumeQuery& query, const ScreenMap& map, int iso, const std::int32_t (&first)[3],
                 const BrickMask& mask, const PixelBox& clip, PatchState& patch, TraceCounts& counts) {
  const DrawContext context = {query, map, patch_map(map, patch), patch, counts, iso, clip};
  if (query.double_precision) trace_brick<double>(context, first, mask);
  else trace_brick<float>(context, first, mask);
}

template <class T> void solve_rest(const VolumeQuery& query, PatchState& patch, TraceCounts& counts) {
  while (patch.queue.size > 0)
    if (patch.frame.orthographic) solve_pairs<T, true>(query, patch, counts);
    else solve_pairs<T, false>(query, patch, counts);
}
void finish_patch(const VolumeQuery& query, PatchState& patch, TraceCounts& counts) {
  if (query.double_precision) solve_rest<double>(query, patch, counts);
  else solve_rest<float>(query, patch, counts);
}

bool hidden(PatchState& patch, const PixelBox& pixels, double t) {
  return isocast::hidden(patch, pixels, float(t * patch.unit));
}

}  // namespace

const PrimaryKernels primary_kernel_table = {start_patch, fill_tile, hidden, trace_brick, finish_patch};

}  // namespace isocast::inline ISO_ISA
