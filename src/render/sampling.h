// Where samples lie: in pixels, and in any unit square.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace isocast {

struct UnitPoint {
  double u, v;
};

/// Point `index` of Sobol's sequence in [0, 1)^2, its digits scrambled in nested order: of the first 2^m
/// points every dyadic rectangle of area 2^-m holds one. Other seeds give other such sequences; the same
/// everywhere.
///
/// source  Owen: Randomly permuted (t,m,s)-nets and (t,s)-sequences, 1995; by a hash, as in Laine, Karras:
///         Stratified sampling for stochastic transparency, EGSR 2011
[[nodiscard]] UnitPoint scrambled_sobol(std::uint32_t index, std::uint32_t seed_u, std::uint32_t seed_v);
/// A seed for each number.
[[nodiscard]] std::uint32_t seed_of(std::uint32_t number);

/// How what lies around a pixel's centre counts for its colour: alike in the pixel; falling to 0 one pixel
/// from its centre; normal with a standard deviation of half a pixel, cut off at 1.5; Blackman's window of
/// radius 1.5.
enum class PixelFilter : std::uint8_t { box, triangle, gaussian, blackman };
/// Throws InputError for an unknown name.
[[nodiscard]] PixelFilter filter_from_name(std::string_view name);

/// A sample of pixel (x, y) lies at (x + columns + u, y + rows + v), u and v in [0, 1).
struct PixelSample {
  int columns, rows;
  double u, v;
};

/// The first samples of every pixel, all of the same weight: their density is the filter. The first is the
/// centre. They are the same for all pixels, so a pass finds one sample of a whole picture, and their order
/// does not depend on `count`. RMS error of edges with a box: 0.094 with 4, 0.035 with 16, 0.0127 with 64.
///
/// source  filters as densities: Ernst, Stamminger, Greiner: Filter importance sampling, Interactive Ray
///         Tracing 2006
[[nodiscard]] std::vector<PixelSample> pixel_samples(int count, PixelFilter filter);

}  // namespace isocast
