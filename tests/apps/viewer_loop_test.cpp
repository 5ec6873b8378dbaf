// The render loop: its pictures are those of `isocast render`, and the newest wish never waits for an older
// one.
#include <isocast/apps/isocast/parse_values.h>
#include <isocast/apps/viewer/probe_work.h>
#include <isocast/apps/viewer/render_loop.h>
#include <isocast/apps/viewer/session.h>
#include <isocast/render/image_file.h>
#include <isocast/volume/io/read_volume.h>
#include <oneapi/tbb/info.h>
#include <temporary_folder.h>
#include <zlib.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <thread>

using namespace isocast;
using namespace isocast::viewer;

namespace {

Wish wish_for(const char* formula, const char* size = "200x120") {
  Wish wish;
  wish.words.input = formula;
  wish.words.size = size;
  return wish;
}
void rest(const RenderLoop& loop) {
  while (!loop.at_rest()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

// What `isocast render` does with the words.
Film rendered(const RenderWords& words) {
  const auto [width, height] = parse_size(words.size);
  SceneDescription description = describe(words);
  if (!words.iso.empty()) description.objects.front().iso = parse_numbers(words.iso, "--iso");
  const BuiltScene built = build_scene(description, evaluation_of(words));
  const View view(frame(built.scene.bounds(), description.camera, double(width) / height), width, height);
  Film film(width, height, {});
  render(built.scene, view, settings_of(words, description.wishes), film);
  return film;
}

// size^3 bytes, a fraction of a second to inflate.
void write_compressed_zeros(const std::filesystem::path& file, int size) {
  std::vector<unsigned char> plain(static_cast<std::size_t>(size) * size * size),
      packed(compressBound(plain.size()));
  uLongf bytes = packed.size();
  REQUIRE(compress2(packed.data(), &bytes, plain.data(), plain.size(), 1) == Z_OK);
  std::ofstream out(file, std::ios::binary);
  out << "ObjectType = Image\nNDims = 3\nCompressedData = True\nCompressedDataSize = " << bytes
      << "\nDimSize = " << size << ' ' << size << ' ' << size
      << "\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
  out.write(reinterpret_cast<const char*>(packed.data()), static_cast<std::streamsize>(bytes));
}

constexpr const char* kHard = "sin(20*x)*cos(19*y)+sin(21*y)*cos(18*z)+sin(17*z)*cos(20*x)+0.1*sin(80*x*y*z)";

}  // namespace

TEST_CASE("at rest the picture is that of isocast render") {
  RenderLoop loop;
  for (const char* aa : {"none", "spp", "silhouette", "coverage"})
    for (const bool hold : {false, true}) {
      Wish wish = wish_for("@tangle");
      wish.words.aa = aa;
      wish.words.opacity = "0.5";
      wish.hold_full = hold;
      const Film expected = rendered(wish.words);
      const std::uint64_t revision = loop.ask(wish);
      rest(loop);
      const auto picture = loop.picture();
      REQUIRE(picture);
      CHECK(picture->revision == revision);
      CHECK(picture->stage == Stage::final);
      CHECK(picture->film->color() == expected.color());
      bool same = true;
      for (std::size_t i = 0; i < picture->rgba.size(); ++i)
        same = same && picture->rgba[i] == (i % 4 == 3 ? 255 : srgb_code(expected.color()[i]));
      CHECK(same);
    }
}

TEST_CASE("iso-values, looks, lights and cameras build nothing again") {
  RenderLoop loop;
  Wish wish = wish_for("@tangle");
  loop.ask(wish);
  rest(loop);
  CHECK(loop.counts().scenes == 1);
  wish.words.iso = "1,-1";
  wish.words.colors = "#ff0000";
  wish.words.lights = {"0,0,1"};
  wish.words.shadows = true;
  wish.words.position = "3,-9,4";
  loop.ask(wish);
  rest(loop);
  CHECK(loop.counts().scenes == 1);
  CHECK(loop.picture()->film->color() == rendered(wish.words).color());
  wish.words.input = "x^2+y^2+z^2-0.5";
  loop.ask(wish);
  rest(loop);
  CHECK(loop.counts().scenes == 2);
}

TEST_CASE("previews of volumes are pictures of the same surface") {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "ball_24x24x24_float32.raw";
  std::vector<float> samples;
  for (int i = 0; i < 24 * 24 * 24; ++i) {
    const int x = i % 24 - 12, y = i / 24 % 24 - 12, z = i / 576 - 12;
    samples.push_back(std::sqrt(static_cast<float>(x * x + y * y + z * z)));
  }
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(samples.data()),
             static_cast<std::streamsize>(samples.size() * sizeof(float)));
  SceneKeeper keeper;
  RenderWords words = wish_for(file.c_str()).words;
  for (const char* iso : {"8", "5,9"})
    for (const char* method : {"auto", "certified"}) {
      words.iso = iso;
      words.method = method;
      keeper.show(words);
      CHECK(keeper.preview_scene().objects.front().surface != keeper.built().scene.objects.front().surface);
      const View view(frame(keeper.built().scene.bounds(), {}, 1), 96, 96);
      Film scene(96, 96, {Layer::depth, Layer::certificate}), preview = scene;
      render(keeper.built().scene, view, {}, scene);
      render(keeper.preview_scene(), view, {}, preview);
      CHECK(scene.color() == preview.color());
      CHECK(scene.layer(Layer::depth) == preview.layer(Layer::depth));
    }
  CHECK(keeper.scene() == 1);
}

TEST_CASE("a newer wish ends an older one within a tile of each thread") {
  RenderLoop loop;
  Wish wish = wish_for(kHard, "1600x1200");
  wish.budget_ms = 1;
  const int threads = oneapi::tbb::info::default_concurrency();
  constexpr int kMost = 1000, kEnough = 5;
  for (int i = 0; i < kMost && loop.counts().cancelled < kEnough; ++i) {
    wish.words.position = std::to_string(3 + 0.1 * (i % 10)) + ",-4,2";
    const std::uint64_t revision = loop.ask(wish);
    // its preview is there, and work on the next picture of several goes on
    while (!loop.picture() || loop.picture()->revision != revision)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  CHECK(loop.counts().cancelled >= kEnough);
  CHECK(loop.counts().tiles_cancelled > 0);
  CHECK(loop.counts().tiles_after_end <= threads);
  // the interface gets the newest picture all the same
  wish.words.size = "64x64";
  loop.ask(wish);
  rest(loop);
  CHECK(loop.picture()->film->color() == rendered(wish.words).color());
}

TEST_CASE("while wishes follow one another previews are shown") {
  RenderLoop loop;
  Wish wish = wish_for(kHard, "800x600");
  std::uint64_t shown = 0;
  int different = 0;
  constexpr int kMost = 100000;  // as many as it takes: nobody waits for a picture
  for (int i = 0; i < kMost && different < 3; ++i) {
    wish.words.position = std::to_string(3 + 1e-5 * i) + ",-4,2";
    loop.ask(wish);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    const auto picture = loop.picture();
    if (picture && picture->revision != shown) ++different, shown = picture->revision;
  }
  CHECK(different == 3);
}

TEST_CASE("what cannot be shown is told, and the scene before stays") {
  RenderLoop loop;
  Wish wish = wish_for("x^2+y^2+z^2-0.5");
  loop.ask(wish);
  rest(loop);
  wish.words.input = "x^2+y^";
  loop.ask(wish);
  rest(loop);
  CHECK(loop.news()->error.find("formula:1:7") != std::string::npos);
  CHECK(loop.news()->any);
  wish.words.position = "0,-5,0";
  loop.ask(wish);
  rest(loop);
  RenderWords before = wish.words;
  before.input = "x^2+y^2+z^2-0.5";
  CHECK(loop.picture()->film->color() == rendered(before).color());
}

TEST_CASE("loading shows how far it is and can be cancelled") {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "zeros.mha";
  write_compressed_zeros(file, 560);
  RenderLoop loop;
  Wish wish = wish_for(file.c_str());
  wish.words.iso = "0.5";
  loop.ask(wish);
  while (!loop.at_rest() && (!loop.loading() || loop.work().share == 0)) std::this_thread::yield();
  CHECK(loop.work().what == "inflating");
  // another camera does not begin it anew, cancel ends it
  wish.words.position = "0,-1000,0";
  loop.ask(wish);
  loop.cancel();
  rest(loop);
  CHECK(loop.news()->error == "loading was cancelled");
  CHECK_FALSE(loop.news()->any);
  // it is not tried again by itself, but another input is
  wish.words.position = "0,-2000,0";
  loop.ask(wish);
  rest(loop);
  CHECK(loop.counts().scenes == 0);
  loop.ask(wish_for("x^2+y^2+z^2-0.5"));
  rest(loop);
  CHECK(loop.counts().scenes == 1);
}

TEST_CASE("jobs see the complete picture, and extras make way for them") {
  RenderLoop loop;
  Wish wish = wish_for("x^2+y^2+z^2-0.5", "320x240");
  wish.overlay = Overlay::error;
  loop.ask(wish);
  std::atomic<int> probes = 0;
  double nearest = 0;
  for (int i = 0; i < 3; ++i)
    loop.post([&](const JobScene& scene) {
      CHECK(scene.picture.stage == Stage::final);
      const PixelProbe probe = probe_pixel(scene, 160, 120);
      REQUIRE(probe.probe.truth.roots.size() == 2);
      nearest = probe.probe.truth.roots.front().lo;
      REQUIRE(probe.profile.values.size() == 1024);
      const double at = (nearest - probe.profile.t0) / (probe.profile.t1 - probe.profile.t0) * 1023;
      CHECK(probe.profile.values[static_cast<std::size_t>(at)] > -1e-2f);
      CHECK(probe.profile.values[static_cast<std::size_t>(at) + 2] < 0);
      ++probes;
    });
  rest(loop);
  CHECK(probes == 3);
  CHECK(nearest > 0);
  // the overlay is there: the sphere's middle is no longer its own colour, the film is
  const auto picture = loop.picture();
  const std::size_t middle = 4 * (120 * 320 + 160);
  CHECK(picture->rgba[middle] != srgb_code(picture->film->color()[middle]));
  CHECK(picture->film->color() == rendered(wish.words).color());
}

TEST_CASE("f along a ray through a volume has its cells") {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "zeros.mha";
  write_compressed_zeros(file, 8);
  const auto volume = std::make_shared<const Volume>(read_volume(file));
  BuiltObject object;
  object.volume = volume;
  object.unclipped = {std::make_shared<VolumeSurface>(volume, VolumeSurfaceOptions{.iso = {0.5}})};
  const RayProfile profile = profile_along(object, {{-10, 3.5, 3.5}, {1, 0, 0}}, 100);
  CHECK(profile.t0 == Approx(10));
  CHECK(profile.t1 == Approx(17));
  REQUIRE(profile.borders.size() == 8);
  CHECK(profile.borders[3] == Approx(13));
  REQUIRE(profile.values.size() == 101);
  CHECK(profile.values[50] == 0);
  CHECK(profile_along(object, {{-10, 30, 3.5}, {1, 0, 0}}, 100).values.empty());
}
