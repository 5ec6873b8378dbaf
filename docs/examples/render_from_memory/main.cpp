// Renders an iso-surface of samples that the program has in memory already; they are not copied.
// usage: render_from_memory [PICTURE.png]
#include <isocast/render/image_file.h>
#include <isocast/render/render.h>
#include <isocast/volume/volume_surface.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <span>
#include <vector>

using namespace isocast;

int main(int argc, char** argv) try {
  // Our own array: the distance to the middle of 64^3 samples, x fastest.
  constexpr int n = 64;
  std::vector<float> distances;
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        const float dx = x - 31.5f, dy = y - 31.5f, dz = z - 31.5f;
        distances.push_back(std::sqrt(dx * dx + dy * dy + dz * dz));
      }

  // A volume that views the array, which has to outlive it (else give `storage` a shared owner of the array).
  // Sample (x, y, z) lies there in the world; `world_from_grid` could set spacing, place and orientation.
  auto volume = std::make_shared<Volume>();
  volume->type = SampleType::f32;
  volume->dims = {n, n, n};
  volume->samples = std::as_bytes(std::span(distances)).data();

  // The surface where the distance is 20, a ball, and its colour. There could be more iso-values.
  VolumeSurfaceOptions options;
  options.iso = {20};
  Scene scene;
  const Material clay{.color = {0.85f, 0.5f, 0.3f}};
  scene.objects.push_back({std::make_shared<VolumeSurface>(volume, options), {clay}});

  // A camera that frames the scene (the braces could fix its position, target or field of view), and a film
  // that records depth besides colour.
  constexpr int width = 320, height = 240;
  const Camera camera = frame(scene.bounds(), {}, double(width) / height);
  const View view(camera, width, height);
  Film film(width, height, {Layer::depth});
  const RenderCounts counts = render(scene, view, {}, film);

  const float depth = *film.at(Layer::depth, width / 2 + height / 2 * width);
  const double expected = length(camera.target - camera.position) - 20;
  std::printf("%lld of %d rays hit, depth at the centre %.3f (a perfect ball: %.3f)\n",
              static_cast<long long>(counts.hits), width * height, depth, expected);
  if (argc > 1) write_png(argv[1], width, height, film.color().data());
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
