// A volume file that shrinks between its loading and its picture.
#include <input_error.h>
#include <isocast/apps/scene_build/scene_build.h>
#include <isocast/base/output_file.h>
#include <isocast/render/render.h>
#include <temporary_folder.h>

#include <algorithm>

using namespace isocast;
using test::says;
using test::TemporaryFolder;

TEST_CASE("a volume file that shrinks before its picture is done is told") {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "v_64x64x64_uint8.raw";
  std::string samples(64 * 64 * 64, '\0');
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = static_cast<char>(4 * (i % 64));
  write_text_file(file, samples);
  SceneDescription description;
  description.objects.front().source = VolumeSource{file, {}};
  description.objects.front().iso = {128};
  const BuiltScene built = build_scene(description, {});
  REQUIRE(std::ranges::count(built.features, "memory mapping") == 1);

  const View view(frame(built.scene.bounds(), {}, 1), 64, 64);
  Film film(64, 64, {});
  CHECK(render(built.scene, view, {}, film).hits > 0);
  std::filesystem::resize_file(file, 10000);
  CHECK_THROWS_MATCHES(render(built.scene, view, {}, film), InputError,
                       says("v_64x64x64_uint8.raw shrank while it was in use"));
  CHECK_THROWS_MATCHES(build_scene(description, {}), InputError, says("found 10000"));
}
