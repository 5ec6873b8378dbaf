// What Singh and Narayanan (IEEE TVCG 16(2), 2010) printed: frames a second of an NVidia 280 GTX, single
// precision, without shadows.
#pragma once

#include <string_view>

namespace isocast::bench {

inline constexpr const char* kSinghSource =
    "Singh, Narayanan: Real-time ray tracing of implicit surfaces on the GPU, IEEE Transactions on "
    "Visualization and Computer Graphics 16(2), 2010";
inline constexpr const char* kSinghNotes[] = {
    "Base steps as printed, ten bisections, float; tau is printed for the Chmutov octic only, elsewhere "
    "isocast's "
    "defaults. One ray a pixel, one thread, without shading: the paper's times are of a graphics card, so "
    "only "
    "ratios compare. Its columns with shadows are left out: the bench times primary rays.",
    "isocast recognises Chebyshev polynomials however they are written and runs them by the recurrence, so "
    "the "
    "power form's breakdown beyond order 18 does not occur, and the rows of the sinusoidal form have no "
    "figures "
    "of ours."};

/// 512 x 512, frames a second. `id` is empty where isocast has no such form; quick: among the few.
struct SurfaceOfSingh {
  std::string_view name, id;
  double step, sign, taylor;
  bool quick = false;
};
inline constexpr SurfaceOfSingh kSinghSurfaces[] = {
    {"Chmutov [50]", "chmutov_50", 0.01, 65, 41},
    {"Chmutov [22]", "chmutov_22", 0.01, 160, 113},
    {"Chmutov [18]", "chmutov_18", 0.01, 344, 194},
    {"Chmutov [14]", "chmutov_14", 0.01, 457, 262},
    {"Chmutov [12]", "chmutov_12", 0.01, 462, 280},
    {"Sarti [12]", "sarti_dodecic", 0.015, 380, 200},
    {"Barth [10]", "barth_decic", 0.015, 573, 286, true},
    {"Chmutov [9]", "chmutov_9", 0.015, 521, 334},
    {"Endrass [8]", "endrass_octic", 0.01, 244, 215},
    {"Nonisol [8]", "nonisol", 0.01, 1035, 548},
    {"Chmutov [8]", "chmutov_8", 0.02, 1053, 622, true},
    {"Chmutov [7]", "chmutov_7", 0.02, 787, 545},
    {"Labs [7]", "labs_septic", 0.015, 595, 311},
    {"Chmutov [6]", "chmutov_6", 0.02, 1289, 717},
    {"Hunt [6]", "hunt", 0.01, 152, 78},
    {"Barth [6]", "barth_sextic", 0.02, 836, 557, true},
    {"Heart [6]", "heart_nordstrand", 0.02, 840, 477},
    {"Kleine [6]", "klein_bottle", 0.02, 1024, 633},
    {"High Silhouette [6]", "high_silhouette", 0.02, 1143, 655, true},
    {"Dervish [5]", "dervish", 0.02, 814, 466},
    {"Kiss [5]", "kiss", 0.02, 1297, 774},
    {"Peninsula [5]", "peninsula", 0.03, 1349, 832},
    {"Steiner [4]", "steiner_singh", 0.02, 1210, 678, true},
    {"Cassini [4]", "cassini", 0.02, 1147, 699},
    {"Tooth [4]", "tooth", 0.03, 1500, 871},
    {"Piriform [4]", "piriform", 0.02, 1450, 831},
    {"Cross-Cap [4]", "cross_cap", 0.02, 1200, 606, true},
    {"Miter [4]", "miter", 0.02, 1660, 891},
    {"Kummer [4]", "kummer", 0.02, 1400, 823},
    {"Goursat [4]", "goursat", 0.04, 1700, 1014},
    {"Cushion [4]", "cushion", 0.02, 880, 460},
    {"Nordstrands [4]", "nordstrand", 0.03, 945, 596},
    {"Cayley [3]", "cayley_affine", 0.03, 1519, 844},
    {"Clebsch [3]", "clebsch", 0.03, 940, 633},
    {"Ding-Dong [3]", "ding_dong", 0.03, 1924, 1188},
    {"Chmutov 50, sinusoidal", "", 0.01, 207, 145},
    {"Chmutov 22, sinusoidal", "", 0.01, 217, 152},
    {"Chmutov 18, sinusoidal", "", 0.01, 244, 171},
    {"Chmutov 14, sinusoidal", "", 0.01, 254, 178},
    {"Torus", "torus_sqrt", 0.04, 1650, 922},
    {"Superquadric", "superquadric", 0.02, 900, 394},
    {"Blobby", "blobby", 0.05, 1226, 780},
    {"Blinn's Blobby", "blinn_blobby_5", 0.05, 1304, 691},
    {"Scherk", "scherk", 0.03, 1112, 718},
    {"Diamond", "diamond", 0.04, 1300, 983, true},
};

/// 1024 x 1024, frames a second: Knoll's method and the sign test on the 8800 GTX. The step is that of the
/// first table; the two surfaces that are not there get 0.02.
struct PairOfSingh {
  std::string_view name, id;
  double knoll, sign, step;
};
inline constexpr PairOfSingh kSinghPairs[] = {
    {"Steiner", "steiner", 38, 233, 0.02},
    {"Teardrop", "teardrop", 121, 195, 0.02},
    {"Tangle", "tangle", 71, 216, 0.02},
    {"Barth sextic", "barth_sextic", 88, 132, 0.02},
    {"Kleine", "klein_bottle", 101, 187, 0.02},
    {"Mitchell", "mitchell", 60, 194, 0.02},
    {"Barth decic", "barth_decic", 16, 103, 0.015},
    {"Superquadric", "superquadric_knoll", 108, 170, 0.02},
};

/// 512 x 512, sign test, milliseconds a frame.
struct FrameOfSingh {
  std::string_view name, id;
  double cpu, gpu;
};
inline constexpr FrameOfSingh kSinghFrames[] = {
    {"Ding Dong [3]", "ding_dong", 987, 0.52},
    {"Nordstrands [4]", "nordstrand", 3160, 1.05},
    {"Torus [4]", "torus_sqrt", 2674, 0.60},
    {"Dervish [5]", "dervish", 4152, 1.23},
    {"Kiss [5]", "kiss", 3647, 0.77},
    {"Chmutov [6]", "chmutov_6", 5371, 0.77},
    {"Heart [6]", "heart_nordstrand", 5027, 1.19},
    {"Chmutov [8]", "chmutov_8", 6853, 0.95},
    {"Barth [10]", "barth_decic", 7969, 1.75},
    {"Chmutov [18]", "chmutov_18", 9562, 2.90},
    {"Chmutov 50", "chmutov_50", 27875, 4.83},
};

/// Figure 9, frames a second: the decic over the step, the octic over tau1 (tau2 is twice, tau3 half of it).
struct PointOfSingh {
  double value, frames;
};
inline constexpr PointOfSingh kDecicSteps[] = {{0.015, 573}, {0.025, 601}, {0.045, 663}, {0.085, 806}};
inline constexpr PointOfSingh kOcticTaus[] = {
    {0.01, 1053}, {0.009, 1160}, {0.007, 1411}, {0.0065, 1481}, {0.006, 1555}};

}  // namespace isocast::bench
