// Where formula methods leave more rays undecided than they should.
#pragma once

#include <algorithm>
#include <iterator>
#include <string_view>

namespace isocast::test {

/// The largest share of aimed rays, in percent, in float and in double, with an eps-rel of 2^-16.
struct UndecidedShare {
  std::string_view id;
  double single, precise;
};

/// What affine and interval are to reach on smooth surfaces.
inline constexpr double kAffineShare = 0.1, kIntervalShare = 1;

inline constexpr UndecidedShare kOfAnySurface = {"", 0, 0};

/// The largest shares where they are larger. labs_septic and the octics: products of seven and eight planes,
/// whose roundings in float hide sides near edges. high_silhouette and nonisol: sheets that touch or nearly
/// do, which no arithmetic tells apart at its resolution; sarti_dodecic: a difference of products so large
/// that roundings hide its sign; trilinear_cell: aimed rays often leave the box in the surface.
inline constexpr UndecidedShare kExceptions[] = {
    {"labs_septic", 0.6, 0},    {"endrass_octic", 0.4, 0}, {"endrass_octic_plus", 0.8, 0},
    {"high_silhouette", 12, 6}, {"nonisol", 14, 6},        {"sarti_dodecic", 60, 3},
    {"trilinear_cell", 4, 1},
};

inline const UndecidedShare& undecided_share(std::string_view id) {
  const auto found = std::ranges::find(kExceptions, id, &UndecidedShare::id);
  return found == std::end(kExceptions) ? kOfAnySurface : *found;
}

}  // namespace isocast::test
