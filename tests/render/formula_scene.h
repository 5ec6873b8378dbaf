// Scenes of formulas, and pictures of one pixel: the ray through the middle of an orthographic view.
#pragma once

#include <isocast/implicit/expression/parse.h>
#include <isocast/implicit/implicit_surface.h>
#include <isocast/render/render.h>

#include <cmath>
#include <cstring>

namespace isocast::test {

/// f = iso in [-3, 3]^3.
inline std::shared_ptr<ImplicitSurface> formula_surface(const std::string& formula,
                                                        std::vector<double> iso = {0},
                                                        std::uint16_t object = 0, bool precise = true) {
  ImplicitSurfaceOptions options;
  options.iso = std::move(iso);
  options.method = choose_formula_method("affine", {});
  options.double_precision = precise;
  options.object = object;
  return std::make_shared<ImplicitSurface>(parse_expression(formula), Domain{{-3, -3, -3}, {3, 3, 3}},
                                           options);
}

/// Adds a formula's iso-surfaces as the next object.
inline void add_formula(Scene& scene, const std::string& formula, std::vector<Material> materials,
                        const std::vector<double>& iso = {0}) {
  const auto object = static_cast<std::uint16_t>(scene.objects.size());
  scene.objects.push_back({formula_surface(formula, iso, object), std::move(materials)});
}

/// An orthographic view from a point to another, `height` world units high.
inline View view_along(const Double3& from, const Double3& to, int size = 1, double height = 1) {
  Camera camera;
  camera.position = from;
  camera.target = to;
  camera.up = {0.1, 0.2, 1};
  camera.ortho_height = height;
  return View(camera, size, size);
}

struct Pixel {
  Color color;
  float alpha;
  RenderCounts counts;
};
inline Pixel pixel_along(const Scene& scene, const Double3& from, const Double3& to,
                         const RenderSettings& settings = {}) {
  Film film(1, 1, {});
  const RenderCounts counts = render(scene, view_along(from, to), settings, film);
  const float* c = film.color(0);
  return {{c[0], c[1], c[2]}, c[3], counts};
}

/// Colours alone.
inline Film picture(const Scene& scene, const View& view, const RenderSettings& settings,
                    RenderCounts* counts = nullptr) {
  Film film(view.width(), view.height(), {});
  const RenderCounts made = render(scene, view, settings, film);
  if (counts) *counts = made;
  return film;
}
/// Over all channels of all pixels.
inline double mean_difference(const Film& a, const Film& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.color().size(); ++i) sum += std::abs(a.color()[i] - b.color()[i]);
  return sum / static_cast<double>(a.color().size());
}

inline bool same_bytes(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0);
}
/// Colour and all layers.
inline bool same_films(const Film& a, const Film& b) {
  bool same = same_bytes(a.color(), b.color());
  for (int i = 0; i < kLayerCount; ++i)
    same = same && same_bytes(a.layer(static_cast<Layer>(i)), b.layer(static_cast<Layer>(i)));
  return same;
}

}  // namespace isocast::test
