// From a film to what a screen shows.
#pragma once

#include <isocast/apps/viewer/wish.h>

#include <array>

namespace isocast::viewer {

/// The layers that an overlay needs.
[[nodiscard]] std::vector<Layer> layers_of(Overlay overlay);

/// RGBA of 8 bits (sRGB, opaque), with the overlay of a layer that the film has mixed in: certificates green
/// (proved hit), blue (proved miss), red (undecided); costs from dark to bright, the dearest pixel white.
/// Overlay::error and difference change nothing.
[[nodiscard]] std::vector<std::uint8_t> screen_pixels(const Film& film, Overlay overlay);

/// A colour from black over violet and orange to white for x in [0, 1].
[[nodiscard]] std::array<std::uint8_t, 3> heat(double x);

}  // namespace isocast::viewer
