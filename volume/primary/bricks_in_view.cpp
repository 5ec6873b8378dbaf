#include <isocast/volume/bricks/brick_mask.h>
#include <isocast/volume/dense_grid.h>
#include <isocast/volume/primary/bricks_in_view.h>

#include <algorithm>
#include <cmath>

namespace isocast {
namespace {

constexpr double kMargin = 0x1p-4;  // pixels; more than that of the kernels
// A brick that a patch must look at takes as long as the walk of so many rays.
constexpr std::int64_t kPixelsPerBrick = 5;
constexpr double kFarthest = 0x1p40;  // cells; from there on planes may fall together

Double3 double3(const double (&v)[3]) { return {v[0], v[1], v[2]}; }

// The picture's coordinates as functions of the grid's.
ScreenMap screen_map(const RayFrame& frame, const Transform& world_from_grid,
                     const Transform& grid_from_world) {
  ScreenMap map = {};
  map.orthographic = frame.orthographic;
  const Double3 corner = double3(frame.corner), right = double3(frame.right), down = double3(frame.down),
                fixed = double3(frame.fixed);
  // columns: what u, v and the third coordinate (depth, or t) stand for
  Transform world_from_pixel;
  for (int a = 0; a < 3; ++a) {
    world_from_pixel.m[a][0] = right[a];
    world_from_pixel.m[a][1] = down[a];
    world_from_pixel.m[a][2] = frame.orthographic ? fixed[a] : corner[a];
    world_from_pixel.m[a][3] = frame.orthographic ? corner[a] : fixed[a];
  }
  const Transform to_pixel = world_from_pixel.inverse() * world_from_grid;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) {
      map.to_pixel[r][c] = frame.orthographic && r == 2 ? double(c == 3) : to_pixel.m[r][c];
      map.to_eye[r][c] = frame.orthographic ? (r == 0 ? to_pixel.m[2][c] : 0)
                                            : world_from_grid.m[r][c] - (c == 3 ? fixed[r] : 0);
    }
  const Double3 eye =
      frame.orthographic ? grid_from_world.vector(-1.0 * fixed) : grid_from_world.point(fixed);
  for (int a = 0; a < 3; ++a) map.eye[a] = eye[a];
  for (const double y : {-1.0, 1.0})
    for (const double z : {-1.0, 1.0})
      map.cell_radius = std::max(map.cell_radius, 0.5 * length(world_from_grid.vector({1, y, z})));
  map.unit = inverse_power_of_two(map.cell_radius);
  return map;
}

// Far from overflow, and not so far away that neighbouring planes are met at the same t.
bool is_sound(const ScreenMap& map, const VolumeQuery& query) {
  const auto sized = [](double x) { return std::abs(x) < 1e100; };
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c)
      if (!sized(map.to_pixel[r][c]) || !sized(map.to_eye[r][c]) || !sized(query.grid_from_world[r][c]))
        return false;
  for (const double x : map.eye)
    if (!(std::abs(x) < kFarthest)) return false;
  return map.cell_radius > 1e-100 && sized(map.cell_radius);
}

double at(const double (&row)[4], const Double3& p) {
  return row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
}

// The numbers lo...hi, those nearest to `from` first.
std::vector<std::int32_t> outward(std::int32_t lo, std::int32_t hi, double from) {
  std::vector<std::int32_t> order;
  std::int32_t below = static_cast<std::int32_t>(std::min(std::max(from, double(lo) - 1), double(hi))),
               above = below + 1;
  while (below >= lo || above <= hi) {
    if (below >= lo) order.push_back(below--);
    if (above <= hi) order.push_back(above++);
  }
  return order;
}

