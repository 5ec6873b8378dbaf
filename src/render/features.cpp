#include <fmt/format.h>
#include <isocast/render/features.h>

namespace isocast {

Features find_features(const Scene& scene, const Film& film, const RenderSettings& settings) {
  Features f;
  f.shade = settings.colors;
  f.shadows = settings.colors && scene.shadows && scene.light.has_value();
  f.first_sample = {settings.colors || film.has(Layer::normal), f.shadows || film.has(Layer::position),
                    film.has(Layer::value)};
  f.other_samples = {settings.colors, f.shadows, false};

  const auto list = [&](bool needed, std::string name) {
    (needed ? f.used : f.left_out).push_back(std::move(name));
  };
  list(f.shade, "shading");
  list(f.shadows, "shadows");
  list(f.first_sample.normal, "normals");
  list(f.first_sample.position, "positions");
  list(f.first_sample.value, "values");
  list(settings.spp > 1, settings.spp > 1 ? fmt::format("spp:{}", settings.spp) : "supersampling");
  for (int i = 0; i < kLayerCount; ++i) {
    const Layer layer = static_cast<Layer>(i);
    if (film.has(layer)) f.used.push_back(fmt::format("layer:{}", name_of(layer)));
  }
  list(scene.objects.size() > 1, "object hierarchy");
  return f;
}

}  // namespace isocast
