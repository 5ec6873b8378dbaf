#include <isocast/render/film_layers.h>
#include <isocast/render/shade.h>

#include <algorithm>

namespace isocast {
namespace {

// 1 proved hit, 0 proved miss, 0.5 undecided, -1 no proof offered (interface.md).
float layer_value(Certificate certificate) {
  switch (certificate) {
    case Certificate::proved_hit: return 1;
    case Certificate::proved_miss: return 0;
    case Certificate::undecided: return 0.5f;
    default: return -1;
  }
}

}  // namespace

void write_layers(const Frame& frame, const Wave& wave, Film& film, RenderCounts& counts) {
  const RayStream& rays = wave.rays;
  const HitStream& hits = *wave.hits;
  const DressedHits& dressed = wave.dressed;
  int found = 0, all = 0, undecided = 0;
  for (int i = 0; i < rays.size; ++i) {
    const bool there = is_ray(rays, i);
    found += there && is_hit(hits, i);
    undecided += there && frame.proves && hits.certificate[i] == Certificate::undecided;
    all += there;
  }
  counts.hits += found;
  counts.misses += all - found;
  counts.undecided += undecided;
  if (!film.has_layers()) return;
  LitSurfaces surfaces;
  if (film.has(Layer::albedo)) find_surfaces(frame, wave, surfaces);
  for (int i = 0; i < rays.size; ++i) {
    if (!is_ray(rays, i)) continue;
    const std::uint32_t id = rays.id[i];
    if (film.has(Layer::certificate)) *film.at(Layer::certificate, id) = layer_value(hits.certificate[i]);
    if (film.has(Layer::cost)) *film.at(Layer::cost, id) = static_cast<float>(hits.cost[i]);
    if (!is_hit(hits, i)) continue;
    const Double3 d = direction_of(rays, i);
    if (film.has(Layer::depth)) *film.at(Layer::depth, id) = static_cast<float>(hits.t[i] * length(d));
    if (film.has(Layer::z))
      *film.at(Layer::z, id) = static_cast<float>(hits.t[i] * dot(d, frame.view.forward()));
    if (film.has(Layer::id))
      *film.at(Layer::id, id) = static_cast<float>(1 + frame.first_id[hits.object[i]] + hits.iso[i]);
    if (film.has(Layer::value)) *film.at(Layer::value, id) = static_cast<float>(dressed.value[i]);
    if (film.has(Layer::object)) *film.at(Layer::object, id) = static_cast<float>(1 + hits.object[i]);
    for (int c = 0; c < 3; ++c) {
      if (film.has(Layer::albedo)) film.at(Layer::albedo, id)[c] = surfaces.color[c][i];
      if (film.has(Layer::normal)) film.at(Layer::normal, id)[c] = static_cast<float>(dressed.normal[c][i]);
      if (film.has(Layer::position))
        film.at(Layer::position, id)[c] = static_cast<float>(dressed.position[c][i]);
    }
  }
}

}  // namespace isocast
