#include <isocast/apps/bench/rows.h>
#include <isocast/apps/bench/stress_case.h>
#include <isocast/data_gen/hash.h>
#include <isocast/data_gen/write.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isocast::bench {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kSamples = 16;
constexpr double kMiddle = 0.5 * (kSamples - 1);

// Values at whole coordinates 0 ... kSamples - 1.
double ball(double i, double j, double k) { return std::hypot(i - kMiddle, j - kMiddle, k - kMiddle); }
double noise(double i, double j, double k) {
  return 2 * hash_uniform({std::uint64_t(i), std::uint64_t(j), std::uint64_t(k)}) - 1;
}
double ball_with(double odd_value, double i, double j, double k) {
  return noise(i, j, k) > 0.9 ? odd_value : ball(i, j, k);
}
double steps(double i, double j, double k) { return std::clamp(std::round(ball(i, j, k)), 3.0, 7.0); }

double slab(double before, double i) {
  if (i < 5) return before;
  return i < 10 ? 0 : 1;
}
double denormal_layer(double, double, double k) {
  if (k == 8) return -0x1p-149;
  return k < 8 ? 1 : -1;
}

// Samples lie at whole coordinates in the world unless there is a `scale` and an `origin`.
struct StressVolume {
  const char *name, *stresses;
  double (*value)(double i, double j, double k);
  std::vector<double> iso;
  std::vector<Expectation> expected = {};
  MakeRays rays = framing_rays;
  SampleType type = SampleType::f32;
  Double3 scale = {1, 1, 1};
  double origin = 0;
};

using enum Counted;
const Expectation kMarmittRight = {wrong, 0, 0.1, "marmitt"},
                  kCertifiedDecides = {undecided, 0, 1, "certified"}, kNoProvedHit = {proved_hit, 0, 0};