class Finder {
 public:
  Finder(const View& view, BricksInView& found) : view_(view), found_(found) {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) linear_[r][c] = found.map.to_pixel[r][c];
  }

  void add(std::size_t index, const std::int32_t (&first)[3]) {
    SeenBrick brick = {index, {}, {}, 0};
    Double3 center;
    for (int a = 0; a < 3; ++a) {
      brick.first[a] = first[a];
      center[a] = brick.first[a] + 0.5 * kBrickSize;
    }
    const ScreenMap& map = found_.map;
    const Footprint<double> f = footprint(linear_, at(map.to_pixel[0], center), at(map.to_pixel[1], center),
                                          at(map.to_pixel[2], center), double(kBrickSize));
    const double reach = kBrickSize * map.cell_radius;
    const Double3 eye = {at(map.to_eye[0], center), at(map.to_eye[1], center), at(map.to_eye[2], center)};
    const double distance = map.orthographic ? eye[0] : length(eye);
    const double slack = reach + 1e-9 * (std::abs(distance) + reach);
    if (map.orthographic && distance + slack < 0) return;
    brick.nearest = distance - slack;
    brick.pixels = {0, view_.width() - 1, 0, view_.height() - 1};
    if (f.whole) {
      if (!may_be_seen(center)) return;
    } else if (!clip(f.u, f.du, brick.pixels.x_lo, brick.pixels.x_hi) ||
               !clip(f.v, f.dv, brick.pixels.y_lo, brick.pixels.y_hi))
      return;
    found_.bricks.push_back(brick);
  }

 private:
  // Cuts [lo, hi] to the pixels whose samples may lie within u +- du; false when none are left.
  static bool clip(double u, double du, std::int32_t& lo, std::int32_t& hi) {
    const double from = std::floor(u - du - 1 - kMargin), to = std::floor(u + du + kMargin);
    if (from > hi || to < lo) return false;
    if (from > lo) lo = static_cast<std::int32_t>(from);
    if (to < hi) hi = static_cast<std::int32_t>(to);
    return true;
  }

  // False where the brick lies behind the eye, or behind one of the planes of the picture's pyramid.
  bool may_be_seen(const Double3& center) const {
    const auto behind = [&](double x, double y, double w) {
      double value = 0, reach = 0;
      for (int c = 0; c < 4; ++c) {
        const double k =
            x * found_.map.to_pixel[0][c] + y * found_.map.to_pixel[1][c] + w * found_.map.to_pixel[2][c];
        value += k * (c < 3 ? center[c] : 1);
        if (c < 3) reach += 0.5 * kBrickSize * std::abs(k);
      }
      return value + reach < -1e-6 * reach;
    };
    return !behind(0, 0, 1) && !behind(1, 0, kMargin) && !behind(-1, 0, view_.width() + kMargin) &&
           !behind(0, 1, kMargin) && !behind(0, -1, view_.height() + kMargin);
  }

  const View& view_;
  BricksInView& found_;
  double linear_[3][3];
};

// All bricks of a dense grid that hold an iso-value, nearest first along each axis.
void add_dense(const VolumeQuery& query, const ScreenMap& map, Finder& finder) {
  std::vector<std::int32_t> order[3];
  for (int a = 0; a < 3; ++a) {
    const std::int32_t lo = query.active.lo[a], hi = query.active.hi[a];
    const double from =
        map.orthographic ? (map.eye[a] > 0 ? double(hi) : double(lo)) : std::floor(map.eye[a] / kBrickSize);
    order[a] = outward(lo, hi, from);
  }
  const std::int32_t(&dims)[3] = query.grid.levels[0].dims;
  visit_sample_type(query.grid.type, [&]<class S>(SampleTag<S>) {
    const DenseGrid<S> grid(query);
    typename DenseGrid<S>::Place place;
    for (const std::int32_t z : order[2])
      for (const std::int32_t y : order[1])
        for (const std::int32_t x : order[0])
          if (grid.block_active(0, {x, y, z}, place))
            finder.add((std::size_t(z) * dims[1] + y) * dims[0] + x,
                       {x * kBrickSize, y * kBrickSize, z * kBrickSize});
  });
}

void add_sparse(const Bricks& bricks, BricksInView& found, Finder& finder) {
  for (std::size_t i = 0; i < bricks.count; ++i)
    finder.add(i, {bricks.first[i][0], bricks.first[i][1], bricks.first[i][2]});
  std::ranges::sort(found.bricks, {}, &SeenBrick::nearest);
}

// Tells every patch its bricks; false where the walk is faster.
bool fill_patches(const View& view, BricksInView& found) {
  std::int64_t entries = 0, pixels = 0;
  for (std::size_t i = 0; i < found.bricks.size(); ++i) {
    const PixelBox& p = found.bricks[i].pixels;
    for (int y = p.y_lo / kPatchSize; y <= p.y_hi / kPatchSize; ++y)
      for (int x = p.x_lo / kPatchSize; x <= p.x_hi / kPatchSize; ++x) {
        std::vector<std::uint32_t>& patch = found.patches[std::size_t(y) * found.columns + x];
        ++entries;
        if (patch.empty())
          pixels += std::int64_t(std::min(kPatchSize, view.width() - x * kPatchSize)) *
                    std::min(kPatchSize, view.height() - y * kPatchSize);
        patch.push_back(static_cast<std::uint32_t>(i));
      }
  }
  return entries * kPixelsPerBrick <= pixels;
}

}  // namespace

std::optional<BricksInView> find_bricks(const VolumeQuery& query, const Bricks& bricks,
                                        const Transform& world_from_grid, const View& view) {
  Transform grid_from_world;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) grid_from_world.m[r][c] = query.grid_from_world[r][c];
  BricksInView found = {screen_map(view.ray_frame(), world_from_grid, grid_from_world), {}, 0, 0, {}};
  if (!is_sound(found.map, query)) return std::nullopt;
  found.columns = (view.width() + kPatchSize - 1) / kPatchSize;
  found.rows = (view.height() + kPatchSize - 1) / kPatchSize;
  found.patches.resize(std::size_t(found.columns) * found.rows);

  Finder finder(view, found);
  if (query.sparse) add_sparse(bricks, found, finder);
  else add_dense(query, found.map, finder);
  if (!fill_patches(view, found)) return std::nullopt;
  return found;
}

}  // namespace isocast
