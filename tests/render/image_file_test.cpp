#include <OpenImageIO/imageio.h>
#include <input_error.h>
#include <isocast/base/output_file.h>
#include <isocast/render/image_file.h>
#include <temporary_folder.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <map>
#include <utility>

using namespace isocast;
using Catch::Contains;
using Catch::StartsWith;
using test::bytes_of;
using test::says;
using test::TemporaryFolder;

namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();

// A film whose numbers tell pixel and channel apart.
Film numbered_film(int width, int height, const std::vector<Layer>& layers) {
  Film film(width, height, layers);
  for (int id = 0; id < width * height; ++id) {
    for (int k = 0; k < 4; ++k) film.color(id)[k] = 0.25f * float(k) + 1e-3f * float(id);
    for (const Layer layer : layers)
      for (int k = 0; k < channels_of(layer); ++k)
        film.at(layer, id)[k] = float(10 * int(layer) + k) + float(id) / 7;
  }
  return film;
}

std::size_t little_endian_at(const std::string& bytes, std::size_t at) {
  std::size_t value = 0;
  for (int i = 3; i >= 0; --i) value = value * 256 + static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

// The header of an EXR: every attribute with its bytes.
std::map<std::string, std::string> exr_attributes(const std::string& bytes) {
  std::map<std::string, std::string> attributes;
  for (std::size_t at = 8; bytes.at(at) != 0;) {
    const std::string name = &bytes[at], type = &bytes.at(at + name.size() + 1);
    const std::size_t size_at = at + name.size() + 1 + type.size() + 1;
    const std::size_t size = little_endian_at(bytes, size_at);
    attributes[name] = bytes.substr(size_at + 4, size);
    at = size_at + 4 + size;
  }
  return attributes;
}

// The chunks of a PNG but the pixels, in order: name and bytes.
std::vector<std::pair<std::string, std::string>> png_chunks(const std::string& bytes) {
  std::vector<std::pair<std::string, std::string>> chunks;
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    const std::string length(bytes.rend() - at - 4, bytes.rend() - at), name = bytes.substr(at + 4, 4);
    const std::size_t size = little_endian_at(length, 0);
    if (name != "IDAT") chunks.emplace_back(name, bytes.substr(at + 8, size));
    at += 12 + size;
  }
  return chunks;
}

}  // namespace

TEST_CASE("sRGB codes are the nearest ones") {
  CHECK(srgb_code(0) == 0);
  CHECK(srgb_code(1) == 255);
  CHECK(srgb_code(-3) == 0);
  CHECK(srgb_code(kInf) == 255);
  CHECK(srgb_code(-kInf) == 0);
  CHECK(srgb_code(std::nanf("")) == 0);
  CHECK(srgb_code(0.2140f) == 127);
  CHECK(srgb_code(0.2159f) == 128);

  // Every code's own linear value gives the code back, and the formula agrees away from ties.
  const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  const auto coded = [](double v) {
    return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
  };
  for (int code = 0; code < 256; ++code) CHECK(srgb_code(float(linear(code / 255.0))) == code);
  int compared = 0;
  for (float v = 1e-5f; v < 1; v += 1e-5f) {
    const double exact = 255 * coded(v);
    if (std::abs(exact - std::floor(exact) - 0.5) < 1e-3) continue;
    REQUIRE(srgb_code(v) == int(std::floor(exact + 0.5)));
    ++compared;
  }
  CHECK(compared > 90000);
}

TEST_CASE("a PNG holds the colours as sRGB codes") {
  const TemporaryFolder folder;
  const std::vector<float> rgba = {0, 0.5f, 1, 1, 0.2140f, -1, 2, 0};
  write_png(folder / "p.png", 2, 1, rgba.data());
  const auto input = OIIO::ImageInput::open((folder / "p.png").string());
  REQUIRE(input);
  CHECK(input->spec().width == 2);
  CHECK(input->spec().height == 1);
  CHECK(input->spec().channelnames == std::vector<std::string>{"R", "G", "B"});
  CHECK(input->spec().get_string_attribute("oiio:ColorSpace") == "sRGB");
  std::vector<std::uint8_t> codes(6);
  REQUIRE(input->read_image(0, 0, 0, 3, OIIO::TypeUInt8, codes.data()));
  CHECK(codes == std::vector<std::uint8_t>{0, 188, 255, 127, 0, 255});
}

