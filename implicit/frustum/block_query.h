// What a block of the picture asks of the frustum kernels, and what they answer tile by tile.
#pragma once

#include <isocast/implicit/expression/instruction.h>
#include <isocast/implicit/frustum/finder.h>
#include <isocast/implicit/solve/segment.h>
#include <isocast/ray/pixel_lines.h>

namespace isocast {

/// Matrices of one degree (collocation.h), row-major (degree + 1) x (degree + 1).
///
/// points       Chebyshev's in [0, 1]
/// from_values  their values to Bernstein coefficients
/// at_points    back
/// lebesgue     a factor that bounds a polynomial by its values at the points
struct DegreeTables {
  int degree;
  const double *points, *from_values, *at_points;
  double lebesgue;
};

/// The same for two variables, as padua.h has them, and `halves` of order kMostFormDegree + 1.
struct PlaneTables {
  const double *columns, *rows, *from_columns, *from_rows, *halves[2];
  double lebesgue;
};

/// f along all rays of some tiles of a block between two depths, as a polynomial.
///
/// tiles       on a side: a power of two
/// across, along  tables of f's degree in all: for u and v, and for depth
/// proves      whether misses and roots are to be proved
/// rounding    how far f as it is evaluated in the block can be from f
/// slack       what the roundings of a ray's points can change f by
/// weights     [i][x]: T_i across at the 16 pixel positions of a tile, x + the sample's offset
/// slopes      what they gain per pixel there; with `normals`, which asks for those of the form at the roots
/// lines       of the picture; u0, v0: their corner in pixels; s0, s1: its depths
/// lo, hi      the domain
/// redo        rays whose roots could not be proved are solved again in the precision of their polynomials
struct FrustumQuery {
  TapeView tape;
  double time, iso[kMostIsos];
  int iso_count, tiles;
  PlaneTables across;
  DegreeTables along;
  double rounding, slack;
  double weights_u[kMostFormDegree + 1][16], weights_v[kMostFormDegree + 1][16];
  double slopes_u[kMostFormDegree + 1][16], slopes_v[kMostFormDegree + 1][16];
  FinderOptions finder;
  bool proves, redo, normals;
  PixelLines lines;
  double u0, v0, s0, s1, offset_u, offset_v;
  double lo[3], hi[3];
};

/// Roots of a tile's 16 x 16 rays, row by row: depth s with its bracket. hit, proved: bit x of row y; proved:
/// the hit, or where `hit` is not set that there is none. length: the ray's in world space, of depth 1.
/// normal, of hits, where asked for: x and y of the unit normal in world space with z >= 0; NaN where the
/// form's gradient vanishes.
struct TileRoots {
  double s[16][16], lo[16][16], hi[16][16], length[16][16];
  double normal[2][16][16];
  std::uint32_t sides[16][16];
  float steps[16][16];
  std::uint8_t iso[16][16];
  std::uint32_t hit[16], proved[16];
};

/// Work of a block: evaluations of f, rays whose polynomials were searched.
struct FrustumCounts {
  std::int64_t evaluations = 0, solves = 0;
};

}  // namespace isocast
