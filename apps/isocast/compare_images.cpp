#include <fmt/format.h>
#include <isocast/apps/bench/judge.h>
#include <isocast/apps/bench/rows.h>
#include <isocast/apps/isocast/compare_images.h>
#include <isocast/base/error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace isocast {
namespace {

constexpr std::size_t kMostListed = 10;

// The channels of a layer in both pictures.
class SharedLayer {
 public:
  // names, others: of its channels, plain and for compositors
  SharedLayer(const Image& a, const Image& b, std::vector<std::string> names,
              std::vector<std::string> others = {})
      : a_(a), b_(b), names_(std::move(names)) {
    for (std::size_t c = 0; c < names_.size(); ++c) {
      const auto find = [&](const Image& image) {
        const int plain = image.channel(names_[c]);
        return plain < 0 && !others.empty() ? image.channel(others[c]) : plain;
      };
      channels_.push_back({find(a), find(b)});
      in_a_ = in_a_ && channels_.back()[0] >= 0;
      in_b_ = in_b_ && channels_.back()[1] >= 0;
    }
  }
  [[nodiscard]] bool in_a() const { return in_a_; }
  [[nodiscard]] bool in_b() const { return in_b_; }
  [[nodiscard]] bool shared() const { return in_a_ && in_b_; }
  [[nodiscard]] std::size_t size() const { return channels_.size(); }
  [[nodiscard]] const std::string& name() const { return names_.front(); }
  // channel c of pixel (x, y) in a and in b
  [[nodiscard]] std::array<double, 2> at(int x, int y, std::size_t c) const {
    return {a_.at(x, y, channels_[c][0]), b_.at(x, y, channels_[c][1])};
  }

 private:
  const Image &a_, &b_;
  std::vector<std::string> names_;
  std::vector<std::array<int, 2>> channels_;
  bool in_a_ = true, in_b_ = true;
};

// |x - y|, 0 for the same infinity or NaN in both, +inf for NaN in one.
double difference(const std::array<double, 2>& values) {
  const auto [x, y] = values;
  if (x == y || (std::isnan(x) && std::isnan(y))) return 0;
  return std::isnan(x - y) ? std::numeric_limits<double>::infinity() : std::abs(x - y);
}
double largest_difference(const SharedLayer& layer, int x, int y) {
  double largest = 0;
  for (std::size_t c = 0; c < layer.size(); ++c) largest = std::max(largest, difference(layer.at(x, y, c)));
  return largest;
}
double differs(const SharedLayer& layer, int x, int y) { return largest_difference(layer, x, y) > 0; }
double angle(const SharedLayer& layer, int x, int y) {
  if (largest_difference(layer, x, y) == 0) return 0;
  Double3 normals[2];
  for (std::size_t c = 0; c < 3; ++c) {
    const auto both = layer.at(x, y, c);
    normals[0][c] = both[0], normals[1][c] = both[1];
  }
  const double degrees = bench::angle_in_degrees(normals[0], normals[1]);
  return std::isnan(degrees) ? std::numeric_limits<double>::infinity() : degrees;
}

MaskDifference compare_masks(const Image& a, const Image& b) {
  MaskDifference mask;
  for (const auto& [name, other] : {std::pair{"depth", "depth.Z"}, {"z", "Z"}, {"id", "id.X"}, {"A", "A"}}) {
    const SharedLayer layer(a, b, {name}, {other});
    if (!layer.shared()) continue;
    mask.by = name;
    const bool finite = mask.by == "depth" || mask.by == "z";
    for (int y = 0; y < a.height; ++y)
      for (int x = 0; x < a.width; ++x) {
        const auto values = layer.at(x, y, 0);
        const auto hit = [&](double value) { return finite ? std::isfinite(value) : value != 0; };
        const bool in_a = hit(values[0]), in_b = hit(values[1]);
        ++(in_a ? in_b ? mask.both : mask.only_a : in_b ? mask.only_b : mask.neither);
        if (in_a != in_b && mask.first.size() < kMostListed) mask.first.push_back({x, y, 0});
        mask.by_pixel.push_back({in_a, in_b});
      }
    break;
  }
  return mask;
}

LayerDifference summarized(std::string name, std::string unit, std::vector<PixelDifference> pixels, int width,
                           int height) {
  LayerDifference layer;
  layer.name = std::move(name), layer.unit = std::move(unit);
  layer.pixels = std::ssize(pixels);
  layer.by_pixel.resize(std::size_t(width) * std::size_t(height));
  std::vector<double> differences;
  for (const PixelDifference& pixel : pixels) {
    differences.push_back(pixel.difference);
    layer.by_pixel[std::size_t(pixel.y) * std::size_t(width) + std::size_t(pixel.x)] = pixel.difference;
  }
  layer.p50 = bench::quantile(differences, 0.5);
  layer.p90 = bench::quantile(differences, 0.9);
  layer.p99 = bench::quantile(differences, 0.99);
  layer.max = layer.largest = bench::quantile(std::move(differences), 1);
  const auto end = pixels.begin() + std::min(std::ssize(pixels), std::ptrdiff_t{kMostListed});
  std::ranges::partial_sort(pixels, end, std::ranges::greater(), &PixelDifference::difference);
  std::copy_if(pixels.begin(), end, std::back_inserter(layer.worst),
               [](const auto& pixel) { return pixel.difference > 0; });
  return layer;
}

}  // namespace

