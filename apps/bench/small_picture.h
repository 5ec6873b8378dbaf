// The small pictures of the report: what is right, and how wrong a method is.
#pragma once

#include <isocast/apps/bench/picture_truth.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace isocast::bench {

using Rgb = std::array<std::uint8_t, 3>;

/// Rows from the top, sRGB.
struct SmallPicture {
  int width = 0, height = 0;
  std::vector<Rgb> pixels;
};

/// What every pixel's first crossing looks like: darker with depth and where it is seen askew.
[[nodiscard]] SmallPicture picture_of_truth(const PictureTruth& truth, const std::vector<RayStream>& rays,
                                            int width);

/// Errors of hits from dark (10^kLeastError units and less) to light (10^kLargestError and more); other
/// pixels by their verdict.
inline constexpr int kLeastError = -9, kLargestError = -1;
[[nodiscard]] SmallPicture picture_of_errors(std::span<const PixelAnswer> answers, int width);

/// Of an error in units; 0 is the darkest.
[[nodiscard]] Rgb error_color(double error);
/// Of pixels without an error of t.
[[nodiscard]] Rgb verdict_color(Verdict verdict);
/// "#rrggbb".
[[nodiscard]] std::string hex_of(const Rgb& color);

/// The picture as "data:image/png;base64,...". Throws InputError where this build has no OpenImageIO.
[[nodiscard]] std::string png_data_url(const SmallPicture& picture);

/// RFC 4648, padded.
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace isocast::bench
