#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/mapped_file.h>
#include <isocast/base/module.h>
#include <isocast/base/output_file.h>
#include <isocast/render/image_file.h>
#include <isocast/render/image_module.h>
#include <isocast/scene/srgb.h>

#include <algorithm>
#include <array>

namespace isocast {
namespace {

const ImageModule& image_module(const std::filesystem::path& path) {
  return module_table<ImageModule>("image", fmt::format("the picture {}", path.string()));
}

// The linear values half-way between two neighbouring codes.
std::array<double, 255> srgb_steps() {
  std::array<double, 255> steps;
  for (int code = 0; code < 255; ++code) steps[code] = linear_from_srgb((code + 0.5) / 255);
  return steps;
}

// The codes of 0, 1/kSrgbStarts, ...: between two of them lies hardly one step.
constexpr int kSrgbStarts = 4096;
std::array<std::uint8_t, kSrgbStarts> srgb_starts(const std::array<double, 255>& steps) {
  std::array<std::uint8_t, kSrgbStarts> starts;
  for (int i = 0; i < kSrgbStarts; ++i)
    starts[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(
        std::ranges::upper_bound(steps, static_cast<double>(i) / kSrgbStarts) - steps.begin());
  return starts;
}

// A format that is read, by the extension of its files, and whether its samples are sRGB codes.
struct Format {
  std::string_view extension;
  const char* name;
  bool coded;
};
constexpr Format kFormats[] = {{".exr", "openexr", false},
                               {".hdr", "hdr", false},
                               {".png", "png", true},
                               {".jpg", "jpeg", true},
                               {".jpeg", "jpeg", true}};
constexpr const Format& kExr = kFormats[0];
constexpr std::int64_t kMostExrPixels = std::int64_t(1) << 30, kMostPixels = std::int64_t(1) << 27;

Image read(const std::filesystem::path& path, const Format& format, std::int64_t most_pixels) {
  (void)map_file(path);  // says what is wrong with a file that is missing or may not be read
  return image_module(path).read(format.name, path.string(), most_pixels);
}

std::vector<std::string> channel_names(Layer layer, ChannelNames names) {
  std::string name(name_of(layer));
  if (names == ChannelNames::compositor) {
    if (layer == Layer::z) return {"Z"};
    if (layer == Layer::depth) return {"depth.Z"};
    if (layer == Layer::normal) name.assign(1, 'N');
    if (layer == Layer::position) name.assign(1, 'P');
    if (channels_of(layer) == 1) return {name + ".X"};
  }
  if (layer == Layer::albedo) return {name + ".R", name + ".G", name + ".B"};
  if (channels_of(layer) == 3) return {name + ".X", name + ".Y", name + ".Z"};
  return {name};
}

}  // namespace

int Image::channel(std::string_view name) const {
  const auto found = std::find(channels.begin(), channels.end(), name);
  return found == channels.end() ? -1 : static_cast<int>(found - channels.begin());
}

std::uint8_t srgb_code(float linear) {
  static const std::array<double, 255> steps = srgb_steps();
  static const std::array<std::uint8_t, kSrgbStarts> starts = srgb_starts(steps);
  if (!(linear > 0)) return 0;
  if (linear >= 1) return 255;
  std::size_t code = starts[static_cast<std::size_t>(linear * kSrgbStarts)];
  while (code < steps.size() && steps[code] <= linear) ++code;
  return static_cast<std::uint8_t>(code);
}

std::vector<ImageLayer> image_layers(const Film& film, bool color, ChannelNames names) {
  std::vector<ImageLayer> layers;
  if (color) layers.push_back({{"R", "G", "B", "A"}, film.color().data()});
  for (int i = 0; i < kLayerCount; ++i) {
    const Layer layer = static_cast<Layer>(i);
    if (!film.has(layer)) continue;
    layers.push_back({channel_names(layer, names), film.layer(layer).data()});
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
               const std::vector<ImageLayer>& layers, const ImageNotes& notes) {
  write_text_file(path, image_module(path).encode_exr(path.string(), width, height, layers, notes));
}

Image read_exr(const std::filesystem::path& path) { return read(path, kExr, kMostExrPixels); }

Image read_image(const std::filesystem::path& path) {
  const auto format = std::ranges::find(kFormats, path.extension().string(), &Format::extension);
  if (format == std::end(kFormats))
    throw InputError(fmt::format("the picture {}: expected a name that ends with .exr, .hdr, .png or .jpg",
                                 path.string()));
  Image image = read(path, *format, kMostPixels);
  const auto alpha = static_cast<std::size_t>(image.channel("A")), stride = image.channels.size();
  for (std::size_t i = 0; format->coded && i < image.pixels.size(); ++i)
    if (i % stride != alpha) image.pixels[i] = static_cast<float>(linear_from_srgb(image.pixels[i]));
  return image;
}

}  // namespace isocast