bool Comparison::within(double tolerance) const {
  return mask.only_a + mask.only_b == 0 && std::ranges::all_of(layers, [&](const auto& layer) {
           return !layer.decides || layer.largest <= tolerance;
         });
}

Comparison compare_images(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height)
    throw InputError(fmt::format("the pictures have {}x{} and {}x{} pixels, the same size was expected",
                                 a.width, a.height, b.width, b.height));
  Comparison comparison{a.width, a.height, compare_masks(a, b), {}};
  const auto& hit = comparison.mask.by_pixel;
  const auto add = [&](const char* name, const char* unit, const SharedLayer& layer, auto difference_at,
                       bool hits_only, bool decides = true) {
    if (layer.in_a() != layer.in_b()) (layer.in_a() ? comparison.only_a : comparison.only_b).push_back(name);
    if (!layer.shared()) return;
    std::vector<PixelDifference> pixels;
    for (int y = 0; y < a.height; ++y)
      for (int x = 0; x < a.width; ++x) {
        const std::size_t id = std::size_t(y) * std::size_t(a.width) + std::size_t(x);
        if (!hits_only || hit.empty() || (hit[id][0] && hit[id][1]))
          pixels.push_back({x, y, difference_at(layer, x, y)});
      }
    comparison.layers.push_back(summarized(name, unit, std::move(pixels), a.width, a.height));
    comparison.layers.back().decides = decides;
  };
  add("depth", "world units", {a, b, {"depth"}, {"depth.Z"}}, largest_difference, true);
  add("z", "world units", {a, b, {"z"}, {"Z"}}, largest_difference, true);
  add("normal", "degrees", {a, b, {"normal.X", "normal.Y", "normal.Z"}, {"N.X", "N.Y", "N.Z"}}, angle, true);
  add("color", "linear", {a, b, {"R", "G", "B", "A"}}, largest_difference, false);
  add("position", "world units", {a, b, {"position.X", "position.Y", "position.Z"}, {"P.X", "P.Y", "P.Z"}},
      largest_difference, true);
  add("value", "field", {a, b, {"value"}, {"value.X"}}, largest_difference, true);
  add("albedo", "linear", {a, b, {"albedo.R", "albedo.G", "albedo.B"}}, largest_difference, true);
  add("id", "differs", {a, b, {"id"}, {"id.X"}}, differs, true);
  add("object", "differs", {a, b, {"object"}, {"object.X"}}, differs, true);
  add("certificate", "steps", {a, b, {"certificate"}, {"certificate.X"}}, largest_difference, false, false);
  add("cost", "units", {a, b, {"cost"}, {"cost.X"}}, largest_difference, false, false);
  if (comparison.layers.empty())
    throw InputError(
        "the pictures share none of the layers of 'render --aov' and no colour (R G B A), one was expected");
  for (LayerDifference& layer : comparison.layers)
    if (layer.name == "normal") layer.largest *= std::numbers::pi / 180;
  return comparison;
}

std::vector<float> difference_picture(const Comparison& comparison) {
  constexpr double kDecades = 4;
  const LayerDifference& layer = comparison.layers.front();
  std::vector<float> picture;
  for (std::size_t i = 0; i < layer.by_pixel.size(); ++i) {
    const double difference = layer.by_pixel[i],
                 share = difference < layer.max ? 1 + std::log10(difference / layer.max) / kDecades
                                                : difference > 0;
    const auto grey = static_cast<float>(std::max(0.0, share));
    const auto [in_a, in_b] =
        comparison.mask.by_pixel.empty() ? std::array{true, true} : comparison.mask.by_pixel[i];
    const bool differs = in_a != in_b;
    for (const float channel :
         {differs ? float(in_a) : grey, differs ? 0 : grey, differs ? float(in_b) : grey, 1.0f})
      picture.push_back(channel);
  }
  return picture;
}

}  // namespace isocast
