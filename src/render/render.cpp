#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>
#include <isocast/render/coverage.h>
#include <isocast/render/film_layers.h>
#include <isocast/render/silhouettes.h>
#include <isocast/render/transparency.h>
#include <oneapi/tbb/combinable.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <deque>
#include <map>
#include <memory>
#include <span>

namespace isocast {
namespace {

int tiles_along(int pixels) { return (pixels + kTileSize - 1) / kTileSize; }

// A sample of every pixel, and the frame that finds it: of the view shifted by whole pixels.
struct FrameSample {
  int number;
  double u, v;
  const Frame& frame;
};

// What one thread works with.
struct Worker {
  std::unique_ptr<TileBuffers> buffers = std::make_unique_for_overwrite<TileBuffers>();
  std::unique_ptr<BlockHits> block;
  std::unique_ptr<BlockCover> cover;
  RenderCounts counts;
};

// The objects that a tile may meet: of those with a pass, whatever it has `found`.
void find_candidates(const Frame& frame, int tx, int ty, const HitStream* found,
                     std::vector<std::uint16_t>& candidates) {
  candidates.clear();
  if (frame.hierarchy) {
    if (found || frame.view.frustum(tx, ty).may_meet(frame.bounds)) candidates = frame.objects;
    return;
  }
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
  const float more[4] = {share * background[0], share * background[1], share * background[2], 0};
  for (int y = y0; y < y1; ++y) {
    const auto id = static_cast<std::uint32_t>(x0 + y * frame.view.width());
    if (prove) std::fill_n(film.at(Layer::certificate, id), x1 - x0, 0.0f);
    if (!frame.features.shade) continue;
    float* pixel = film.color(id);
    for (int x = x0; x < x1; ++x, pixel += 4)
      for (int c = 0; c < 4; ++c) pixel[c] += more[c];
  }
}

// Where samples leave what they see: the hits of pixels only where silhouettes want them.
struct Target {
  Film& film;
  std::vector<PixelHit> pixels;
};

// The colours of a tile by the shares of its pixels that are covered.
void add_cover(const Frame& frame, const TileCover& cover, TileBuffers& b, Film& film, RenderCounts& counts) {
  if (take_spares(cover, b.primary)) dress_hits(frame, frame.features.first_sample, b);
  add_colors(frame, b, film, counts);
  blend_cover(frame, cover, b.primary.rays, film, counts);
}

// One sample of every pixel of a tile. found: as in trace_first_hits. cover: null where nobody asks for
// shares.
void render_sample(const FrameSample& place, int tx, int ty, HitStream* found, const TileCover* cover,
                   TileBuffers& b, Target& target, RenderCounts& counts) {
  const Frame& frame = place.frame;
  const int sample = place.number;
  Film& film = target.film;
  find_candidates(frame, tx, ty, found, b.candidates);
  if (cover && !cover->spare) b.candidates.clear();
  if (sample == 0) {
    ++counts.tiles;
    counts.tiles_culled += b.candidates.empty();
  }
  if (b.candidates.empty() && !frame.scene.environment)
    return add_nothing(frame, tx, ty, sample, film, counts);
  RayStream& rays = b.primary.rays;
  b.primary.sample = sample;
  frame.view.fill(tx, ty, place.u, place.v, rays);
  for (int i = 0; i < rays.size; ++i) counts.primary += is_ray(rays, i);
  trace_first_hits(frame, found, b, counts.trace);
  dress_hits(frame, sample == 0 ? frame.features.first_sample : frame.features.other_samples, b);
  if (sample == 0) write_layers(frame, b.primary, film, counts);
  if (sample == 0 && frame.features.silhouettes) keep_hits(frame, b.primary, target.pixels);
  if (!frame.features.shade) return;
  if (cover) add_cover(frame, *cover, b, film, counts);
  else add_colors(frame, b, film, counts);
}

TileCover tile_cover(BlockCover& cover, int x, int y) {
  const int tile = x + kBlockTiles * y;
  return {cover.share[tile], cover.open[tile], cover.spare.is_open(x, y) ? &cover.spare.tile(x, y) : nullptr};
}

// All samples of one block of tiles.
void render_block(std::span<const FrameSample> samples, int bx, int by, Worker& worker, Target& target,
                  std::stop_token stop, Progress* progress) {
  if (!worker.block) worker.block = std::make_unique_for_overwrite<BlockHits>();
  BlockHits& block = *worker.block;
  const View& view = samples.front().frame.view;
  const int columns = std::min(kBlockTiles, tiles_along(view.width()) - bx * kBlockTiles),
            rows = std::min(kBlockTiles, tiles_along(view.height()) - by * kBlockTiles);
  for (const FrameSample& sample : samples) {
    block.reset(sample.frame.proves, stop);
    for (const auto& pass : sample.frame.passes)
      if (pass && !stop.stop_requested())
        pass->first_hits(bx, by, sample.u, sample.v, block, worker.counts.trace);
    const CoveragePass* const coverage = sample.frame.coverage.get();
    if (coverage && !worker.cover) worker.cover = std::make_unique_for_overwrite<BlockCover>();
    if (coverage && !stop.stop_requested()) coverage->cover(bx, by, *worker.cover, worker.counts.trace);
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) {
        if (stop.stop_requested()) return;
        const TileCover cover = coverage ? tile_cover(*worker.cover, x, y) : TileCover();
        render_sample(sample, bx * kBlockTiles + x, by * kBlockTiles + y,
                      block.is_open(x, y) ? &block.tile(x, y) : nullptr, coverage ? &cover : nullptr,
                      *worker.buffers, target, worker.counts);
        if (progress && &sample == &samples.back()) progress->add();
      }
  }
}

Frame make_frame(const Scene& scene, const View& view, const RenderSettings& settings, const Film& film,
                 const std::shared_ptr<const ObjectHierarchy>& hierarchy) {
  Frame frame{scene, view, settings, find_features(scene, film, settings)};
  frame.proves = std::ranges::all_of(scene.objects, [](const SceneObject& o) { return o.surface->proves(); });
  frame.hierarchy = hierarchy;
  frame.bounds = scene.bounds();
  for (const Double3& light : scene.lights) frame.lights.push_back(normalized(light));
  for (int ids = 0; const SceneObject& object : scene.objects) {
    frame.objects.push_back(static_cast<std::uint16_t>(frame.objects.size()));
    frame.first_id.push_back(ids);
    ids += static_cast<int>(object.materials.size());
  }
  if (frame.features.coverage) {
    if (scene.objects.size() == 1) frame.coverage = scene.objects.front().surface->coverage(view);
    if (!frame.coverage)
      throw InputError(
          "found a scene whose shares of pixels nobody can tell, expected one whole formula for --aa "
          "coverage");
  }
  // crossings of several objects wait for their turn, ray by ray
  if (frame.features.transparency && scene.objects.size() > 1) return frame;
  for (const SceneObject& object : scene.objects) {
    std::unique_ptr<PrimaryPass>& pass = frame.passes.emplace_back(object.surface->primary(view));
    if (pass && film.has(Layer::cost) && !pass->tells_cost()) pass.reset();
    frame.passed.push_back(pass != nullptr);
  }
  if (std::ranges::none_of(frame.passes, [](const auto& pass) { return pass != nullptr; }))
    frame.passes.clear();
  return frame;
}

// The samples of every pixel, with a frame for each way in which they lie beyond its borders.
class Samples {
 public:
  Samples(const Scene& scene, const View& view, const RenderSettings& settings, const Film& film) {
    std::shared_ptr<const ObjectHierarchy> hierarchy;
    if (scene.objects.size() > 1 && !film.has(Layer::cost))
      hierarchy = std::make_shared<const ObjectHierarchy>(scene);
    for (const PixelSample& place : pixel_samples(settings.spp, settings.filter)) {
      auto& frame = frames_[{place.columns, place.rows}];
      if (!frame) {
        const View& shifted = views_.emplace_back(view.shifted(place.columns, place.rows));
        frame = std::make_unique<Frame>(make_frame(scene, shifted, settings, film, hierarchy));
      }
      all_.push_back({static_cast<int>(all_.size()), place.u, place.v, *frame});
    }
  }
  [[nodiscard]] std::span<const FrameSample> all() const { return all_; }
  /// That of the centres.
  [[nodiscard]] const Frame& frame() const { return all_.front().frame; }
  [[nodiscard]] bool by_blocks() const {
    return std::ranges::any_of(
        frames_, [](const auto& one) { return !one.second->passes.empty() || one.second->coverage; });
  }

