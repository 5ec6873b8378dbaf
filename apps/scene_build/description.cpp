#include <fmt/format.h>
#include <isocast/apps/scene_build/description.h>
#include <isocast/base/error.h>
#include <isocast/scene/srgb.h>

#include <charconv>

namespace isocast {

std::vector<SolidDescription> SceneDescription::clips_of(std::size_t object) const {
  std::vector<SolidDescription> all = objects[object].clips;
  all.insert(all.end(), clips.begin(), clips.end());
  return all;
}

Color color_from_hex(const std::string& text) {
  unsigned code = 0;
  const bool shaped = text.size() == 7 && text[0] == '#';
  const auto [end, error] =
      std::from_chars(text.data() + (shaped ? 1 : 0), text.data() + text.size(), code, 16);
  if (!shaped || error != std::errc() || end != text.data() + text.size())
    throw InputError(fmt::format("colour '{}': expected six hexadecimal digits such as #d9a066", text));
  const auto linear = [](unsigned byte) { return static_cast<float>(linear_from_srgb(byte / 255.0)); };
  return {linear(code >> 16), linear(code >> 8 & 255), linear(code & 255)};
}

Material material_of(const MaterialDescription& description, std::size_t i) {
  static const char* const palette[] = {"#d9b38c", "#7fa6c9", "#9dbf7a", "#c98a8a", "#b39ccf", "#d6c45f"};
  const auto repeated = [i](const auto& list, auto otherwise) {
    return list.empty() ? otherwise : static_cast<decltype(otherwise)>(list[i % list.size()]);
  };
  return {repeated(description.colors, color_from_hex(palette[i % std::size(palette)])),
          repeated(description.opacities, 1.0f), repeated(description.reflectivities, 0.0f),
          repeated(description.speculars, Material{}.specular)};
}

}  // namespace isocast
