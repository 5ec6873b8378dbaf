// Environments: which pixel a direction sees, and which files are read.
#include <OpenImageIO/imageio.h>
#include <input_error.h>
#include <isocast/base/output_file.h>
#include <isocast/render/environment_file.h>
#include <isocast/render/image_file.h>
#include <temporary_folder.h>

#include <cmath>
#include <limits>
#include <numbers>

using namespace isocast;
using test::says;
using test::TemporaryFolder;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

void check_color(const Color& found, const Color& expected) {
  for (int c = 0; c < 3; ++c) CHECK(found[c] == Approx(expected[c]).margin(1e-6));
}
Double3 towards(double longitude, double angle) {
  return {std::sin(longitude) * std::sin(angle), std::cos(longitude) * std::sin(angle), std::cos(angle)};
}
void write_file(const std::filesystem::path& path, OIIO::ImageSpec spec, const std::vector<float>& pixels) {
  const auto output = OIIO::ImageOutput::create(path.string());
  REQUIRE(output);
  REQUIRE(output->open(path.string(), spec));
  REQUIRE(output->write_image(OIIO::TypeFloat, pixels.data()));
  REQUIRE(output->close());
}

}  // namespace

TEST_CASE("a direction sees its pixel, and a mean of four between them") {
  constexpr int w = 8, h = 4;
  std::vector<Color> pixels;
  for (int i = 0; i < w * h; ++i) pixels.push_back({float(i % w), float(i / w), float(i * i)});
  const Environment environment(w, h, pixels);
  constexpr double pi = std::numbers::pi;
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      const Double3 d = towards(((x + 0.5) / w - 0.5) * 2 * pi, (y + 0.5) / h * pi);
      const Color found = environment.towards(d), scaled = environment.towards(1e-3 * d);
      for (int c = 0; c < 3; ++c) {
        CHECK(found[c] == Approx(pixels[y * w + x][c]).margin(1e-4));
        CHECK(scaled[c] == Approx(found[c]).margin(1e-4));
      }
    }
  // +y between the middle columns, +x to the right of it, -y between the last column and the first
  CHECK(environment.towards({0, 1, 0})[0] == Approx(3.5));
  CHECK(environment.towards({1, 0, 0})[0] == Approx(5.5));
  CHECK(environment.towards({-1, 0, 0})[0] == Approx(1.5));
  CHECK(environment.towards({0, -1, 0})[0] == Approx(3.5));  // the mean of 0 and 7
  CHECK(environment.towards({0, 1, 0})[1] == Approx(1.5));
  // the poles
  CHECK(environment.towards({0, 0, 1})[1] == 0);
  CHECK(environment.towards({0, 0, -1})[1] == 3);
  // no direction at all
  for (const double x : {0.0, std::nan("")}) CHECK(std::isfinite(environment.towards({x, x, x})[2]));
}

TEST_CASE("one pixel is one colour everywhere") {
  const Environment environment(1, 1, {{0.25f, 0.5f, 1}});
  for (const Double3& d : {Double3{1, 2, 3}, Double3{-1, 0, 0}, Double3{0, 0, -1}})
    check_color(environment.towards(d), {0.25f, 0.5f, 1});
}

TEST_CASE("pictures of 8 bits are sRGB, the others linear") {
  const TemporaryFolder folder;
  const Double3 left = towards(-std::numbers::pi / 2, std::numbers::pi / 2);
  const std::vector<float> rgba = {0.5f, 0.25f, 1, 1, 0, 0, 0, 1};
  write_png(folder / "sky.png", 2, 1, rgba.data());
  const Color coded = read_environment(folder / "sky.png")->towards(left);
  CHECK(coded[0] == Approx(0.5).margin(0.005));
  CHECK(coded[1] == Approx(0.25).margin(0.005));
  CHECK(coded[2] == Approx(1).margin(1e-5));

  const std::vector<float> depth = {7, 8}, colors = {3, 0.125f, kInfinity, std::nanf(""), 0, 0};
  write_exr(folder / "sky.exr", 2, 1, {{{"A.depth"}, depth.data()}, {{"R", "G", "B"}, colors.data()}});
  const auto sky = read_environment(folder / "sky.exr");
  check_color(sky->towards(left), {3, 0.125f, 65504});
  check_color(sky->towards(-1.0 * left), {0, 0, 0});

  write_file(folder / "sky.hdr", OIIO::ImageSpec(2, 1, 3, OIIO::TypeFloat), {2, 0.5f, 0.25f, 0, 0, 0});
  const Color radiance = read_environment(folder / "sky.hdr")->towards(left);
  CHECK(radiance[0] == Approx(2).epsilon(0.01));
  CHECK(radiance[2] == Approx(0.25).epsilon(0.02));

  const std::vector<float> codes(6, 0.5f);
  write_file(folder / "sky.jpg", OIIO::ImageSpec(2, 1, 3, OIIO::TypeUInt8), codes);
  CHECK(read_environment(folder / "sky.jpg")->towards(left)[1] == Approx(0.214).margin(0.01));

  write_exr(folder / "grey.exr", 2, 1, {{{"Y"}, depth.data()}});
  check_color(read_environment(folder / "grey.exr")->towards(left), {7, 7, 7});
}

TEST_CASE("files that are no environments get one sentence") {
  const TemporaryFolder folder;
  CHECK_THROWS_MATCHES(read_environment(folder / "none.exr"), InputError, says("none.exr: No such file"));
  CHECK_THROWS_MATCHES(read_environment(folder / "sky.tga"), InputError,
                       says("ends with .exr, .hdr, .png or .jpg"));
  for (const std::string name : {"text.exr", "text.hdr", "text.png", "text.jpg"}) {
    write_text_file(folder / name, "not a picture\n");
    CHECK_THROWS_MATCHES(read_environment(folder / name), InputError,
                         says("cannot read " + (folder / name).string()));
  }
  // a header of 30000 x 30000 pixels and nothing behind
  write_text_file(folder / "huge.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 30000 +X 30000\n");
  CHECK_THROWS_MATCHES(read_environment(folder / "huge.hdr"), InputError, says("30000x30000 pixels"));
  // files that end too early (not PNG: its library leaks what it allocates on the way out of an error)
  const std::vector<float> rgb(16 * 16 * 3, 0.5f);
  write_file(folder / "sky.hdr", OIIO::ImageSpec(16, 16, 3, OIIO::TypeFloat), rgb);
  write_exr(folder / "sky.exr", 16, 16, {{{"R", "G", "B"}, rgb.data()}});
  for (const std::string extension : {".hdr", ".exr"}) {
    const std::string bytes = test::bytes_of(folder / ("sky" + extension));
    for (const std::size_t size : {std::size_t(8), std::size_t(40), bytes.size() - 9}) {
      write_text_file(folder / ("cut" + extension), bytes.substr(0, size));
      INFO(extension << " cut to " << size);
      CHECK_THROWS_AS(read_environment(folder / ("cut" + extension)), InputError);
    }
  }
}
