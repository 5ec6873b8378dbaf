#include <isocast/apps/viewer/make_picture.h>
#include <isocast/render/image_file.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace isocast::viewer {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

Rgb color_of(float certificate) {
  if (certificate == 1) return {30, 160, 60};
  if (certificate == 0) return {60, 90, 200};
  return certificate < 0 ? Rgb{128, 128, 128} : Rgb{220, 30, 30};
}

// A third of the picture's own colour shines through.
void mix(const Rgb& color, std::uint8_t* pixel) {
  for (int c = 0; c < 3; ++c) pixel[c] = static_cast<std::uint8_t>((pixel[c] + 2 * color[c]) / 3);
}

}  // namespace

std::vector<Layer> layers_of(Overlay overlay) {
  switch (overlay) {
    case Overlay::certificate: return {Layer::certificate};
    case Overlay::cost: return {Layer::cost};
    default: return {};
  }
}

Rgb heat(double x) {
  constexpr double stops[][3] = {{0, 0, 4}, {87, 16, 110}, {188, 55, 84}, {249, 142, 9}, {252, 255, 164}};
  const double place = 4 * std::clamp(x, 0.0, 1.0);
  const int i = std::min(3, static_cast<int>(place));
  Rgb color;
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = static_cast<std::uint8_t>(std::lround(std::lerp(stops[i][c], stops[i + 1][c], place - i)));
  return color;
}

std::vector<std::uint8_t> screen_pixels(const Film& film, Overlay overlay) {
  const auto width = static_cast<std::size_t>(film.width());
  std::vector<std::uint8_t> rgba(4 * width * static_cast<std::size_t>(film.height()));
  const bool certificate = overlay == Overlay::certificate && film.has(Layer::certificate),
             cost = overlay == Overlay::cost && film.has(Layer::cost);
  const float dearest = cost ? std::max(1.0f, *std::ranges::max_element(film.layer(Layer::cost))) : 1;
  oneapi::tbb::parallel_for(0, film.height(), [&](int y) {
    for (std::size_t i = width * static_cast<std::size_t>(y); i < width * static_cast<std::size_t>(y + 1);
         ++i) {
      std::uint8_t* const pixel = &rgba[4 * i];
      for (std::size_t c = 0; c < 3; ++c) pixel[c] = srgb_code(film.color()[4 * i + c]);
      pixel[3] = 255;
      if (certificate) mix(color_of(film.layer(Layer::certificate)[i]), pixel);
      if (cost) mix(heat(film.layer(Layer::cost)[i] / dearest), pixel);
    }
  });
  return rgba;
}

}  // namespace isocast::viewer
