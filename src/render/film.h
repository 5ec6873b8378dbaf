// The picture in the making: colour and the layers that were asked for.
#pragma once

#include <isocast/ray/hit.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace isocast {

/// The layers of `--aov`, by interface.md's names.
enum class Layer : std::uint8_t { depth, z, normal, position, id, value, cost, certificate, object, albedo };
inline constexpr int kLayerCount = 10;
[[nodiscard]] std::string_view name_of(Layer layer);
[[nodiscard]] int channels_of(Layer layer);
/// Throws InputError for an unknown name, listing those that exist.
[[nodiscard]] Layer layer_from_name(std::string_view name);

/// Row-major, first row on top, float. Colour is linear RGBA, composited over the background or the
/// environment; alpha is the share that surfaces keep out of these. Where a ray hits nothing: depth and z are
/// +inf, the other layers 0. id is 1 + the number of the iso-value, counted over all objects, object 1 +
/// the number of the object; albedo is the material's colour; depth is the distance along the ray, z along
/// the view axis, both in world units.
class Film {
 public:
  Film(int width, int height, const std::vector<Layer>& layers);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] bool has(Layer layer) const { return !layers_[static_cast<int>(layer)].empty(); }
  [[nodiscard]] bool has_layers() const {
    return std::ranges::any_of(layers_, [](const std::vector<float>& layer) { return !layer.empty(); });
  }
  /// The channels of pixel `id` (x + y * width).
  [[nodiscard]] float* color(std::uint32_t id) { return &color_[std::size_t(id) * 4]; }
  [[nodiscard]] float* at(Layer layer, std::uint32_t id) {
    return &layers_[static_cast<int>(layer)][std::size_t(id) * channels_of(layer)];
  }
  [[nodiscard]] const std::vector<float>& color() const { return color_; }
  [[nodiscard]] const std::vector<float>& layer(Layer layer) const {
    return layers_[static_cast<int>(layer)];
  }

 private:
  int width_, height_;
  std::vector<float> color_, layers_[kLayerCount];
};

}  // namespace isocast
