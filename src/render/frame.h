// What the stages of a frame share.
#pragma once

#include <isocast/render/render.h>
#include <isocast/scene/object_hierarchy.h>

#include <limits>
#include <memory>
#include <vector>

namespace isocast {

/// Everything that a tile needs to know.
///
/// lights    of the scene, unit length
/// objects   the numbers of all objects
/// first_id  per object: ids of the objects before it
/// passes    per object: what finds its primary rays block by block, or null
/// passed    per object, where there are passes: 1 if it has one
/// coverage  what tells the shares of pixels, where that is wished; else null
/// bounds    of the scene
/// hierarchy of several objects; null where there is one, or where each ray's cost is told
/// proves    every object does
struct Frame {
  const Scene& scene;
  const View& view;
  const RenderSettings& settings;
  Features features;
  std::vector<Double3> lights = {};
  std::vector<std::uint16_t> objects = {};
  std::vector<int> first_id = {};
  std::vector<std::unique_ptr<PrimaryPass>> passes = {};
  std::vector<std::uint8_t> passed = {};
  std::unique_ptr<CoveragePass> coverage = {};
  bool proves = false;
  std::shared_ptr<const ObjectHierarchy> hierarchy = {};
  Box bounds = {};
};

/// Rays with what they hit.
///
/// hits    kept elsewhere
/// slot    the primary ray of the tile that a ray descends from
/// weight  the share of that ray's colour which it brings
/// sample  of the pixel, from 0 on
struct Wave {
  RayStream rays;
  HitStream* hits;
  DressedHits dressed;
  int slot[kStreamSize];
  float weight[kStreamSize];
  int sample;
};

inline bool is_ray(const RayStream& rays, int i) { return rays.t_min[i] <= rays.t_max[i]; }
inline Double3 direction_of(const RayStream& rays, int i) { return {rays.dx[i], rays.dy[i], rays.dz[i]}; }
inline Double3 normal_of(const DressedHits& dressed, int i) {
  return {dressed.normal[0][i], dressed.normal[1][i], dressed.normal[2][i]};
}
inline const Material& material_of(const Scene& scene, const HitStream& hits, int i) {
  const SceneObject& object = scene.objects[hits.object[i]];
  if (!object.by_component) return object.materials[hits.iso[i]];
  return object.materials[static_cast<std::size_t>(hits.cell[0][i]) % object.materials.size()];
}

/// Adds a ray that leaves hit i: from the near end of its bracket, on the side that `from` came from.
inline void spawn(const RayStream& from, const HitStream& hits, int i, const Double3& direction,
                  RayStream& to) {
  const int n = to.size++;
  to.ox[n] = from.ox[i] + hits.t_lo[i] * from.dx[i];
  to.oy[n] = from.oy[i] + hits.t_lo[i] * from.dy[i];
  to.oz[n] = from.oz[i] + hits.t_lo[i] * from.dz[i];
  to.dx[n] = direction[0], to.dy[n] = direction[1], to.dz[n] = direction[2];
  to.t_min[n] = 0;
  to.t_max[n] = std::numeric_limits<double>::infinity();
  to.id[n] = from.id[i];
  to.start_object[n] = hits.object[i];
  to.start_sides[n] = hits.sides[i];
}

}  // namespace isocast
