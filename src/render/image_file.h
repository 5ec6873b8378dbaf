// Pictures on disk: PNG to look at, EXR for the numbers. The first call opens the module with OpenImageIO.
#pragma once

#include <isocast/render/film.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isocast {

/// Channels interleaved in memory, rows from the top: {"R", "G", "B", "A"}, {"depth"}, {"normal.X", ...}.
struct ImageLayer {
  std::vector<std::string> channels;
  const float* data;
};

/// A picture that was read: all channels interleaved, rows from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::string> channels;
  std::vector<float> pixels;

  /// Where a channel lies in a pixel, or -1.
  [[nodiscard]] int channel(std::string_view name) const;
  [[nodiscard]] float at(int x, int y, int channel) const {
    return pixels[(std::size_t(y) * width + x) * channels.size() + channel];
  }
};

/// The 8-bit sRGB code nearest to a linear value; NaN gives 0, values outside [0, 1] the end.
[[nodiscard]] std::uint8_t srgb_code(float linear);

/// plain: `depth`, `normal.X normal.Y normal.Z`, `albedo.R albedo.G albedo.B` and so on. compositor: what
/// compositing programs look for: `Z` (OpenEXR's; along the view axis), `depth.Z`, `N.X N.Y N.Z` and
/// `P.X P.Y P.Z`; other layers of one channel are called X.
enum class ChannelNames : std::uint8_t { plain, compositor };

/// Colour as R G B A (when `color`), then every layer the film has. Points into the film.
[[nodiscard]] std::vector<ImageLayer> image_layers(const Film& film, bool color = true,
                                                   ChannelNames names = ChannelNames::plain);

/// What a file says of itself: names and texts.
using ImageNotes = std::vector<std::pair<std::string, std::string>>;

/// Linear RGBA, already composited over the background, as an opaque sRGB picture of 8 bits. The file holds
/// pixels only: the same pixels give the same bytes. Throws InputError when it cannot be written or this
/// build has no OpenImageIO.
void write_png(const std::filesystem::path& path, int width, int height, const float* rgba);

/// Every layer as 32-bit floats, losslessly compressed (ZIP), and the notes as attributes; otherwise like
/// write_png.
void write_exr(const std::filesystem::path& path, int width, int height,
               const std::vector<ImageLayer>& layers, const ImageNotes& notes = {});

/// Reads the first part of an EXR: flat, in scan lines, at most 32768 pixels a side and 64 channels. Throws
/// InputError.
[[nodiscard]] Image read_exr(const std::filesystem::path& path);

/// The same for a file that ends with .exr, .hdr, .png, .jpg or .jpeg, of at most 2^27 pixels, with linear
/// values: the samples of the last three are sRGB codes.
[[nodiscard]] Image read_image(const std::filesystem::path& path);

}  // namespace isocast
