#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>
#include <isocast/render/film_layers.h>
#include <isocast/render/transparency.h>
#include <oneapi/tbb/combinable.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>

namespace isocast {
namespace {

// Offset of sample `index` in its pixel: the centre, then the plastic-number sequence around it (Roberts
// 2018).
void sample_offset(int index, double& u, double& v) {
  const auto fraction = [](double x) { return x - std::floor(x); };
  u = fraction(0.5 + index * 0.7548776662466927);
  v = fraction(0.5 + index * 0.5698402909980532);
}

// All samples of one tile.
void render_tile(const Frame& frame, int tx, int ty, TileBuffers& b, Film& film, RenderCounts& counts) {
  const TileFrustum tile = frame.view.frustum(tx, ty);
  std::vector<std::uint16_t> candidates;
  for (const std::uint16_t object : frame.objects)
    if (frame.scene.objects[object].surface->narrow(tile)) candidates.push_back(object);
  ++counts.tiles;
  counts.tiles_culled += candidates.empty();

  for (int i = 0; i < kStreamSize; ++i) {
    b.primary.slot[i] = i;
    b.primary.weight[i] = 1;
  }
  for (int sample = 0; sample < frame.settings.spp; ++sample) {
    double u = 0, v = 0;
    sample_offset(sample, u, v);
    RayStream& rays = b.primary.rays;
    frame.view.fill(tx, ty, u, v, rays);
    for (int i = 0; i < rays.size; ++i) counts.primary += is_ray(rays, i);
    trace_first_hits(frame, candidates, b, counts.trace);
    dress_hits(frame, candidates, sample == 0 ? frame.features.first_sample : frame.features.other_samples,
               b.primary);
    if (sample == 0) write_layers(frame, b.primary, film, counts);
    if (frame.features.shade) add_colors(frame, candidates, b, film, counts);
  }
}

Frame make_frame(const Scene& scene, const View& view, const RenderSettings& settings, const Film& film) {
  const bool proves =
      std::ranges::all_of(scene.objects, [](const SceneObject& o) { return o.surface->proves(); });
  Frame frame{scene, view, settings, find_features(scene, film, settings), {}, {}, {}, proves};
  for (const Double3& light : scene.lights) frame.lights.push_back(normalized(light));
  for (int ids = 0; const SceneObject& object : scene.objects) {
    frame.objects.push_back(static_cast<std::uint16_t>(frame.objects.size()));
    frame.first_id.push_back(ids);
    ids += static_cast<int>(object.materials.size());
  }
  return frame;
}

}  // namespace

RenderCounts& RenderCounts::operator+=(const RenderCounts& other) {
  primary += other.primary;
  shadow += other.shadow;
  reflection += other.reflection;
  transparency += other.transparency;
  hits += other.hits;
  misses += other.misses;
  undecided += other.undecided;
  tiles += other.tiles;
  tiles_culled += other.tiles_culled;
  trace += other.trace;
  return *this;
}

std::int64_t tile_count(const View& view) {
  const auto tiles = [](int n) { return std::int64_t(n + kTileSize - 1) / kTileSize; };
  return tiles(view.width()) * tiles(view.height());
}

RenderCounts render(const Scene& scene, const View& view, const RenderSettings& settings, Film& film,
                    std::stop_token stop, Progress* progress) {
  assert(settings.transparency_depth >= 1);
  const Frame frame = make_frame(scene, view, settings, film);
  struct Worker {
    std::unique_ptr<TileBuffers> buffers = std::make_unique_for_overwrite<TileBuffers>();
    RenderCounts counts;
  };
  oneapi::tbb::combinable<Worker> workers;
  const std::int64_t columns = (view.width() + kTileSize - 1) / kTileSize;
  oneapi::tbb::parallel_for(std::int64_t(0), tile_count(view), [&](std::int64_t tile) {
    if (stop.stop_requested()) return;
    Worker& worker = workers.local();
    render_tile(frame, static_cast<int>(tile % columns), static_cast<int>(tile / columns), *worker.buffers,
                film, worker.counts);
    if (progress) progress->add();
  });
  if (stop.stop_requested()) throw Interrupted();
  check_mapped_files();
  RenderCounts counts;
  workers.combine_each([&](const Worker& worker) { counts += worker.counts; });
  return counts;
}

}  // namespace isocast
