#include <fmt/format.h>
#include <isocast/apps/bench/small_picture.h>
#include <isocast/base/module.h>
#include <isocast/render/image_module.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isocast::bench {
namespace {

// Even steps of lightness, from black over blue and green to a pale mint.
constexpr Rgb kSteps[] = {{11, 4, 5},     {46, 30, 60},   {65, 61, 123},   {55, 101, 158},
                          {52, 143, 167}, {64, 183, 173}, {138, 217, 177}, {222, 245, 229}};
constexpr Rgb kNothing = {236, 232, 225};

// Between two colours, share from 0 to 1.
Rgb mixed(const Rgb& a, const Rgb& b, double share) {
  Rgb color;
  for (std::size_t k = 0; k < 3; ++k)
    color[k] = static_cast<std::uint8_t>(std::lround((1 - share) * a[k] + share * b[k]));
  return color;
}

}  // namespace

SmallPicture picture_of_truth(const PictureTruth& truth, const std::vector<RayStream>& rays, int width) {
  SmallPicture picture{width, static_cast<int>(truth.rays.size()) / width,
                       std::vector<Rgb>(truth.rays.size(), kNothing)};
  // directions of primary rays have unit length, so that t is depth
  double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (const reference::RayTruth& ray : truth.rays)
    if (const reference::RayRoot* const first = first_crossing(ray)) {
      nearest = std::min(nearest, middle(*first));
      farthest = std::max(farthest, middle(*first));
    }
  constexpr Rgb kDark = {38, 34, 48}, kLight = {250, 214, 158};
  each_ray(rays, [&](std::size_t s, int i) {
    const std::size_t pixel = rays[s].id[i];
    const reference::RayRoot* const first = first_crossing(truth.rays[pixel]);
    if (!first) return;
    const double depth = farthest > nearest ? (middle(*first) - nearest) / (farthest - nearest) : 0;
    const Double3& normal = truth.normals[pixel];
    const double facing = std::abs(dot(normal, {rays[s].dx[i], rays[s].dy[i], rays[s].dz[i]}));
    picture.pixels[pixel] = mixed(kDark, kLight, (0.25 + 0.75 * facing) * (1 - 0.55 * depth));
  });
  for (std::size_t pixel = 0; pixel < truth.rays.size(); ++pixel)
    if (!truth.rays[pixel].decided()) picture.pixels[pixel] = verdict_color(Verdict::unknown);
  return picture;
}

SmallPicture picture_of_errors(std::span<const PixelAnswer> answers, int width) {
  SmallPicture picture{width, static_cast<int>(answers.size()) / width, {}};
  for (const PixelAnswer& answer : answers)
    picture.pixels.push_back(answer.verdict == Verdict::hit ? error_color(answer.t_error)
                                                            : verdict_color(answer.verdict));
  return picture;
}

Rgb error_color(double error) {
  constexpr double kLast = std::size(kSteps) - 1;
  const double share = (std::log10(error) - kLeastError) / (kLargestError - kLeastError),
               place = std::clamp(share, 0.0, 1.0) * kLast;
  const auto step = static_cast<std::size_t>(std::min(place, kLast - 1));
  return mixed(kSteps[step], kSteps[step + 1], place - static_cast<double>(step));
}

Rgb verdict_color(Verdict verdict) {
  switch (verdict) {
    case Verdict::miss: return kNothing;
    case Verdict::undecided: return {255, 150, 0};
    case Verdict::unknown: return {150, 150, 155};
    default: return {255, 0, 70};
  }
}

std::string hex_of(const Rgb& color) {
  return fmt::format("#{:02x}{:02x}{:02x}", color[0], color[1], color[2]);
}

std::string png_data_url(const SmallPicture& picture) {
  const auto& module = module_table<ImageModule>("image", "the pictures of report.html");
  return "data:image/png;base64," + base64(module.encode_png("report.html", picture.width, picture.height,
                                                             picture.pixels.front().data()));
}

std::string base64(std::string_view bytes) {
  static constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kLetters[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace isocast::bench