TEST_CASE("an EXR gives every layer back bit for bit") {
  const TemporaryFolder folder;
  std::vector<Layer> layers;
  for (int i = 0; i < kLayerCount; ++i) layers.push_back(static_cast<Layer>(i));
  Film film = numbered_film(37, 70, layers);
  *film.at(Layer::depth, 5) = kInf;
  write_exr(folder / "p.exr", 37, 70, image_layers(film));

  const Image image = read_exr(folder / "p.exr");
  CHECK(image.width == 37);
  CHECK(image.height == 70);
  CHECK(image.channels.size() == 20);
  CHECK(image.at(5, 0, image.channel("depth")) == kInf);
  CHECK(image.channel("speed") == -1);
  for (const ImageLayer& layer : image_layers(film)) {
    const int stride = int(layer.channels.size());
    for (int k = 0; k < stride; ++k) {
      const int channel = image.channel(layer.channels[k]);
      INFO(layer.channels[k]);
      REQUIRE(channel >= 0);
      bool same = true;
      for (int id = 0; id < 37 * 70; ++id)
        same &= image.at(id % 37, id / 37, channel) == layer.data[id * stride + k];
      CHECK(same);
    }
  }
}

TEST_CASE("layers carry the names of interface and film") {
  const Film film(1, 1, {Layer::normal, Layer::depth});
  const auto layers = image_layers(film, false);
  REQUIRE(layers.size() == 2);
  CHECK(layers[0].channels == std::vector<std::string>{"depth"});
  CHECK(layers[1].channels == std::vector<std::string>{"normal.X", "normal.Y", "normal.Z"});
  CHECK(image_layers(film).front().channels == std::vector<std::string>{"R", "G", "B", "A"});
}

TEST_CASE("layers have the names that compositors look for, and a file says what it was told") {
  const TemporaryFolder folder;
  std::vector<Layer> layers;
  for (int i = 0; i < kLayerCount; ++i) layers.push_back(static_cast<Layer>(i));
  const Film film = numbered_film(8, 6, layers);
  const std::vector<ImageLayer> named = image_layers(film, true, ChannelNames::compositor);
  std::vector<std::string> names;
  for (const ImageLayer& layer : named)
    names.insert(names.end(), layer.channels.begin(), layer.channels.end());
  const std::vector<std::string> expected = {
      "R",        "G",        "B",        "A",       "depth.Z", "Z",       "N.X",    "N.Y",
      "N.Z",      "P.X",      "P.Y",      "P.Z",     "id.X",    "value.X", "cost.X", "certificate.X",
      "object.X", "albedo.R", "albedo.G", "albedo.B"};
  CHECK(names == expected);
  write_exr(folder / "p.exr", 8, 6, named, {{"isocast:scene", "1234"}, {"isocast:method", "affine"}});
  const Image image = read_exr(folder / "p.exr");
  for (const std::string& name : expected) CHECK(image.channel(name) >= 0);
  CHECK(image.at(3, 2, image.channel("Z")) == film.layer(Layer::z)[3 + 2 * 8]);
  const auto attributes = exr_attributes(bytes_of(folder / "p.exr"));
  CHECK(attributes.at("isocast:scene") == "1234");
  CHECK(attributes.at("isocast:method") == "affine");
}

TEST_CASE("the same pixels give the same bytes, without time, host or program") {
  const TemporaryFolder folder;
  const Film film = numbered_film(64, 48, {Layer::depth, Layer::normal});
  const auto write = [&](const std::string& name) {
    write_png(folder / (name + ".png"), 64, 48, film.color().data());
    write_exr(folder / (name + ".exr"), 64, 48, image_layers(film));
  };
  write("a");
  write("b");
  for (const std::string extension : {".png", ".exr"}) {
    const bool same = bytes_of(folder / ("a" + extension)) == bytes_of(folder / ("b" + extension));
    INFO(extension);
    CHECK(same);
  }
  CHECK(folder.entries() == 4);

  // The headers hold geometry and colour space, and no other text.
  std::vector<std::string> names;
  const auto attributes = exr_attributes(bytes_of(folder / "a.exr"));
  for (const auto& [name, value] : attributes) names.push_back(name);
  CHECK(names == std::vector<std::string>{"capDate", "channels", "compression", "dataWindow", "displayWindow",
                                          "lineOrder", "pixelAspectRatio", "screenWindowCenter",
                                          "screenWindowWidth"});
  CHECK(attributes.at("capDate").empty());
  names.clear();
  for (const auto& [name, value] : png_chunks(bytes_of(folder / "a.png"))) {
    names.push_back(name);
    if (name == "tEXt") CHECK(value == std::string("oiio:ColorSpace\0sRGB", 20));
  }
  CHECK(names == std::vector<std::string>{"IHDR", "gAMA", "sRGB", "cHRM", "oFFs", "tEXt", "IEND"});
}

