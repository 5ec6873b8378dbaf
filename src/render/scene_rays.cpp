#include <isocast/render/scene_rays.h>

namespace isocast {

void find_first_hits(const Frame& frame, const RayStream& rays, HitStream& hits, TraceCounts& counts) {
  if (frame.hierarchy) return frame.hierarchy->first_hit(rays, {}, hits, counts);
  for (const SceneObject& object : frame.scene.objects) object.surface->first_hit(rays, hits, counts);
}

void find_any_hits(const Frame& frame, const RayStream& rays, bool (&hit)[kStreamSize], TraceCounts& counts) {
  if (frame.hierarchy) return frame.hierarchy->any_hit(rays, hit, counts);
  for (const SceneObject& object : frame.scene.objects) object.surface->any_hit(rays, hit, counts);
}

std::span<const std::uint16_t> objects_for(const Frame& frame, const RayStream& rays,
                                           std::vector<std::uint16_t>& list) {
  if (!frame.hierarchy) return frame.objects;
  frame.hierarchy->find_candidates(rays, list);
  return list;
}

void dress_all(const Frame& frame, const DressWishes& wishes, const RayStream& rays, const HitStream& hits,
               DressedHits& dressed) {
  if (!wishes.normal && !wishes.position && !wishes.value) return;
  std::vector<std::uint16_t> hit_objects;
  if (frame.objects.size() > 1) ObjectHierarchy::find_hit_objects(rays.size, hits, hit_objects);
  else hit_objects = frame.objects;
  for (const std::uint16_t object : hit_objects)
    frame.scene.objects[object].surface->dress(rays, hits, wishes, dressed);
}

}  // namespace isocast
