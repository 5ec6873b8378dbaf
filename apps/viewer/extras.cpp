#include <isocast/apps/bench/judge.h>
#include <isocast/apps/reference/scene_reference.h>
#include <isocast/apps/scene_build/applicable_methods.h>
#include <isocast/apps/viewer/extras.h>
#include <isocast/apps/viewer/make_picture.h>
#include <isocast/base/error.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isocast::viewer {
namespace {

using reference::RayReference;
using reference::RayTruth;

// The ray through the middle of a pixel and what is true of it.
struct TrueRay {
  Double3 o, d;
  RayTruth truth;
};
TrueRay true_ray(const RayReference& truth, const View& view, const Box& bounds, int x, int y) {
  const PixelLines lines = view.lines();
  TrueRay ray;
  for (int a = 0; a < 3; ++a) {
    ray.o[a] = lines.o[a] + (x + 0.5) * lines.o_u[a] + (y + 0.5) * lines.o_v[a];
    ray.d[a] = lines.d[a] + (x + 0.5) * lines.d_u[a] + (y + 0.5) * lines.d_v[a];
  }
  ray.d = normalized(ray.d);
  ray.truth = truth.solve(ray.o, ray.d, 0, length(bounds.center() - ray.o) + bounds.diagonal());
  return ray;
}

// How a depth compares with the truth, in units; NaN: not known; infinite: one of them hits and the other
// does not.
double error_of(const TrueRay& ray, double depth, double unit) {
  if (!ray.truth.decided()) return std::nan("");
  const reference::RayRoot* const first = bench::first_crossing(ray.truth);
  const bool hit = std::isfinite(depth);
  if (!first && !hit) return 0;
  if (!first || !hit) return std::numeric_limits<double>::infinity();
  return std::abs(depth - bench::middle(*first)) / unit;
}

std::array<std::uint8_t, 3> color_of(double error) {
  if (std::isnan(error)) return {128, 128, 128};
  if (std::isinf(error)) return {230, 20, 20};
  constexpr double kDigits = 8;
  return error > 0 ? heat(1 + std::log10(error) / kDigits) : heat(0);
}

void paint(std::vector<std::uint8_t>& rgba, const Film& film, int x0, int y0, int size,
           const std::array<std::uint8_t, 3>& color) {
  for (int y = y0; y < std::min(y0 + size, film.height()); ++y)
    for (int x = x0; x < std::min(x0 + size, film.width()); ++x)
      for (std::size_t c = 0; c < 3; ++c)
        rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width()) +
                  static_cast<std::size_t>(x)) +
             c] = color[c];
}

Film depths(const JobScene& scene, const View& view, RenderCounts& counts) {
  RenderSettings settings;
  settings.colors = false;
  Film film(view.width(), view.height(), {Layer::depth});
  counts = render(scene.keeper.built().scene, view, settings, film, scene.stop);
  return film;
}

}  // namespace

std::vector<std::uint8_t> other_picture(const JobScene& scene, const std::string& method) {
  SceneKeeper& keeper = scene.keeper;
  const MethodRestorer restorer(keeper);
  keeper.built().objects.front().change_method(method, {}, evaluation_of(keeper.words()));
  Film film(scene.view.width(), scene.view.height(), {});
  render(keeper.built().scene, scene.view, settings_of(keeper.words(), keeper.description().wishes), film,
         scene.stop);
  return screen_pixels(film, Overlay::none);
}

void show_errors(const JobScene& scene, const std::function<void(Picture)>& show) {
  const auto truth = reference::make_reference(scene.keeper.description(), scene.keeper.built());
  const Box bounds = scene.keeper.built().scene.bounds();
  const Film& film = *scene.picture.film;
  const std::vector<float>& depth = film.layer(Layer::depth);
  if (bounds.empty() || depth.empty()) return;
  Picture picture = scene.picture;
  constexpr int kFirst = 16;
  for (int step = kFirst; step >= 1; step /= 2) {
    const int rows = (film.height() + step - 1) / step;
    oneapi::tbb::parallel_for(0, rows, [&](int row) {
      for (int x = 0; x < film.width(); x += step) {
        if (scene.stop.stop_requested()) throw Interrupted();
        const int y = row * step;
        if (step < kFirst && x % (2 * step) == 0 && y % (2 * step) == 0) continue;  // known already
        const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width()) +
                           static_cast<std::size_t>(x);
        const TrueRay ray = true_ray(*truth, scene.view, bounds, x, y);
        paint(picture.rgba, film, x, y, step, color_of(error_of(ray, depth[pixel], truth->unit())));
      }
    });
    show(picture);
  }
}

void find_points(const JobScene& scene, const std::function<void(const std::vector<MethodPoint>&)>& show) {
  constexpr int kWidth = 160, kLattice = 16, kRuns = 3;
  SceneKeeper& keeper = scene.keeper;
  const int height = std::max(1, kWidth * scene.view.height() / scene.view.width());
  const View view(frame(keeper.built().scene.bounds(), keeper.description().camera,
                        double(scene.view.width()) / scene.view.height()),
                  kWidth, height);
  const auto truth = reference::make_reference(keeper.description(), keeper.built());
  const Box bounds = keeper.built().scene.bounds();
  std::vector<std::pair<std::size_t, TrueRay>> rays;
  for (int i = 0; i < kLattice * kLattice && !bounds.empty(); ++i) {
    if (scene.stop.stop_requested()) throw Interrupted();
    const int x = (2 * (i % kLattice) + 1) * kWidth / (2 * kLattice),
              y = (2 * (i / kLattice) + 1) * height / (2 * kLattice);
    rays.emplace_back(y * kWidth + x, true_ray(*truth, view, bounds, x, y));
  }
  const MethodRestorer restorer(keeper);
  std::vector<MethodPoint> points;
  for (const Method& method : applicable_methods(keeper.description().objects.front())) {
    MethodPoint point{std::string(method.name), std::numeric_limits<double>::infinity(), 0, 0, 0};
    keeper.built().objects.front().change_method(point.method, {}, evaluation_of(keeper.words()));
    RenderCounts counts;
    Film film(1, 1, {});
    for (int run = 0; run < kRuns; ++run) {
      const Clock::time_point start = Clock::now();
      film = depths(scene, view, counts);
      point.ms_per_megaray = std::min(point.ms_per_megaray, ms_since(start) * 1e6 / (kWidth * height));
    }
    std::vector<double> errors;
    for (const auto& [pixel, ray] : rays) {
      const double error = error_of(ray, film.layer(Layer::depth)[pixel], truth->unit());
      if (std::isnan(error)) continue;
      ++point.known;
      point.wrong += std::isinf(error);
      if (std::isfinite(error) && bench::first_crossing(ray.truth)) errors.push_back(error);
    }
    std::ranges::sort(errors);
    point.error = errors.empty() ? std::nan("") : errors[errors.size() / 2];
    points.push_back(point);
    show(points);
  }
}

}  // namespace isocast::viewer
