#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>
#include <isocast/base/module.h>
#include <isocast/base/output_file.h>
#include <isocast/render/image_file.h>
#include <isocast/render/image_module.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace isocast {
namespace {

const ImageModule& image_module(const std::filesystem::path& path) {
  return module_table<ImageModule>("image", fmt::format("the picture {}", path.string()));
}

// The linear values half-way between two neighbouring codes, from the sRGB transfer function (IEC 61966-2-1).
std::array<double, 255> srgb_steps() {
  std::array<double, 255> steps;
  for (int code = 0; code < 255; ++code) {
    const double coded = (code + 0.5) / 255;
    steps[code] = coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4);
  }
  return steps;
}

}  // namespace

int Image::channel(std::string_view name) const {
  const auto found = std::find(channels.begin(), channels.end(), name);
  return found == channels.end() ? -1 : static_cast<int>(found - channels.begin());
}

std::uint8_t srgb_code(float linear) {
  static const std::array<double, 255> steps = srgb_steps();
  const auto above =
      std::partition_point(steps.begin(), steps.end(), [&](double step) { return step <= linear; });
  return static_cast<std::uint8_t>(above - steps.begin());
}

std::vector<ImageLayer> image_layers(const Film& film, bool color) {
  std::vector<ImageLayer> layers;
  if (color) layers.push_back({{"R", "G", "B", "A"}, film.color().data()});
  for (int i = 0; i < kLayerCount; ++i) {
    const Layer layer = static_cast<Layer>(i);
    if (!film.has(layer)) continue;
    const std::string name(name_of(layer));
    const bool vector = channels_of(layer) == 3;
    const std::vector<std::string> channels =
        vector ? std::vector{name + ".X", name + ".Y", name + ".Z"} : std::vector{name};
    layers.push_back({channels, film.layer(layer).data()});
  }
  return layers;
}

void write_png(const std::filesystem::path& path, int width, int height, const float* rgba) {
  const std::size_t pixels = std::size_t(width) * std::size_t(height);
  std::vector<std::uint8_t> rgb(pixels * 3);
  for (std::size_t i = 0; i < pixels; ++i)
    for (int k = 0; k < 3; ++k) rgb[i * 3 + k] = srgb_code(rgba[i * 4 + k]);
  write_text_file(path, image_module(path).encode_png(path.string(), width, height, rgb.data()));
}

void write_exr(const std::filesystem::path& path, int width, int height,
               const std::vector<ImageLayer>& layers) {
  write_text_file(path, image_module(path).encode_exr(path.string(), width, height, layers));
}

Image read_exr(const std::filesystem::path& path) {
  (void)map_file(path);  // says what is wrong with a file that is missing or may not be read
  return image_module(path).read_exr(path.string());
}

}  // namespace isocast
