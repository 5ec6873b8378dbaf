#include <isocast/apps/isocast/contact_sheet.h>
#include <isocast/apps/isocast/tiny_font.h>
#include <isocast/base/interrupt.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/render/render.h>

#include <algorithm>
#include <cmath>

namespace isocast {
namespace {

BuiltScene scene_of(const CatalogueSurface& surface, const SheetWishes& wishes) {
  SceneDescription description;
  description.objects.front().source =
      FormulaSource{surface_expression(surface), surface.domain, wishes.time};
  description.objects.front().method = wishes.method;
  description.objects.front().settings = wishes.settings;
  return build_scene(description, wishes.evaluation);
}

// The text along the lower edge, as large as kLongest characters fit; what is longer is cut off.
void write_label(const std::string& text, int size, float* tile, std::size_t stride) {
  constexpr int kLongest = 21;
  const int dot = std::max(1, size / (kLongest * (kGlyphWidth + 1))), top = size - (kGlyphHeight + 1) * dot;
  draw_text(text, [&](int x, int y) {
    for (int v = top + y * dot; v < top + (y + 1) * dot; ++v)
      for (int u = (x + 1) * dot; u < std::min((x + 2) * dot, size); ++u)
        if (v >= 0) std::fill_n(tile + std::size_t(v) * stride + std::size_t(u) * 4, 3, 0.0f);
  });
}

}  // namespace

Sheet draw_catalogue(const SheetWishes& wishes) {
  const std::span<const CatalogueSurface> surfaces = catalogue();
  const int count = static_cast<int>(surfaces.size()), size = wishes.size;
  const int columns = static_cast<int>(std::ceil(std::sqrt(count))), rows = (count + columns - 1) / columns;
  const std::size_t stride = std::size_t(columns) * std::size_t(size) * 4;
  Sheet sheet{columns * size, rows * size, std::vector<float>(stride * std::size_t(rows * size), 1.0f)};
  Progress progress("drawing the catalogue", count);
  for (int n = 0; n < count; ++n) {
    const CatalogueSurface& surface = surfaces[static_cast<std::size_t>(n)];
    const Scene scene = scene_of(surface, wishes).scene;
    const View view(frame(scene.bounds(), {}, 1), size, size);
    Film film(size, size, {});
    render(scene, view, {}, film, interrupt_token());
    float* const tile =
        &sheet.rgba[std::size_t(n / columns * size) * stride + std::size_t(n % columns * size) * 4];
    for (int y = 0; y < size; ++y)
      std::copy_n(film.color(static_cast<std::uint32_t>(y * size)), size * 4, tile + std::size_t(y) * stride);
    write_label(surface.id, size, tile, stride);
    progress.add();
  }
  return sheet;
}

}  // namespace isocast
