// What Ganacim, Figueiredo and Nehab (SIBGRAPI 2011) printed: frames a second of an NVidia GTX 470.
#pragma once

#include <string_view>

namespace isocast::bench {

inline constexpr const char* kGanacimSource =
    "Ganacim, Figueiredo, Nehab: Beam casting implicit surfaces on the GPU with interval arithmetic, "
    "SIBGRAPI 2011";
inline constexpr const char* kGanacimNotes[] = {
    "The paper gives neither cameras nor its tolerance: here the camera frames the domain, and a pixel's eps "
    "is "
    "2^-10 of depth from -1 to 1. One thread, without shading: only ratios compare. Four samples a pixel are "
    "one level more of the quadtree, in both methods.",
    "The quadtree begins at blocks of 128 x 128 pixels, and a quarter begins with small parts of the depth "
    "that is left, both unlike the paper."};

/// Frames a second at one size: uniform and adaptive, with one sample a pixel and with four.
struct FramesOfGanacim {
  double uniform, adaptive, uniform_of_four, adaptive_of_four;
};
/// quick: among the few.
struct SurfaceOfGanacim {
  std::string_view name, id;
  FramesOfGanacim at_512, at_1024;
  bool quick = false;
};
inline constexpr SurfaceOfGanacim kGanacimSurfaces[] = {
    {"Sphere", "sphere", {860, 1120, 280, 464}, {300, 447, 79, 140}, true},
    {"Dingdong", "ding_dong", {815, 947, 284, 425}, {300, 412, 83, 142}},
    {"Klein", "klein_bottle", {274, 362, 76, 133}, {88, 131, 21, 41}},
    {"Mitchell", "mitchell", {189, 240, 45, 72}, {54, 70, 13, 23}, true},
    {"Octdong", "octdong", {544, 660, 173, 267}, {190, 263, 52, 87}},
    {"Steiner", "steiner", {532, 840, 168, 389}, {180, 377, 48, 137}},
    {"Tangle", "tangle", {185, 244, 49, 86}, {56, 85, 14, 27}},
    {"Teardrop", "teardrop", {842, 1287, 283, 580}, {288, 555, 80, 196}},
    {"Barth (sextic)", "barth_sextic", {235, 287, 67, 105}, {77, 104, 20, 35}},
    {"Heart", "heart_taubin", {574, 806, 180, 339}, {193, 332, 51, 110}},
    {"Chmutov (7)", "chmutov_7", {212, 333, 50, 95}, {60, 94, 13, 20}},
    {"Blob (4 Gaussians)", "blinn_blob4", {781, 1322, 257, 570}, {262, 545, 70, 182}, true},
};

}  // namespace isocast::bench
