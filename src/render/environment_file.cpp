#include <isocast/render/environment_file.h>
#include <isocast/render/image_file.h>

#include <algorithm>
#include <cmath>

namespace isocast {
namespace {

float finite(float value) {
  constexpr float kLargestHalf = 65504;
  return std::isnan(value) ? 0 : std::clamp(value, -kLargestHalf, kLargestHalf);
}

}  // namespace

std::shared_ptr<const Environment> read_environment(const std::filesystem::path& path) {
  const Image image = read_image(path);
  const std::size_t stride = image.channels.size();
  std::size_t channels[3];
  for (int c = 0; c < 3; ++c)
    channels[c] = static_cast<std::size_t>(std::max(0, image.channel(std::string_view("RGB").substr(c, 1))));
  std::vector<Color> pixels(image.pixels.size() / stride);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) pixels[i][c] = finite(image.pixels[i * stride + channels[c]]);
  return std::make_shared<Environment>(image.width, image.height, std::move(pixels));
}

}  // namespace isocast