const std::vector<StressVolume>& volumes() {
  static const std::vector<StressVolume> all = {
      {"ball",
       "nothing: what others are compared with",
       ball,
       {6.7},
       {{wrong, 10, 100, "midpoint"}, {wrong, 0, 0, "neubauer"}, kMarmittRight, kCertifiedDecides}},
      {"noise",
       "many roots along every ray and in every cell",
       noise,
       {0.1},
       {{wrong, 1, 20, "neubauer"}, kMarmittRight, kCertifiedDecides}},
      {"plateau",
       "a slab of samples at the iso-value between both sides",
       [](double i, double, double) { return slab(-1, i); },
       {0},
       {kMarmittRight}},
      {"plateau_touch",
       "a slab of samples at the iso-value, with nothing below it",
       [](double i, double, double) { return slab(1, i); },
       {0},
       {kMarmittRight, kNoProvedHit}},
      {.name = "steps_u8",
       .stresses = "bytes on five levels, two of them iso-values",
       .value = steps,
       .iso = {4, 5},
       .expected = {{wrong, 1, 100, "schwarze"}, kMarmittRight},
       .type = SampleType::u8},
      {"checkerboard",
       "signs that alternate from sample to sample",
       [](double i, double j, double k) { return std::fmod(i + j + k, 2) < 1 ? 1.0 : -1.0; },
       {0},
       {{wrong, 10, 100, "neubauer"}, kMarmittRight}},
      {"nan",
       "samples that are no numbers strewn into a ball: their cells do not exist",
       [](double i, double j, double k) { return ball_with(kNaN, i, j, k); },
       {6.7},
       {kMarmittRight, kCertifiedDecides}},
      {"infinite",
       "infinite samples of both signs strewn into a ball: their cells do not exist",
       [](double i, double j, double k) { return ball_with(i < 8 ? kInfinity : -kInfinity, i, j, k); },
       {6.7},
       {kMarmittRight, kCertifiedDecides}},
      {"nan_everywhere",
       "no sample is a number",
       [](double, double, double) { return kNaN; },
       {0},
       {{wrong, 0, 0}, kNoProvedHit, {undecided, 0, 0}}},
      {"denormal",
       "samples of a few of the smallest floats",
       [](double i, double j, double k) { return 0x1p-149 * std::round(ball(i, j, k) - 6.7); },
       {0},
       {{wrong, 0, 5, "marmitt", "double"}, {wrong, 0, 50, "marmitt", "float"}}},
      {"denormal_layer",
       "a layer of the smallest negative float between 1 and -1, hit amid cells, underflows in float: rays "
       "leak",
       denormal_layer,
       {0},
       {{wrong, 0, 0, "marmitt", "double"}, {wrong, 0, 100, "marmitt", "float"}},
       central_rays},
      {"minus_zero",
       "zeros of both signs beside positive samples: zero counts as positive",
       [](double i, double j, double) { return i < 8 ? (std::fmod(j, 2) < 1 ? -0.0 : 0.0) : i - 7; },
       {0},
       {kMarmittRight, kNoProvedHit}},
      {"one_ulp_float",
       "iso-values that are neighbours in single precision",
       ball,
       {6.7f, std::nextafter(6.7f, 7.0f)},
       {{wrong, 0, 0, "marmitt", "double"}}},
      {.name = "one_ulp_double",
       .stresses = "iso-values that are neighbours in double precision",
       .value = ball,
       .iso = {6.7, std::nextafter(6.7, 7.0)},
       .expected = {{undecided, 10, 100, "certified"}},
       .type = SampleType::f64},
      {.name = "thin_slices",
       .stresses = "voxels of 1 x 1 x 100",
       .value = ball,
       .iso = {6.7},
       .expected = {kMarmittRight, kCertifiedDecides},
       .rays = inner_rays,
       .scale = {1, 1, 100}},
      {"along_axes", "rays along axes", noise, {0.1}, {kMarmittRight, kCertifiedDecides}, axis_rays},
      {"in_faces",
       "rays in faces and edges of cells and through their corners",
       noise,
       {0.1},
       {kMarmittRight, kCertifiedDecides},
       face_rays},
      {"in_faces_plateau",
       "the same with a third of the samples at the iso-value",
       [](double i, double j, double k) { return std::fmod(i + 2 * j + k, 3) - 1; },
       {0},
       {kMarmittRight},
       face_rays},
      {"from_inside", "rays that start inside", noise, {0.1}, {kMarmittRight, kCertifiedDecides}, inner_rays},
      {"from_the_surface",
       "rays that start exactly on the surface, a plane",
       [](double i, double, double) { return i; },
       {7},
       {{wrong, 0, 0}},
       rays_from_x7},
      {"thin_wall",
       "a wall of one slice, thinner than a hundredth of a voxel at the iso-value",
       [](double i, double, double) { return i == 8 ? 1.0 : 0.0; },
       {0.995},
       {kMarmittRight, kCertifiedDecides}},
      {"values_1e-30",
       "samples about 1e-30",
       [](double i, double j, double k) { return 1e-30 * ball(i, j, k); },
       {6.7e-30},
       {kMarmittRight, kCertifiedDecides}},
      {"values_1e30",
       "samples about 1e30",
       [](double i, double j, double k) { return 1e30 * ball(i, j, k); },
       {6.7e30},
       {kMarmittRight, kCertifiedDecides}},
      {.name = "values_1e300",
       .stresses = "samples about 1e300, which single precision does not have",
       .value = [](double i, double j, double k) { return 1e300 * ball(i, j, k); },
       .iso = {6.7e300},
       .expected = {{wrong, 0, 0, "marmitt", "double"}, {wrong, 10, 100, "marmitt", "float"}},
       .type = SampleType::f64},
      {"large_offset",
       "samples of 1e6 and little more, where single precision has steps of 1/16",
       [](double i, double j, double k) { return 1e6 + ball(i, j, k); },
       {1e6 + 6.7},
       {kMarmittRight, kCertifiedDecides}},
      {.name = "world_1e-30",
       .stresses = "voxels of 1e-30",
       .value = ball,
       .iso = {6.7},
       .expected = {kMarmittRight, kCertifiedDecides},
       .scale = {1e-30, 1e-30, 1e-30}},
      {.name = "world_1e30",
       .stresses = "voxels of 1e30",
       .value = ball,
       .iso = {6.7},
       .expected = {kMarmittRight, kCertifiedDecides},
       .scale = {1e30, 1e30, 1e30}},
      {.name = "far_away",
       .stresses = "a volume 1e6 away from the origin",
       .value = ball,
       .iso = {6.7},
       .expected = {kMarmittRight, kCertifiedDecides},
       .origin = 1e6},
  };
  return all;
}

SampleGrid grid_of(const StressVolume& volume) {
  SampleGrid grid{{kSamples, kSamples, kSamples}, {}};
  for (std::size_t a = 0; a < 3; ++a) {
    grid.domain.lo[a] = volume.origin;
    grid.domain.hi[a] = volume.origin + (kSamples - 1) * volume.scale[a];
  }
  return grid;
}

void write(const StressVolume& volume, const std::filesystem::path& file) {
  const Field field = [&](const SampleGrid&, std::int64_t j, std::int64_t k, std::span<double> values) {
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = volume.value(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
  };
  write_field(field, grid_of(volume), file, {.type = volume.type, .range = ValueRange{0, 255}});
}

}  // namespace

std::vector<StressCase> stress_volumes(const std::filesystem::path& folder) {
  prepare_folder(folder / "volumes");
  std::vector<StressCase> cases;
  for (const StressVolume& volume : volumes()) {
    const std::filesystem::path file = folder / "volumes" / (std::string(volume.name) + ".nrrd");
    write(volume, file);
    StressCase& stress = cases.emplace_back(
        StressCase{std::string("volumes/") + volume.name, volume.stresses, {}, volume.rays, volume.expected});
    stress.scene.objects.front().source = VolumeSource{file, {}};
    stress.scene.objects.front().iso = volume.iso;
  }
  return cases;
}

}  // namespace isocast::bench
