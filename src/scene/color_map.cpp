#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/base/text.h>
#include <isocast/scene/color_map.h>
#include <isocast/scene/srgb.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace isocast {
namespace {

// Equally spaced colours as 0xrrggbb.
constexpr std::uint32_t kViridis[] = {0x440154, 0x482475, 0x414487, 0x355f8d, 0x2a788e, 0x21918c,
                                      0x22a884, 0x44bf70, 0x7ad151, 0xbddf26, 0xfde725};
constexpr std::uint32_t kPlasma[] = {0x0d0887, 0x41049d, 0x6a00a8, 0x8f0da4, 0xb12a90, 0xcc4778,
                                     0xe16462, 0xf2844b, 0xfca636, 0xfcce25, 0xf0f921};
constexpr std::uint32_t kMagma[] = {0x000004, 0x140e36, 0x3b0f70, 0x641a80, 0x8c2981, 0xb73779,
                                    0xde4968, 0xf7705c, 0xfe9f6d, 0xfecf92, 0xfcfdbf};
constexpr std::uint32_t kInferno[] = {0x000004, 0x160b39, 0x420a68, 0x6a176e, 0x932667, 0xbc3754,
                                      0xdd513a, 0xf37819, 0xfca50a, 0xf6d746, 0xfcffa4};
constexpr std::uint32_t kGrey[] = {0x000000, 0xffffff};
constexpr std::uint32_t kCoolwarm[] = {0x3b4cc0, 0x6282ea, 0x8db0fe, 0xb8d0f9, 0xdddddd,
                                       0xf5c4ad, 0xf49a7b, 0xde604d, 0xb40426};

constexpr struct {
  const char* name;
  std::span<const std::uint32_t> colors;
} kMaps[] = {{"viridis", kViridis}, {"plasma", kPlasma}, {"magma", kMagma},
             {"inferno", kInferno}, {"grey", kGrey},     {"coolwarm", kCoolwarm}};

}  // namespace

ColorMap::ColorMap(std::vector<ColorPoint> points, const Color& nan)
    : points_(std::move(points)), nan_(nan) {}

Color ColorMap::at(double x) const {
  if (std::isnan(x)) return nan_;
  x = x > 0 ? std::min(x, 1.0) : 0;
  const auto behind = std::ranges::upper_bound(points_, x, {}, &ColorPoint::x);
  const ColorPoint& b = behind == points_.end() ? points_.back() : *behind;
  const ColorPoint& a = behind == points_.begin() ? b : *(behind - 1);
  const double part = b.x > a.x ? (x - a.x) / (b.x - a.x) : 0;
  Color color;
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = static_cast<float>(linear_from_srgb(a.srgb[c] + part * (b.srgb[c] - a.srgb[c])));
  return color;
}

std::vector<std::string> color_map_names() {
  std::vector<std::string> names;
  for (const auto& map : kMaps) names.emplace_back(map.name);
  return names;
}

ColorMap color_map_from_name(const std::string& name) {
  for (const auto& [known, colors] : kMaps) {
    if (known != name) continue;
    std::vector<ColorPoint> points;
    for (std::size_t i = 0; i < colors.size(); ++i) {
      const auto channel = [&](int shift) { return (colors[i] >> shift & 255) / 255.0; };
      points.push_back({static_cast<double>(i) / static_cast<double>(colors.size() - 1),
                        {channel(16), channel(8), channel(0)}});
    }
    return ColorMap(std::move(points));
  }
  std::string names;
  for (const auto& map : kMaps) add_to_list(names, map.name);
  throw InputError(fmt::format("found the colour map {}, expected one of: {}, or a .json file of ParaView",
                               in_quotes(name), names));
}

}  // namespace isocast
