#include <fmt/format.h>
#include <isocast/render/features.h>
#include <isocast/scene/box_tree.h>

#include <algorithm>

namespace isocast {
namespace {

template <class Test> bool any_material(const Scene& scene, Test test) {
  return std::ranges::any_of(
      scene.objects, [&](const SceneObject& object) { return std::ranges::any_of(object.materials, test); });
}

}  // namespace

Features find_features(const Scene& scene, const Film& film, const RenderSettings& settings) {
  Features f;
  f.shade = settings.colors;
  f.shadows = settings.colors && scene.shadows && !scene.lights.empty();
  f.occlusion = settings.colors ? scene.ambient_occlusion.samples : 0;
  f.transparency = settings.colors && any_material(scene, [](const Material& m) { return m.opacity < 1; });
  if (settings.colors && any_material(scene, [](const Material& m) { return m.reflectivity > 0; }))
    f.reflections = settings.reflections;
  f.silhouettes = settings.colors && settings.silhouettes;
  f.coverage = settings.colors && settings.coverage;
  f.color_fields = settings.colors && std::ranges::any_of(scene.objects, [](const SceneObject& object) {
                     return object.color_field != nullptr;
                   });
  f.first_sample = {settings.colors || film.has(Layer::normal), film.has(Layer::position),
                    film.has(Layer::value)};
  f.other_samples = {settings.colors, false, false};

  const auto list = [&](bool needed, std::string name) {
    (needed ? f.used : f.left_out).push_back(std::move(name));
  };
  list(f.shade, "shading");
  list(!scene.lights.empty(),
       scene.lights.empty() ? "lights" : fmt::format("lights:{}", scene.lights.size()));
  list(f.shadows, "shadows");
  list(f.occlusion > 0,
       f.occlusion > 0 ? fmt::format("ambient occlusion:{}", f.occlusion) : "ambient occlusion");
  list(f.transparency,
       f.transparency ? fmt::format("transparency:{}", settings.transparency_depth) : "transparency");
  list(f.reflections > 0, f.reflections > 0 ? fmt::format("reflections:{}", f.reflections) : "reflections");
  list(settings.filter != PixelFilter::box, "filter");
  list(scene.environment != nullptr, "environment");
  list(f.first_sample.normal, "normals");
  list(f.first_sample.position, "positions");
  list(f.first_sample.value, "values");
  list(settings.spp > 1, settings.spp > 1 ? fmt::format("spp:{}", settings.spp) : "supersampling");
  for (int i = 0; i < kLayerCount; ++i) {
    const Layer layer = static_cast<Layer>(i);
    if (film.has(layer)) f.used.push_back(fmt::format("layer:{}", name_of(layer)));
  }
  list(f.silhouettes, "silhouettes");
  list(f.coverage, "coverage");
  list(f.color_fields, "colour fields");
  list(scene.objects.size() > 1, "object hierarchy");
  list(scene.objects.size() > 1 && has_embree(), "module:embree");
  return f;
}

}  // namespace isocast
