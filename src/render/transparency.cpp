#include <isocast/render/transparency.h>

#include <algorithm>

namespace isocast {

void trace_first_hits(const Frame& frame, std::span<const std::uint16_t> objects, const HitStream* found,
                      TileBuffers& b, TraceCounts& counts) {
  auto& [rays, hits, dressed, slot, weight] = b.primary;
  if (found) hits = *found;
  else {
    clear(hits);
    if (frame.proves) std::ranges::fill(hits.certificate, Certificate::proved_miss);
  }
  const auto has_pass = [&](std::uint16_t object) { return !frame.passes.empty() && frame.passes[object]; };
  if (frame.features.transparency && !std::ranges::any_of(objects, has_pass)) {
    b.crossings.first(frame.scene, objects, rays, hits, counts);
    return;
  }
  for (const std::uint16_t object : objects)
    if (!has_pass(object)) frame.scene.objects[object].surface->first_hit(rays, hits, counts);
}

void dress_hits(const Frame& frame, std::span<const std::uint16_t> objects, const DressWishes& wishes,
                Wave& wave) {
  if (!wishes.normal && !wishes.position && !wishes.value) return;
  for (const std::uint16_t object : objects)
    frame.scene.objects[object].surface->dress(wave.rays, wave.hits, wishes, wave.dressed);
}

void add_colors(const Frame& frame, std::span<const std::uint16_t> objects, TileBuffers& b, Film& film,
                RenderCounts& counts) {
  auto& [rays, hits, dressed, slot, weight] = b.primary;
  Color sum[kStreamSize] = {};
  float through[kStreamSize];
  std::ranges::fill(through, 1.0f);
  for (int layer = 1;; ++layer) {
    Color colors[kStreamSize] = {};
    b.reflections.color(frame, b.primary, b.shadows, colors, counts);
    float opacity[kStreamSize] = {};
    bool more = false;
    for (int i = 0; i < rays.size; ++i) {
      if (!is_hit(hits, i)) continue;
      opacity[i] = material_of(frame.scene, hits, i).opacity;
      if (opacity[i] < 1) more = true;
      else forget(hits, i);
    }
    if (more) b.crossings.next(frame.scene, objects, rays, hits, counts);
    const bool last = layer == frame.settings.transparency_depth;
    for (int i = 0; i < rays.size; ++i) {
      if (last && opacity[i] > 0 && is_hit(hits, i)) opacity[i] = 1;
      for (int c = 0; c < 3; ++c) sum[i][c] += through[i] * opacity[i] * colors[i][c];
      through[i] *= 1 - opacity[i];
    }
    if (!more || last) break;
    dress_hits(frame, objects, {.normal = true}, b.primary);
  }

  const float share = 1.0f / static_cast<float>(frame.settings.spp);
  for (int i = 0; i < rays.size; ++i) {
    if (!is_ray(rays, i)) continue;
    float* pixel = film.color(rays.id[i]);
    if (through[i] > 0) {
      const Color behind = frame.scene.color_towards(direction_of(rays, i));
      for (int c = 0; c < 3; ++c) sum[i][c] += through[i] * behind[c];
    }
    for (int c = 0; c < 3; ++c) pixel[c] += share * sum[i][c];
    pixel[3] += share * (1 - through[i]);
  }
}

}  // namespace isocast
