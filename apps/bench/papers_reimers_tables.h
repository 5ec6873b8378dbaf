// What Reimers and Seland (Computer Graphics Forum 27(2), 2008) printed: 512 x 512 rays, eps 5e-4, an Athlon
// 4200+ and an NVidia 8800 GTX; coefficients in double, roots in float.
#pragma once

#include <string_view>

namespace isocast::bench {

inline constexpr const char* kReimersSource =
    "Reimers, Seland: Ray casting algebraic surfaces using the frustum form, Computer Graphics Forum 27(2), "
    "2008";
inline constexpr const char* kReimersNotes[] = {
    "Set as in the paper: eps 5e-4, forms in double, rays' polynomials and roots in float, nothing proved "
    "(certify=0), a field of view of 45 degrees. One thread, one ray a pixel; times are of the whole pass "
    "over "
    "primary rays, forms and roots, without shading. The paper's are of a processor and a graphics card of "
    "2007, so only ratios compare. Its cameras are not printed; the default camera looks here.",
    "isocast makes a form for each block of some tiles and divides it down to tiles, where the paper makes "
    "one "
    "for the whole frustum, and cuts each ray to the domain: searches begin on shorter pieces than the "
    "paper's. "
    "eps is a share of a block's depth. One subdivision at a point counts as d knots, as in the paper; knots "
    "are "
    "means over all rays that MR, in double at 1e-8, needs a step for. MR's density asks for d - 1 knots "
    "near "
    "the root, so that squaring eps takes about that many more: R-REI-2 counts them in such rounds.",
    "Errors of T-REI-2 are differences in depth, with 0 at the near and 1 at the far end of the domain, to "
    "MR "
    "in double at eps 1e-8, as in the paper. Rays that fail are counted against the exact reference, on one "
    "ray in 61; the others count among undecided_reference. K is the largest Bernstein coefficient of the "
    "one "
    "form of the whole frustum, between the nearest and the farthest depth of the domain.",
    "Every search starts from the left, so that a lengthened step of the Mult methods that passes a root is "
    "no "
    "loss: it is one more knot, and the first change of sign is looked for again.",
    "The hull of the control polygon meets the axis first at the least of the crossings of all pairs of "
    "coefficients of different sign, which is where one-sided clipping cuts here; pairs with the first "
    "coefficient alone, as the hull is sometimes described, may cut a root off."};

/// Error of w (mean, largest), knot insertions a ray, milliseconds a frame.
struct FinderOfReimers {
  double mean, max, its, ms;
};
/// lr, lr_mult, mr, mr_mult  as frustum-*
/// error_mean, _max          |f| over K
/// shares                    of a frame's time, per cent: CPU, ray coefficients, roots, shading
struct SurfaceOfReimers {
  std::string_view name, id;
  int degree;
  double error_mean, error_max;
  FinderOfReimers lr, lr_mult, mr, mr_mult;
  double fps;
  int shares[4];
  bool quick = false;
};
inline constexpr SurfaceOfReimers kReimersSurfaces[] = {
    {"Cayley",
     "cayley",
     3,
     1.2e-7,
     1.5e-6,
     {9.7e-8, 2.0e-4, 11.2, 5.1},
     {8.8e-8, 1.2e-4, 11.1, 5.1},
     {5.2e-8, 1.5e-4, 4.8, 5.3},
     {6.3e-8, 3.4e-5, 4.7, 5.4},
     141,
     {2, 16, 66, 16},
     true},
    {"Klebsch",
     "clebsch",
     3,
     2.3e-7,
     4.7e-6,
     {1.1e-7, 2.7e-4, 11.7, 5.4},
     {5.3e-6, 1.5e-1, 12.2, 5.7},
     {6.6e-8, 1.8e-4, 5.1, 5.3},
     {5.5e-7, 6.2e-2, 5.3, 6.0},
     128,
     {2, 11, 72, 15}},
    {"Tangle",
     "tangle",
     4,
     2.3e-7,
     4.7e-6,
     {2.5e-7, 2.3e-4, 21.8, 9.4},
     {1.5e-4, 5.1e-1, 21.5, 10.7},
     {1.3e-7, 1.2e-4, 9.7, 12.6},
     {5.9e-5, 4.9e-1, 9.4, 14.7},
     87,
     {4, 13, 74, 9},
     true},
    {"Kiss",
     "kiss",
     5,
     2.7e-7,
     1.2e-5,
     {2.7e-6, 3.4e-1, 21.2, 10.0},
     {2.7e-6, 3.4e-1, 19.9, 8.7},
     {1.3e-6, 3.3e-1, 9.7, 15.4},
     {1.7e-5, 4.8e-1, 9.0, 14.5},
     74,
     {6, 15, 73, 6},
     true},
    {"Klein",
     "klein_bottle",
     6,
     2.4e-6,
     1.9e-5,
     {2.1e-7, 1.8e-4, 32.4, 16.0},
     {3.7e-5, 2.3e-1, 29.8, 14.3},
     {9.6e-8, 4.7e-5, 14.5, 22.7},
     {1.6e-5, 2.4e-1, 12.6, 23.8},
     60,
     {10, 16, 69, 5}},
    {"Heart",
     "heart_taubin",
     6,
     4.3e-9,
     5.6e-8,
     {1.6e-5, 7.0e-2, 34.6, 17.6},
     {1.1e-4, 3.6e-2, 33.8, 16.2},
     {6.3e-6, 2.9e-2, 15.6, 26.6},
     {5.5e-5, 2.9e-2, 14.4, 28.2},
     45,
     {7, 12, 76, 5},
     true},
    {"Linked tori",
     "linked_tori",
     8,
     3.4e-8,
     2.9e-7,
     {3.7e-7, 1.4e-4, 53.7, 29.0},
     {2.2e-5, 3.2e-1, 51.6, 28.1},
     {2.0e-7, 1.2e-4, 23.1, 48.7},
     {1.8e-5, 3.0e-1, 21.1, 51.4},
     33,
     {17, 17, 64, 2}},
    {"Decic",
     "barth_decic",
     10,
     3.5e-9,
     7.3e-7,
     {7.8e-5, 7.3e-1, 69.5, 55.5},
     {2.9e-3, 8.5e-1, 62.9, 49.1},
     {2.2e-5, 7.3e-1, 35.6, 124.2},
     {2.3e-3, 8.7e-1, 31.3, 139.5},
     12,
     {21, 12, 66, 1},
     true},
    {"Super-sphere",
     "super_sphere_16",
     16,
     7.2e-9,
     2.9e-7,
     {1.5e-5, 3.6e-3, 103.5, 77.0},
     {1.0e-5, 5.4e-3, 98.9, 79.0},
     {9.9e-6, 3.6e-3, 51.9, 185.6},
     {9.9e-6, 3.6e-3, 48.7, 231.4},
     3.1,
     {64, 14, 21, 1},
     true},
};

}  // namespace isocast::bench
