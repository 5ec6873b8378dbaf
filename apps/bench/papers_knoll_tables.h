// What Knoll et al. (Computer Graphics Forum 28(1), 2009) printed: frames of 1024 x 1024 a second at eps
// 2^-11; four Xeon cores at 2.33 GHz with SSE, and an NVidia 8800 GTX.
#pragma once

#include <limits>
#include <string_view>

namespace isocast::bench {

inline constexpr const char* kKnollSource =
    "Knoll, Hijazi, Kensler, Schott, Hansen, Hagen: Fast ray tracing of arbitrary implicit surfaces with "
    "interval and affine arithmetic, Computer Graphics Forum 28(1), 2009";
inline constexpr const char* kKnollNotes[] = {
    "Set as in the paper: bounds rounded to the nearest, affine forms that only reject (trim=0), eps 2^-11 "
    "unless it says otherwise, float; interval=IA, affine=RAA. One ray a pixel, one thread, without shading. "
    "The "
    "paper's times are of four cores of 2008 and a graphics card, with shading, so only ratios compare.",
    "The paper takes the near end of a part of length eps in which the inclusion still holds 0 for the hit. "
    "isocast "
    "does not: it goes on until a change of sign is found, so its pictures are right at every eps, and the "
    "cost of loose bounds is all in the time. So there is no column of the largest eps with a right "
    "picture."};

inline constexpr double kNotPrinted = std::numeric_limits<double>::quiet_NaN();

/// quick: among the few. `converged` has arithmetic and eps of the last column.
struct SurfaceOfKnoll {
  std::string_view name, id;
  double cpu_ia, gpu_ia, gpu_raa;
  std::string_view converged;
  bool quick = false;
};
inline constexpr SurfaceOfKnoll kKnollSurfaces[] = {
    {"Sphere", "sphere", 15, 75, 147, "165, RAA, 2⁻¹⁰"},
    {"Steiner", "steiner", 7.5, 34, 40, "38, RAA, 2⁻¹²"},
    {"Mitchell", "mitchell", 5.2, 16, 58, "60, RAA, 2⁻¹⁰", true},
    {"Teardrop", "teardrop", 5.5, 102, 115, "121, RAA, 2⁻¹⁰", true},
    {"4-bretzel", "bretzel4", 13, 78, 48, "90, IA, 2⁻¹⁰"},
    {"Klein bottle", "klein_bottle", 11, 30, 110, "101, RAA, 2⁻¹²"},
    {"Tangle", "tangle", 3.2, 15, 68, "71, RAA, 2⁻¹⁰", true},
    {"Decocube", "decocube", 5.5, 28, 27, "28, IA, 2⁻¹¹"},
    {"Barth sextic", "barth_sextic", 7.4, 31, 76, "88, RAA, 2⁻¹⁰", true},
    {"Barth decic", "barth_decic", 0.92, 4.9, 15.6, "15.6, RAA, 2⁻¹¹", true},
    {"Superquadric", "superquadric_knoll", 18, 119, 8.3, "108, IA, 2⁻¹²", true},
    {"icos.csg", "icos_csg", 1.8, 13.3, kNotPrinted, "13.3, IA, 2⁻¹¹"},
    {"sesc.csg", "sesc_csg", 1.6, 8.9, kNotPrinted, "7.2, IA, 2⁻¹³"},
    {"sin.blob", "sin_blob", 0.71, 6.0, kNotPrinted, "6.0, IA, 2⁻¹²"},
    {"Cloth", "cloth", 2.2, 38, kNotPrinted, "44, IA, 2⁻⁹"},
    {"Water", "water", 2.2, 37, kNotPrinted, "44, IA, 2⁻⁹"},
};

/// Frames a second on the CPU: Mitchell's surface at 2^-11 and 2^-22, the decic at both.
struct AlgorithmOfKnoll {
  std::string_view name;
  double cpu[4], gpu[4];
};
inline constexpr AlgorithmOfKnoll kKnollAlgorithms[] = {
    {"t-bisection", {5.0, 1.0, 0.90, 0.061}, {16, 6.2, 4.9, 1.4}},
    {"K-bisection", {5.1, 1.2, 0.92, 0.18}, {11, 5.6, 4.4, 1.1}},
    {"Mitchell's method", {0.54, 0.22, 0.19, 0.036}, {3.9, 1.0, 1.1, 0.29}},
};

}  // namespace isocast::bench
