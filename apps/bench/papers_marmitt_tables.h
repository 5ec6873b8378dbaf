// What Marmitt et al. (VMV 2004) printed: an Opteron at 1.8 GHz, single precision, SSE with 4 rays.
#pragma once

#include <string_view>

namespace isocast::bench {

inline constexpr const char* kMarmittSource =
    "Marmitt, Kleer, Wald, Friedrich, Slusallek: Fast and accurate ray-voxel intersection techniques for "
    "iso-surface ray tracing, VMV 2004";
inline constexpr const char* kMarmittNote =
    "Three iterations of Neubauer and the new method, cubics in powers (stable=0), float, one thread; the "
    "paper: an AMD Opteron at 1.8 GHz, so only ratios compare. The paper does not list its seven "
    "configurations; "
    "ours are topologies of marching cubes, with random chords. Of scans, the chords are those which a "
    "traversal hands to the intersector, up to the first hit.";

/// Million intersections per second: least, largest and mean of the synthetic cells; bonsai, aneurism and
/// engine.
struct SpeedsOfPaper {
  std::string_view name;
  bool correct;
  double synthetic[3], synthetic_simd[3], scans[3], scans_simd[3];
};
inline constexpr SpeedsOfPaper kSpeeds[] = {
    {"midpoint",
     false,
     {1.28, 33.3, 26.88},
     {2.59, 98.41, 85.48},
     {26.21, 26.18, 26.22},
     {87.71, 87.12, 87.13}},
    {"linear", false, {0.46, 7.54, 6.84}, {1.17, 13.93, 13.35}, {6.65, 6.65, 6.68}, {13.68, 13.66, 13.67}},
    {"Neubauer", false, {0.56, 3.18, 3.04}, {0.19, 8.01, 3.04}, {2.93, 2.94, 2.94}, {7.65, 7.60, 6.94}},
    {"Schwarze", true, {0.44, 3.26, 3.03}, {0.24, 2.20, 1.98}, {1.60, 1.56, 1.48}, {1.49, 1.39, 1.44}},
    {"new", true, {0.57, 3.23, 2.92}, {0.85, 4.80, 4.35}, {2.76, 2.80, 2.73}, {4.37, 4.56, 4.39}},
};

/// `instead` is the test volume that is taken where the scan is not given.
struct ScanOfPaper {
  std::string_view name, instead;
  int samples;
};
inline constexpr ScanOfPaper kScans[] = {
    {"bonsai", "noise", 64}, {"aneurism", "vessel", 128}, {"engine", "gyroid", 96}};

}  // namespace isocast::bench
