#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/base/error.h>
#include <isocast/render/film.h>

#include <limits>

namespace isocast {
namespace {

struct LayerRow {
  std::string_view name;
  int channels;
  float nothing;
};
constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr LayerRow kRows[kLayerCount] = {
    {"depth", 1, kFar}, {"z", 1, kFar}, {"normal", 3, 0},       {"position", 3, 0}, {"id", 1, 0},
    {"value", 1, 0},    {"cost", 1, 0}, {"certificate", 1, -1}, {"object", 1, 0},   {"albedo", 3, 0}};

}  // namespace

std::string_view name_of(Layer layer) { return kRows[static_cast<int>(layer)].name; }
int channels_of(Layer layer) { return kRows[static_cast<int>(layer)].channels; }

Layer layer_from_name(std::string_view name) {
  std::vector<std::string_view> names;
  for (int i = 0; i < kLayerCount; ++i) {
    if (kRows[i].name == name) return static_cast<Layer>(i);
    names.push_back(kRows[i].name);
  }
  throw InputError(fmt::format("--aov {}: unknown layer; expected some of {}", name, fmt::join(names, ", ")));
}

Film::Film(int width, int height, const std::vector<Layer>& layers) : width_(width), height_(height) {
  const std::size_t pixels = std::size_t(width) * std::size_t(height);
  color_.resize(pixels * 4);
  for (const Layer layer : layers) {
    const LayerRow& row = kRows[static_cast<int>(layer)];
    layers_[static_cast<int>(layer)].assign(pixels * row.channels, row.nothing);
  }
}

}  // namespace isocast
