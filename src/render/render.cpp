#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>
#include <isocast/render/render.h>
#include <isocast/render/shade.h>
#include <oneapi/tbb/combinable.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace isocast {
namespace {

// Streams of one tile: large, so each thread keeps its own.
struct TileBuffers {
  RayStream rays, shadow_rays;
  HitStream hits;
  DressedHits dressed;
  bool shadowed[kStreamSize];
  int shadow_of[kStreamSize];
};

// Everything a tile needs to know.
struct Frame {
  const Scene& scene;
  const View& view;
  const RenderSettings& settings;
  const Features& features;
  std::vector<int> first_id;  // per object: ids of the objects before it
  bool proves;                // every object does
};

bool is_hit(const HitStream& hits, int i) { return hits.t[i] < std::numeric_limits<double>::infinity(); }
bool is_ray(const RayStream& rays, int i) { return rays.t_min[i] <= rays.t_max[i]; }
Double3 direction(const RayStream& rays, int i) { return {rays.dx[i], rays.dy[i], rays.dz[i]}; }

// Offset of sample `index` in its pixel: the centre, then the plastic-number sequence around it (Roberts
// 2018).
void sample_offset(int index, double& u, double& v) {
  const auto fraction = [](double x) { return x - std::floor(x); };
  u = fraction(0.5 + index * 0.7548776662466927);
  v = fraction(0.5 + index * 0.5698402909980532);
}

// Spawns the shadow stream: from the near end of each hit's bracket towards the light, where the surface
// faces it.
void fill_shadow_rays(const Double3& to_light, TileBuffers& b) {
  int n = 0;
  for (int i = 0; i < b.rays.size; ++i) {
    if (!is_hit(b.hits, i)) continue;
    const Double3 normal = {b.dressed.normal[0][i], b.dressed.normal[1][i], b.dressed.normal[2][i]};
    if (dot(normal, to_light) <= 0) continue;
    b.shadow_rays.ox[n] = b.rays.ox[i] + b.hits.t_lo[i] * b.rays.dx[i];
    b.shadow_rays.oy[n] = b.rays.oy[i] + b.hits.t_lo[i] * b.rays.dy[i];
    b.shadow_rays.oz[n] = b.rays.oz[i] + b.hits.t_lo[i] * b.rays.dz[i];
    b.shadow_rays.dx[n] = to_light[0], b.shadow_rays.dy[n] = to_light[1], b.shadow_rays.dz[n] = to_light[2];
    b.shadow_rays.t_min[n] = 0;
    b.shadow_rays.t_max[n] = std::numeric_limits<double>::infinity();
    b.shadow_rays.id[n] = b.rays.id[i];
    b.shadow_rays.start_object[n] = b.hits.object[i];
    b.shadow_rays.start_sides[n] = b.hits.sides[i];
    b.shadow_of[n++] = i;
  }
  b.shadow_rays.size = n;
  b.shadow_rays.kind = RayKind::shadow;
}

// Which hits lie in shadow.
void trace_shadows(const Frame& frame, const Double3& to_light, TileBuffers& b, RenderCounts& counts) {
  for (bool& s : b.shadowed) s = false;
  fill_shadow_rays(to_light, b);
  if (b.shadow_rays.size == 0) return;
  bool blocked[kStreamSize] = {};
  for (const SceneObject& object : frame.scene.objects)
    object.surface->any_hit(b.shadow_rays, blocked, counts.trace);
  for (int n = 0; n < b.shadow_rays.size; ++n) b.shadowed[b.shadow_of[n]] = blocked[n];
  counts.shadow += b.shadow_rays.size;
}

// Adds a sample's share of colour to every pixel of the tile.
void add_colors(const Frame& frame, TileBuffers& b, Film& film) {
  const float share = 1.0f / static_cast<float>(frame.settings.spp);
  const std::optional<Double3> light =
      frame.scene.light ? std::optional(normalized(*frame.scene.light)) : std::nullopt;
  for (int i = 0; i < b.rays.size; ++i) {
    if (!is_ray(b.rays, i)) continue;
    Color color = frame.scene.background;
    const bool hit = is_hit(b.hits, i);
    if (hit) {
      const Double3 to_eye = -1.0 * normalized(direction(b.rays, i));
      const Double3 normal = {b.dressed.normal[0][i], b.dressed.normal[1][i], b.dressed.normal[2][i]};
      const Color& surface = frame.scene.objects[b.hits.object[i]].colors[b.hits.iso[i]];
      color =
          shade(surface, normal, light.value_or(to_eye), to_eye, !(frame.features.shadows && b.shadowed[i]));
    }
    float* pixel = film.color(b.rays.id[i]);
    for (int c = 0; c < 3; ++c) pixel[c] += share * color[c];
    pixel[3] += hit ? share : 0;
  }
}

// 1 proved hit, 0 proved miss, 0.5 undecided, -1 no proof offered (interface.md).
float layer_value(Certificate certificate) {
  switch (certificate) {
    case Certificate::proved_hit: return 1;
    case Certificate::proved_miss: return 0;
    case Certificate::undecided: return 0.5f;
    default: return -1;
  }
}

// The layers of the first sample, and its counts.
void write_layers(const Frame& frame, const TileBuffers& b, Film& film, RenderCounts& counts) {
  for (int i = 0; i < b.rays.size; ++i) {
    if (!is_ray(b.rays, i)) continue;
    const std::uint32_t id = b.rays.id[i];
    counts.undecided += b.hits.certificate[i] == Certificate::undecided;
    if (film.has(Layer::certificate)) *film.at(Layer::certificate, id) = layer_value(b.hits.certificate[i]);
    if (film.has(Layer::cost)) *film.at(Layer::cost, id) = static_cast<float>(b.hits.cost[i]);
    if (!is_hit(b.hits, i)) {
      ++counts.misses;
      continue;
    }
    ++counts.hits;
    const Double3 d = direction(b.rays, i);
    if (film.has(Layer::depth)) *film.at(Layer::depth, id) = static_cast<float>(b.hits.t[i] * length(d));
    if (film.has(Layer::z))
      *film.at(Layer::z, id) = static_cast<float>(b.hits.t[i] * dot(d, frame.view.forward()));
    if (film.has(Layer::id))
      *film.at(Layer::id, id) = static_cast<float>(1 + frame.first_id[b.hits.object[i]] + b.hits.iso[i]);
    if (film.has(Layer::value)) *film.at(Layer::value, id) = static_cast<float>(b.dressed.value[i]);
    for (int c = 0; c < 3; ++c) {
      if (film.has(Layer::normal)) film.at(Layer::normal, id)[c] = static_cast<float>(b.dressed.normal[c][i]);
      if (film.has(Layer::position))
        film.at(Layer::position, id)[c] = static_cast<float>(b.dressed.position[c][i]);
    }
  }
}

// All samples of one tile.
void render_tile(const Frame& frame, int tx, int ty, TileBuffers& b, Film& film, RenderCounts& counts) {
  const TileFrustum tile = frame.view.frustum(tx, ty);
  std::vector<const Surface*> candidates;
  for (const SceneObject& object : frame.scene.objects)
    if (object.surface->narrow(tile)) candidates.push_back(object.surface.get());
  ++counts.tiles;
  counts.tiles_culled += candidates.empty();

  for (int sample = 0; sample < frame.settings.spp; ++sample) {
    double u = 0, v = 0;
    sample_offset(sample, u, v);
    frame.view.fill(tx, ty, u, v, b.rays);
    clear(b.hits);
    if (frame.proves) std::ranges::fill(b.hits.certificate, Certificate::proved_miss);
    for (int i = 0; i < b.rays.size; ++i) counts.primary += is_ray(b.rays, i);
    for (const Surface* surface : candidates) surface->first_hit(b.rays, b.hits, counts.trace);
    const DressWishes& wishes = sample == 0 ? frame.features.first_sample : frame.features.other_samples;
    if (wishes.normal || wishes.position || wishes.value)
      for (const Surface* surface : candidates) surface->dress(b.rays, b.hits, wishes, b.dressed);
    if (sample == 0) write_layers(frame, b, film, counts);
    if (!frame.features.shade) continue;
    if (frame.features.shadows) trace_shadows(frame, normalized(*frame.scene.light), b, counts);
    add_colors(frame, b, film);
  }
}

}  // namespace

RenderCounts& RenderCounts::operator+=(const RenderCounts& other) {
  primary += other.primary;
  shadow += other.shadow;
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
  const Features features = find_features(scene, film, settings);
  const bool proves =
      std::ranges::all_of(scene.objects, [](const SceneObject& o) { return o.surface->proves(); });
  Frame frame{scene, view, settings, features, {}, proves};
  for (int ids = 0; const SceneObject& object : scene.objects) {
    frame.first_id.push_back(ids);
    ids += static_cast<int>(object.colors.size());
  }

  struct Worker {
    std::unique_ptr<TileBuffers> buffers = std::make_unique<TileBuffers>();
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
