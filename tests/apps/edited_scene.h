// Scenes as the viewer edits, keeps and shows them.
#pragma once

#include <isocast/apps/viewer/scene_keeper.h>
#include <isocast/apps/viewer/session.h>

#include "../scene_build/made_scene.h"

namespace isocast::test {

using namespace viewer;

inline constexpr int kSize = 40;

inline void write_ball(const std::filesystem::path& file) {
  write_nrrd(file, 16, -1, 1, [](double x, double y, double z) { return x * x + y * y + z * z; });
}
inline Session session_of(const std::string& input) {
  RenderWords words;
  words.input = input;
  return start_session(words);
}
inline RenderWords shown(const Session& session, const std::vector<std::string>& clips = {}) {
  return words_of(session, kSize, kSize, clips);
}
inline Film film_of(const Scene& scene, const RenderWords& words) {
  const View view(frame(Box{{-1, -1, -2}, {1, 1, 1}}, {}, 1), kSize, kSize);
  Film film(kSize, kSize, {});
  render(scene, view, settings_of(words, {}), film);
  return film;
}
// What `isocast render` makes of the words.
inline std::vector<float> rendered(const RenderWords& words) {
  SceneDescription description = describe(words);
  if (!words.iso.empty()) description.objects.front().iso = {std::stod(words.iso)};
  return film_of(build_scene(description, evaluation_of(words)).scene, words).color();
}
// What the viewer shows.
inline std::vector<float> kept(SceneKeeper& keeper, const RenderWords& words) {
  keeper.show(words);
  keeper.choose_methods();
  return film_of(keeper.built().scene, words).color();
}
inline void adopt(Session& session, const SceneKeeper& keeper) {
  const SceneNews news = keeper.news();
  for (std::size_t k = 0; k < session.objects.size(); ++k)
    adopt_surfaces(session.objects[k], news.objects[k].iso, news.objects[k].materials);
}

}  // namespace isocast::test
