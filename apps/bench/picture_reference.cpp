#include <isocast/apps/bench/picture_reference.h>
#include <isocast/apps/reference/reference_cache.h>
#include <isocast/apps/reference/scene_reference.h>

namespace isocast::bench {

PictureTruth solve_picture(const SceneDescription& scene, const BuiltScene& built,
                           const std::vector<RayStream>& rays, const std::filesystem::path& cache,
                           const reference::ReferenceOptions& options) {
  std::vector<reference::ReferenceRay> asked;
  std::vector<std::uint32_t> pixels;
  const Box box = built.scene.bounds();
  each_ray(rays, [&](std::size_t s, int i) {
    const Double3 o = {rays[s].ox[i], rays[s].oy[i], rays[s].oz[i]};
    const double end = length(box.center() - o) + box.diagonal();  // directions are not shorter than 1
    asked.push_back({o, {rays[s].dx[i], rays[s].dy[i], rays[s].dz[i]}, 0, end});
    pixels.push_back(rays[s].id[i]);
  });

  PictureTruth truth;
  const std::unique_ptr<reference::RayReference> reference = reference::make_reference(scene, built, options);
  truth.unit = reference->unit();
  truth.rays.resize(asked.size());
  std::vector<reference::RayTruth> answers = reference::solve_all(*reference, asked, cache);
  for (std::size_t n = 0; n < answers.size(); ++n) truth.rays[pixels[n]] = std::move(answers[n]);
  return truth;
}

}  // namespace isocast::bench