 private:
  std::deque<View> views_;
  std::map<std::pair<int, int>, std::unique_ptr<const Frame>> frames_;
  std::vector<FrameSample> all_;
};

}  // namespace

RenderCounts& RenderCounts::operator+=(const RenderCounts& other) {
  primary += other.primary;
  shadow += other.shadow;
  occlusion += other.occlusion;
  reflection += other.reflection;
  transparency += other.transparency;
  hits += other.hits;
  misses += other.misses;
  undecided += other.undecided;
  blended += other.blended;
  blended_open += other.blended_open;
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
  const Samples samples(scene, view, settings, film);
  const Frame& frame = samples.frame();
  Target target{film, {}};
  if (frame.features.silhouettes)
    target.pixels.resize(std::size_t(view.width()) * static_cast<std::size_t>(view.height()));
  oneapi::tbb::combinable<Worker> workers;
  const int tiles = tiles_along(view.width());
  if (!samples.by_blocks())
    oneapi::tbb::parallel_for(std::int64_t(0), tile_count(view), [&](std::int64_t tile) {
      Worker& worker = workers.local();
      for (const FrameSample& sample : samples.all()) {
        if (stop.stop_requested()) return;
        render_sample(sample, static_cast<int>(tile % tiles), static_cast<int>(tile / tiles), nullptr,
                      nullptr, *worker.buffers, target, worker.counts);
      }
      if (progress) progress->add();
    });
  else {
    const int blocks = (tiles + kBlockTiles - 1) / kBlockTiles,
              rows = (tiles_along(view.height()) + kBlockTiles - 1) / kBlockTiles;
    oneapi::tbb::parallel_for(0, blocks * rows, [&](int block) {
      if (stop.stop_requested()) return;
      render_block(samples.all(), block % blocks, block / blocks, workers.local(), target, stop, progress);
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
