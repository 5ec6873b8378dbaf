// What a block of the picture asks of the frustum kernels, and what they answer tile by tile.
#pragma once

#include <isocast/implicit/expression/instruction.h>
#include <isocast/implicit/frustum/finder.h>
#include <isocast/implicit/solve/segment.h>
#include <isocast/ray/pixel_lines.h>

namespace isocast {

/// Matrices of one degree, row-major (degree + 1) x (degree + 1) unless said otherwise.
///
/// points       Chebyshev's in [0, 1]
/// from_values  their values to Bernstein coefficients
/// at_checks    (checks + 1) x (degree + 1): Bernstein values at the points of the degree `checks`
/// halves       coefficients over [0, 1/2] and [1/2, 1]
struct DegreeTables {
  int degree;
  const double *points, *from_values, *at_checks, *halves[2];
};

/// f along all rays of some tiles of a block between two depths, as a polynomial.
///
/// tiles       on a side: a power of two
/// degree      of f, in all
/// across, along  degrees of its form over the block: in u and v, and in depth
/// checks      where f is compared with its form: the points of degree `degree`, in each direction; a factor
///             of `lebesgue` per direction then bounds it between them. null: nothing is proved
/// rounding    how far f as it is evaluated in the block can be from f
/// slack       what the roundings of a ray's points can change f by
/// weights     [i][x]: Bernstein values across at the 16 pixel positions of a tile, x + the sample's offset
/// slopes      what they gain per pixel there; with `normals`, which asks for those of the form at the roots
/// lines       of the picture; u0, v0: their corner in pixels; s0, s1: its depths
/// lo, hi      the domain
/// redo        rays whose roots could not be proved are solved again in the precision of their polynomials
struct FrustumQuery {
  TapeView tape;
  double time, iso[kMostIsos];
  int iso_count, degree, tiles;
  DegreeTables across, along;
  const double* check_points;
  double lebesgue, rounding, slack;
  double weights_u[kMostFormDegree + 1][16], weights_v[kMostFormDegree + 1][16];
  double slopes_u[kMostFormDegree + 1][16], slopes_v[kMostFormDegree + 1][16];
  FinderOptions finder;
  bool redo, normals;
  PixelLines lines;
  double u0, v0, s0, s1, offset_u, offset_v;
  double lo[3], hi[3];
};

/// Roots of a tile's rays in View::fill's order: depth s with its bracket. proved: the hit, or where `hit` is
/// not set that there is none. length: the ray's in world space, of depth 1. normal, of hits, where asked
/// for: x and y of the unit normal in world space with z >= 0; NaN where the form's gradient vanishes.
struct TileRoots {
  double s[kStreamSize], lo[kStreamSize], hi[kStreamSize], length[kStreamSize];
  double normal[2][kStreamSize];
  std::uint32_t sides[kStreamSize];
  float steps[kStreamSize];
  std::uint8_t iso[kStreamSize];
  bool hit[kStreamSize], proved[kStreamSize];
};

/// Work of a block: evaluations of f, rays whose polynomials were searched.
struct FrustumCounts {
  std::int64_t evaluations = 0, solves = 0;
};

}  // namespace isocast
