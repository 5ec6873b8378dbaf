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

void start_patch(const VolumeQuery& query, PatchState& patch) {
  const RayFrame& frame = patch.frame;
  const PrimaryRay<double> ray =
      to_grid(query, primary_ray(frame, patch.x + patch.offset_u, patch.y + patch.offset_v));
  const Vec3<double>& shared = frame.orthographic ? ray.d : ray.o;
  const double numbers[3] = {shared.x, shared.y, shared.z};
  for (int a = 0; a < 3; ++a) {
    patch.rays.shared[a] = numbers[a];
    patch.rays.shared_inverse[a] = 1 / numbers[a];
    patch.rays.parallel[a] = frame.orthographic && is_parallel(1 / numbers[a]);
  }
  patch.stale = ~std::uint64_t(0);
  (query.double_precision ? patch.pairs_double.size : patch.pairs_float.size) = 0;
  (query.double_precision ? patch.pairs_double.any_start : patch.pairs_float.any_start) = false;
}

// A ray that is parallel to an axis in perspective, which few are, is the walk's.
void settle_parallel(const VolumeQuery& query, bool orthographic, int at, PatchState& patch) {
  PatchRays& rays = patch.rays;
  for (int a = 0; a < 3; ++a) {
    if (orthographic && rays.parallel[a])
      rays.cell[a][at] = parallel_cell(query, a, rays.own[a][at], rays.shared[a]);
    if (orthographic || !is_parallel(rays.inverse[a][at])) continue;
    patch.walk[at] = 1;
    patch.depth[at] = -1;
  }
}

void fill_tile(const VolumeQuery& query, int x0, int y0, PatchState& patch) {
  const RayFrame& frame = patch.frame;
  constexpr double kLanes[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  PatchRays& rays = patch.rays;
  for (int y = y0; y < y0 + kTile; ++y) {
    Mask<R> moves = Mask<R>(true);
    for (int x = x0; x < x0 + kTile; x += kWidth<R>) {
      const R u = (R(patch.x + x) + load<R>(kLanes)) + R(patch.offset_u), v = R(patch.y + y + patch.offset_v);
      const PrimaryRay<R> ray = to_grid(query, primary_ray(frame, u, v));
      const Vec3<R>& own = frame.orthographic ? ray.o : ray.d;
      const R numbers[3] = {own.x, own.y, own.z};
      const int at = y * kPatchPitch + x;
      for (int a = 0; a < 3; ++a) {
        const R inverse = R(1) / numbers[a];
        store(rays.own[a] + at, numbers[a]);
        store(rays.inverse[a] + at, inverse);
        moves = moves & (abs(inverse) < R(__builtin_inf()));
      }
      // what lies outside the picture hides nothing
      const R inside = select(R(x) + load<R>(kLanes) < R(patch.columns), R(__builtin_inf()), R(-1));
      store(patch.depth + at, y < patch.rows ? inside : R(-1));
    }
    const int row = y * kPatchPitch + x0;
    for (int x = 0; x < kTile; ++x) {
      patch.axis[row + x] = 255;
      patch.walk[row + x] = 0;
    }
    const bool settled = !any(!moves) && !frame.orthographic;
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

void finish_patch(const VolumeQuery& query, PatchState& patch, TraceCounts& counts) {
  while (query.double_precision && patch.pairs_double.size > 0) solve_pairs<double>(query, patch, counts);
  while (!query.double_precision && patch.pairs_float.size > 0) solve_pairs<float>(query, patch, counts);
}

}  // namespace

const PrimaryKernels primary_kernel_table = {start_patch, fill_tile, hidden, trace_brick, finish_patch};

}  // namespace isocast::inline ISO_ISA
