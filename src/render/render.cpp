#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>
#include <isocast/render/film_layers.h>
#include <isocast/render/silhouettes.h>
#include <isocast/render/transparency.h>
#include <oneapi/tbb/combinable.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <memory>

namespace isocast {
namespace {

int tiles_along(int pixels) { return (pixels + kTileSize - 1) / kTileSize; }

// Offset of sample `index` in its pixel: the centre, then the plastic-number sequence around it (Roberts
// 2018).
void sample_offset(int index, double& u, double& v) {
  const auto fraction = [](double x) { return x - std::floor(x); };
  u = fraction(0.5 + index * 0.7548776662466927);
  v = fraction(0.5 + index * 0.5698402909980532);
}

// What one thread works with.
struct Worker {
  std::unique_ptr<TileBuffers> buffers = std::make_unique_for_overwrite<TileBuffers>();
  std::unique_ptr<BlockHits> block;
  RenderCounts counts;
};

// The objects that a tile may meet: of those with a pass, whatever it has `found`.
void find_candidates(const Frame& frame, int tx, int ty, const HitStream* found,
                     std::vector<std::uint16_t>& candidates) {
  candidates.clear();
  const bool any_pass = !frame.passes.empty();
  if (any_pass && !found && frame.objects.size() == 1) return;
  const TileFrustum tile = frame.view.frustum(tx, ty);
  for (const std::uint16_t object : frame.objects)
    if (any_pass && frame.passes[object] ? found != nullptr
                                         : frame.scene.objects[object].surface->narrow(tile))
      candidates.push_back(object);
}

// The same for a tile that meets nothing, before a background of one colour.
void add_nothing(const Frame& frame, int tx, int ty, int sample, Film& film, RenderCounts& counts) {
  const int x0 = tx * kTileSize, y0 = ty * kTileSize, x1 = std::min(x0 + kTileSize, frame.view.width()),
            y1 = std::min(y0 + kTileSize, frame.view.height());
  counts.primary += (x1 - x0) * (y1 - y0);
  if (sample == 0) counts.misses += (x1 - x0) * (y1 - y0);
  const bool prove = sample == 0 && frame.proves && film.has(Layer::certificate);
  const float share = 1.0f / static_cast<float>(frame.settings.spp);
  const Color& background = frame.scene.background;
  for (int y = y0; y < y1; ++y) {
    const auto id = static_cast<std::uint32_t>(x0 + y * frame.view.width());
    if (prove) std::fill_n(film.at(Layer::certificate, id), x1 - x0, 0.0f);
    if (!frame.features.shade) continue;
    float* pixel = film.color(id);
    for (int x = x0; x < x1; ++x, pixel += 4)
      for (int c = 0; c < 3; ++c) pixel[c] += share * background[c];
  }
}

// Where samples leave what they see: the hits of pixels only where silhouettes want them.
struct Target {
  Film& film;
  std::vector<PixelHit> pixels;
};

// One sample of every pixel of a tile. found: as in trace_first_hits.
void render_sample(const Frame& frame, int tx, int ty, int sample, HitStream* found, TileBuffers& b,
                   Target& target, RenderCounts& counts) {
  Film& film = target.film;
  find_candidates(frame, tx, ty, found, b.candidates);
  if (sample == 0) {
    ++counts.tiles;
    counts.tiles_culled += b.candidates.empty();
  }
  if (b.candidates.empty() && !frame.scene.environment)
    return add_nothing(frame, tx, ty, sample, film, counts);
  double u = 0, v = 0;
  sample_offset(sample, u, v);
  RayStream& rays = b.primary.rays;
  frame.view.fill(tx, ty, u, v, rays);
  for (int i = 0; i < rays.size; ++i) counts.primary += is_ray(rays, i);
  trace_first_hits(frame, found, b, counts.trace);
  dress_hits(frame, sample == 0 ? frame.features.first_sample : frame.features.other_samples, b);
  if (sample == 0) write_layers(frame, b.primary, film, counts);
  if (sample == 0 && frame.features.silhouettes) keep_hits(frame, b.primary, target.pixels);
  if (frame.features.shade) add_colors(frame, b, film, counts);
}

// All samples of one block of tiles.
void render_block(const Frame& frame, int bx, int by, Worker& worker, Target& target, std::stop_token stop,
                  Progress* progress) {
  if (!worker.block) worker.block = std::make_unique_for_overwrite<BlockHits>();
  BlockHits& block = *worker.block;
  const int columns = std::min(kBlockTiles, tiles_along(frame.view.width()) - bx * kBlockTiles),
            rows = std::min(kBlockTiles, tiles_along(frame.view.height()) - by * kBlockTiles);
  for (int sample = 0; sample < frame.settings.spp; ++sample) {
    double u = 0, v = 0;
    sample_offset(sample, u, v);
    block.reset(frame.proves, stop);
    for (const auto& pass : frame.passes)
      if (pass && !stop.stop_requested()) pass->first_hits(bx, by, u, v, block, worker.counts.trace);
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) {
        if (stop.stop_requested()) return;
        render_sample(frame, bx * kBlockTiles + x, by * kBlockTiles + y, sample,
                      block.is_open(x, y) ? &block.tile(x, y) : nullptr, *worker.buffers, target,
                      worker.counts);
        if (progress && sample + 1 == frame.settings.spp) progress->add();
      }
  }
}

Frame make_frame(const Scene& scene, const View& view, const RenderSettings& settings, const Film& film) {
  const bool proves =
      std::ranges::all_of(scene.objects, [](const SceneObject& o) { return o.surface->proves(); });
  Frame frame{scene, view, settings, find_features(scene, film, settings), {}, {}, {}, {}, proves};
  for (const Double3& light : scene.lights) frame.lights.push_back(normalized(light));
  for (int ids = 0; const SceneObject& object : scene.objects) {
    frame.objects.push_back(static_cast<std::uint16_t>(frame.objects.size()));
    frame.first_id.push_back(ids);
    ids += static_cast<int>(object.materials.size());
  }
  // crossings of several objects wait for their turn, ray by ray
  if (frame.features.transparency && scene.objects.size() > 1) return frame;
  for (const SceneObject& object : scene.objects) {
    std::unique_ptr<PrimaryPass>& pass = frame.passes.emplace_back(object.surface->primary(view));
    if (pass && film.has(Layer::cost) && !pass->tells_cost()) pass.reset();
  }
  if (std::ranges::none_of(frame.passes, [](const auto& pass) { return pass != nullptr; }))
    frame.passes.clear();
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
  blended += other.blended;
  tiles += other.tiles;
  tiles_culled += other.tiles_culled;
  trace += other.trace;
  return *this;
}

std::int64_t tile_count(const View& view) {
  return std::int64_t(tiles_along(view.width())) * tiles_along(view.height());
}

RenderCounts render(const Scene& scene, const View& view, const RenderSettings& settings, Film& film,
                    std::stop_token stop, Progress* progress) {
  assert(settings.transparency_depth >= 1);
  const Frame frame = make_frame(scene, view, settings, film);
  Target target{film, {}};
  if (frame.features.silhouettes)
    target.pixels.resize(std::size_t(view.width()) * static_cast<std::size_t>(view.height()));
  oneapi::tbb::combinable<Worker> workers;
  const int tiles = tiles_along(view.width());
  if (frame.passes.empty())
    oneapi::tbb::parallel_for(std::int64_t(0), tile_count(view), [&](std::int64_t tile) {
      Worker& worker = workers.local();
      for (int sample = 0; sample < settings.spp; ++sample) {
        if (stop.stop_requested()) return;
        render_sample(frame, static_cast<int>(tile % tiles), static_cast<int>(tile / tiles), sample, nullptr,
                      *worker.buffers, target, worker.counts);
      }
      if (progress) progress->add();
    });
  else {
    const int blocks = (tiles + kBlockTiles - 1) / kBlockTiles,
              rows = (tiles_along(view.height()) + kBlockTiles - 1) / kBlockTiles;
    oneapi::tbb::parallel_for(0, blocks * rows, [&](int block) {
      if (stop.stop_requested()) return;
      render_block(frame, block % blocks, block / blocks, workers.local(), target, stop, progress);
    });
  }
  if (stop.stop_requested()) throw Interrupted();
  check_mapped_files();
  RenderCounts counts;
  if (frame.features.silhouettes) counts.blended = blend_silhouettes(frame, target.pixels, film);
  workers.combine_each([&](const Worker& worker) { counts += worker.counts; });
  counts.passes = std::ranges::count_if(frame.passes, [](const auto& pass) { return pass != nullptr; });
  return counts;
}

}  // namespace isocast
