#include <isocast/apps/bench/judge.h>
#include <isocast/apps/reference/scene_reference.h>
#include <isocast/apps/scene_build/applicable_methods.h>
#include <isocast/apps/viewer/extras.h>
#include <isocast/apps/viewer/make_picture.h>
#include <isocast/apps/viewer/pixel_ray.h>
#include <isocast/base/error.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isocast::viewer {
namespace {

using reference::RayReference;
using reference::RayTruth;

struct TrueRay {
  RayTruth truth;
  double units_per_t;
};

// What is true of the rays to an object.
class Truth {
 public:
  explicit Truth(const LoneObject& lone)
      : object_(lone.description.objects.front()),
        bounds_(lone.built.scene.bounds()),
        reference_(reference::make_reference(lone.description, lone.built)) {}

  [[nodiscard]] bool empty() const { return bounds_.empty(); }
  [[nodiscard]] TrueRay at(const View& view, int x, int y) const {
    const PixelRay world = pixel_ray(view, x, y), ray = reference_ray(world, object_);
    const double reach = length(bounds_.center() - world.o) + bounds_.diagonal();
    return {reference_->solve(ray.o, ray.d, 0, reach), length(ray.d) / reference_->unit()};
  }

 private:
  const ObjectDescription& object_;
  Box bounds_;
  std::unique_ptr<RayReference> reference_;
};

// How a depth compares with the truth, in units; NaN: not known; infinite: one of them hits and the other
// does not.
double error_of(const TrueRay& ray, double depth) {
  if (!ray.truth.decided()) return std::nan("");
  const reference::RayRoot* const first = bench::first_crossing(ray.truth);
  const bool hit = std::isfinite(depth);
  if (!first && !hit) return 0;
  if (!first || !hit) return std::numeric_limits<double>::infinity();
  return std::abs(depth - bench::middle(*first)) * ray.units_per_t;
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

// Distances along the rays of the view.
std::vector<float> depths(const LoneObject& lone, const View& view, std::stop_token stop) {
  RenderSettings settings;
  settings.colors = false;
  Film film(view.width(), view.height(), {Layer::depth});
  render(lone.built.scene, view, settings, film, std::move(stop));
  return film.layer(Layer::depth);
}

}  // namespace

std::vector<std::uint8_t> other_picture(const JobScene& scene, std::size_t object,
                                        const std::string& method) {
  SceneKeeper& keeper = scene.keeper;
  const MethodRestorer restorer(keeper, object);
  keeper.built().objects[object].change_method(method, {}, evaluation_of(keeper.words()));
  Film film(scene.view.width(), scene.view.height(), {});
  render(keeper.built().scene, scene.view, settings_of(keeper.words(), keeper.description().wishes), film,
         scene.stop);
  return screen_pixels(film, Overlay::none);
}

void show_errors(const JobScene& scene, std::size_t object, const std::function<void(Picture)>& show) {
  const LoneObject lone = scene.keeper.alone(object);
  const Truth truth(lone);
  if (truth.empty()) return;
  const Film& film = *scene.picture.film;
  const std::vector<float> depth = depths(lone, scene.view, scene.stop);
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
        paint(picture.rgba, film, x, y, step, color_of(error_of(truth.at(scene.view, x, y), depth[pixel])));
      }
    });
    show(picture);
  }
}

void find_points(const JobScene& scene, std::size_t object,
                 const std::function<void(const std::vector<MethodPoint>&)>& show) {
  constexpr int kWidth = 160, kLattice = 16, kRuns = 3;
  SceneKeeper& keeper = scene.keeper;
  const int height = std::max(1, kWidth * scene.view.height() / scene.view.width());
  const View view(frame(keeper.built().scene.bounds(), keeper.description().camera,
                        double(scene.view.width()) / scene.view.height()),
                  kWidth, height);
  const LoneObject lone = keeper.alone(object);
  const Truth truth(lone);
  std::vector<std::pair<std::size_t, TrueRay>> rays;
  for (int i = 0; i < kLattice * kLattice && !truth.empty(); ++i) {
    if (scene.stop.stop_requested()) throw Interrupted();
    const int x = (2 * (i % kLattice) + 1) * kWidth / (2 * kLattice),
              y = (2 * (i / kLattice) + 1) * height / (2 * kLattice);
    rays.emplace_back(y * kWidth + x, truth.at(view, x, y));
  }
  const MethodRestorer restorer(keeper, object);
  std::vector<MethodPoint> points;
  for (const Method& method : applicable_methods(lone.description.objects.front())) {
    MethodPoint point{std::string(method.name), std::numeric_limits<double>::infinity(), 0, 0, 0};
    keeper.built().objects[object].change_method(point.method, {}, evaluation_of(keeper.words()));
    std::vector<float> depth;
    for (int run = 0; run < kRuns; ++run) {
      const Clock::time_point start = Clock::now();
      depth = depths(lone, view, scene.stop);
      point.ms_per_megaray = std::min(point.ms_per_megaray, ms_since(start) * 1e6 / (kWidth * height));
    }
    std::vector<double> errors;
    for (const auto& [pixel, ray] : rays) {
      const double error = error_of(ray, depth[pixel]);
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