TEST_CASE("pictures that cannot be written leave nothing behind") {
  const TemporaryFolder folder;
  const float rgba[4] = {};
  CHECK_THROWS_MATCHES(write_png(folder / "none/p.png", 1, 1, rgba), InputError, says("none does not exist"));
  CHECK_THROWS_MATCHES(write_exr(folder.path, 1, 1, {{{"R"}, rgba}}), InputError, says("it is a folder"));
  CHECK(folder.entries() == 0);
}

TEST_CASE("files that are no pictures get one sentence") {
  const TemporaryFolder folder;
  CHECK_THROWS_MATCHES(read_exr(folder / "none.exr"), InputError, says("none.exr: No such file"));
  write_text_file(folder / "empty.exr", "");
  write_text_file(folder / "text.exr", "not a picture\n");
  for (const std::string name : {"empty.exr", "text.exr"})
    CHECK_THROWS_MATCHES(read_exr(folder / name), InputError,
                         says("cannot read " + (folder / name).string()));
}

TEST_CASE("an EXR in tiles is refused") {
  const TemporaryFolder folder;
  OIIO::ImageSpec spec(64, 64, 1, OIIO::TypeFloat);
  spec.tile_width = spec.tile_height = 32;
  const std::vector<float> data(64 * 64);
  const auto output = OIIO::ImageOutput::create("openexr");
  REQUIRE(output->open((folder / "p.exr").string(), spec));
  REQUIRE(output->write_image(OIIO::TypeFloat, data.data()));
  REQUIRE(output->close());
  CHECK_THROWS_MATCHES(read_exr(folder / "p.exr"), InputError, says("it is a deep or tiled image"));
}

TEST_CASE("a damaged picture never crashes the reader") {
  const TemporaryFolder folder;
  write_exr(folder / "p.exr", 40, 30, image_layers(numbered_film(40, 30, {Layer::depth})));
  const std::string good = bytes_of(folder / "p.exr");
  const auto path = folder / "damaged.exr";
  const auto refused = [&](const std::string& bytes) {
    write_text_file(path, bytes);
    try {
      (void)read_exr(path);
      return false;
    } catch (const InputError& error) {
      CHECK_THAT(error.what(), StartsWith("cannot read " + path.string()) && !Contains("\n"));
      return true;
    }
  };

  // Cut anywhere it is refused; with a byte turned over it may pass, with other numbers.
  for (std::size_t size = 0; size < good.size(); size += 1 + good.size() / 64)
    CHECK(refused(good.substr(0, size)));
  int count = 0;
  for (std::size_t at = 0; at < good.size(); at += at < 500 ? 1 : good.size() / 256) {
    std::string bytes = good;
    bytes[at] = static_cast<char>(~bytes[at]);
    count += refused(bytes);
  }
  CHECK(count > 100);
}

TEST_CASE("a header's size is not believed") {
  const TemporaryFolder folder;
  const std::vector<float> data(40 * 30);
  write_exr(folder / "p.exr", 40, 30, {{{"R"}, data.data()}});
  std::string bytes = bytes_of(folder / "p.exr");

  // Both windows get 2^31 - 2 columns, then 2^15 + 1.
  const std::pair<std::uint32_t, std::string> cases[] = {
      {0x7ffffffdu, "Invalid display window"},
      {0x8000u, "it has 32769x30 pixels of 1 channels, at most 32768x32768 of 64 were expected"}};
  for (const auto& [last, message] : cases) {
    for (const std::string window : {"dataWindow", "displayWindow"})
      std::memcpy(&bytes[bytes.find(window) + window.size() + 1 + sizeof("box2i") + 4 + 8], &last, 4);
    write_text_file(folder / "p.exr", bytes);
    CHECK_THROWS_MATCHES(read_exr(folder / "p.exr"), InputError, says(message));
  }
}
