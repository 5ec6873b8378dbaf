#include <isocast/render/crossings.h>

namespace isocast {
void Crossings::first(const Scene& scene, std::span<const std::uint16_t> objects, const RayStream& rays,
                      HitStream& hits, TraceCounts& counts) {
  if (objects.size() == 1) {
    scene.objects[objects[0]].surface->first_hit(rays, hits, counts);
    return;
  }
  if (objects.empty()) return;
  waiting_.assign(objects.size(), hits);
  for (std::size_t k = 0; k < objects.size(); ++k)
    scene.objects[objects[k]].surface->first_hit(rays, waiting_[k], counts);
  take_nearest(rays.size, hits);

  // The work of all objects, and the doubts of any: something nearer may have been overlooked.
  for (const HitStream& waiting : waiting_)
    for (int i = 0; i < rays.size; ++i) {
      hits.cost[i] += waiting.cost[i];
      if (waiting.certificate[i] == Certificate::undecided) hits.certificate[i] = Certificate::undecided;
    }
}

void Crossings::next(const Scene& scene, std::span<const std::uint16_t> objects, const RayStream& rays,
                     HitStream& hits, RenderCounts& counts) {
  for (int i = 0; i < rays.size; ++i) counts.transparency += is_hit(hits, i);
  for (const std::uint16_t object : objects)
    scene.objects[object].surface->next_hit(rays, hits, counts.trace);
  if (objects.size() == 1) return;

  // What was found waits too, but no ray is followed that was forgotten.
  for (std::size_t k = 0; k < objects.size(); ++k)
    for (int i = 0; i < rays.size; ++i) {
      if (hits.object[i] == objects[k]) copy_slot(hits, waiting_[k], i);
      if (hits.object[i] == kNoObject) forget(waiting_[k], i);
    }
  take_nearest(rays.size, hits);
}

void Crossings::take_nearest(int size, HitStream& hits) {
  for (int i = 0; i < size; ++i) {
    HitStream* nearest = nullptr;
    for (HitStream& waiting : waiting_)
      if (is_hit(waiting, i) && (!nearest || waiting.t[i] < nearest->t[i])) nearest = &waiting;
    if (!nearest) continue;
    copy_slot(*nearest, hits, i);
    nearest->t[i] = std::numeric_limits<double>::infinity();
  }
}

}  // namespace isocast
