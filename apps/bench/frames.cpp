#include <isocast/apps/bench/frames.h>
#include <isocast/apps/bench/random.h>
#include <isocast/base/interrupt.h>
#include <isocast/base/progress.h>
#include <isocast/data_gen/sample.h>
#include <isocast/data_gen/test_volumes.h>
#include <isocast/implicit/expression/parse.h>
#include <isocast/render/render.h>
#include <isocast/volume/volume_surface.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace isocast::bench {
namespace {

// lo, hi: the values that become the smallest and the largest byte
struct FrameVolume {
  const char *name, *field;
  double iso, lo, hi;
};
constexpr FrameVolume kVolumes[] = {{"sphere", "sqrt(x^2+y^2+z^2)", 0.7, 0, 1.75},
                                    {"gyroid", "gyroid", 0, -1.5, 1.5},
                                    {"vessel", "vessel", 0.5, 0, 1},
                                    {"noise", "noise", 0.5, 0, 1},
                                    {"marschner_lobb", "marschner_lobb", 0.5, 0, 1}};
constexpr const char* kCameras[] = {"outside", "close-up", "inside"};
constexpr int kLargestFloat = 512;

std::shared_ptr<const Volume> sampled(const FrameVolume& source, int n, SampleType type) {
  const TestVolume* test = find_test_volume(source.field);
  const Field field = test ? test_volume_field(*test, {}) : formula_field(parse_expression(source.field, {}));
  const SampleGrid grid = {{n, n, n}, {}};
  auto volume = std::make_shared<Volume>();
  volume->type = type;
  volume->dims = grid.dims;
  auto buffer = std::make_shared<std::vector<std::byte>>(static_cast<std::size_t>(volume->bytes()));
  sample_rows(field, grid, 0, grid.rows(), [&](std::int64_t row, std::span<const double> values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::size_t at = static_cast<std::size_t>(row) * values.size() + i;
      const double code = 255 * (values[i] - source.lo) / (source.hi - source.lo);
      if (type == SampleType::f32)
        reinterpret_cast<float*>(buffer->data())[at] = static_cast<float>(values[i]);
      else (*buffer)[at] = static_cast<std::byte>(std::lround(std::clamp(code, 0.0, 255.0)));
    }
  });
  volume->samples = buffer->data();
  volume->storage = std::move(buffer);
  volume->world_from_grid.m[0][0] = volume->world_from_grid.m[1][1] = volume->world_from_grid.m[2][2] =
      2.0 / (n - 1);
  for (auto& row : volume->world_from_grid.m) row[3] = -1;
  if (type == SampleType::u8) {
    volume->slope = (source.hi - source.lo) / 255;
    volume->intercept = source.lo;
  }
  return volume;
}

View view_of(std::string_view camera, const Box& bounds, int pixels) {
  CameraWishes wishes;
  if (camera == "inside") {
    wishes.position = Double3{0.013, 0.021, 0.017};
    wishes.target = Double3{1, 0.7, 0.3};
  }
  Camera made = frame(bounds, wishes, 1);
  if (camera == "close-up") made.fov *= 0.3;
  return {made, pixels, pixels};
}

double seconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// One packet of sixteen cells of the volume that hold the iso-value, each with a random chord.
CellPacket<float> random_packet(const Volume& volume, double iso, std::uint64_t seed) {
  CellPacket<float> packet = {};
  Random random(7, seed);
  const auto pick = [&](std::int64_t n) { return static_cast<std::int64_t>(random.uniform(0, double(n))); };
  for (int l = 0; l < kPacketSize; ++l) {
    bool below = false, above = false;
    for (int attempt = 0; attempt < 2000 && !(below && above); ++attempt) {
      below = above = false;
      const std::int64_t at[3] = {pick(volume.dims[0] - 1), pick(volume.dims[1] - 1),
                                  pick(volume.dims[2] - 1)};
      for (int k = 0; k < 8; ++k) {
        const std::int64_t sample =
            at[0] + (k & 1) + volume.dims[0] * (at[1] + (k >> 1 & 1) + volume.dims[1] * (at[2] + (k >> 2)));
        const double value = volume.type == SampleType::f32
                                 ? double(reinterpret_cast<const float*>(volume.samples)[sample])
                                 : double(volume.samples[sample]);
        packet.f[k][l] = static_cast<float>(value - iso);
        (packet.f[k][l] < 0 ? below : above) = true;
      }
    }
    for (int a = 0; a < 3; ++a) {
      packet.entry[a][l] = a == 0 ? 0.0f : static_cast<float>(random.uniform(0, 1));
      packet.exit[a][l] = a == 0 ? 1.0f : static_cast<float>(random.uniform(0, 1));
    }
    packet.carry[l] = std::nanf("");
  }
  packet.active = 0xffff;
  return packet;
}

// Seconds that one pair of a full packet takes.
double solve_seconds(const Volume& volume, double iso, const VolumeSurfaceOptions& options) {
  std::vector<CellPacket<float>> packets;
  for (std::uint64_t i = 0; i < 64; ++i) packets.push_back(random_packet(volume, iso, i));
  std::vector<RootPacket<float>> roots(packets.size());
  const auto solve = cell_kernels(options.isa).solve_float[static_cast<int>(options.method.method)];
  double least = 1;
  for (int i = 0; i < 50; ++i)
    least = std::min(least, seconds_of([&] {
                       solve(options.method.options, packets.data(), roots.data(), packets.size());
                     }));
  return least / static_cast<double>(packets.size() * kPacketSize);
}

class FrameRun {
 public:
  FrameRun(const FrameVolume& source, int samples, SampleType type, const FrameOptions& options)
      : source_(source),
        options_(options),
        volume_(sampled(source, samples, type)),
        surface_(volume_, with_iso(source.iso)) {
    solve_ =
        solve_seconds(*volume_, (source.iso - volume_->intercept) / volume_->slope, with_iso(source.iso));
  }

  FrameTimes run(const char* camera) {
    const View view = view_of(camera, surface_.bounds(), options_.pixels);
    FrameTimes times;
    times.volume = source_.name;
    times.camera = camera;
    times.type = name_of(volume_->type);
    times.samples = static_cast<int>(volume_->dims[0]);
    times.in_object_order = surface_.primary(view) != nullptr;
    RenderCounts counts;
    (void)frame_seconds(surface_, view, counts);  // makes the masks
    times.frame = times.moving = times.streams = times.walk = times.shadows = times.binning = times.hits =
        std::numeric_limits<double>::infinity();
    for (int i = 0; i < options_.repetitions; ++i) {
      throw_if_interrupted();
      times.frame = std::min(times.frame, frame_seconds(surface_, view, counts));
      pass_seconds(view, times);
      RenderCounts other;
      times.streams = std::min(times.streams, ordered_seconds(RayOrder::streams, view));
      if (i < 2) times.walk = std::min(times.walk, ordered_seconds(RayOrder::walk, view));
      times.shadows = std::min(times.shadows, frame_seconds(surface_, view, other, true));
      times.shadow_rays = other.shadow;
    }
    for (int i = 0; i < options_.repetitions; ++i) {
      surface_.set_options(with_iso(source_.iso + 1e-5 * (i + 1)));
      RenderCounts ignored;
      times.moving = std::min(times.moving, frame_seconds(surface_, view, ignored));
    }
    surface_.set_options(with_iso(source_.iso));
    times.rays = counts.primary;
    times.hit_rays = counts.hits;
    times.cells = counts.trace.cells;
    times.solved = counts.trace.solves;
    times.solves = solve_ * static_cast<double>(counts.trace.solves);
    return times;
  }

 private:
  static VolumeSurfaceOptions with_iso(double iso) {
    VolumeSurfaceOptions options;
    options.iso = {iso};
    return options;
  }

  double ordered_seconds(RayOrder order, const View& view) {
    VolumeSurfaceOptions options = with_iso(source_.iso);
    options.order = order;
    surface_.set_options(options);
    RenderCounts ignored;
    const double seconds = frame_seconds(surface_, view, ignored);
    surface_.set_options(with_iso(source_.iso));
    return seconds;
  }

  static double frame_seconds(const Surface& surface, const View& view, RenderCounts& counts,
                              bool shadows = false) {
    Scene scene;
    if (shadows) scene.lights = {{1, 2, 3}};
    scene.shadows = shadows;
    scene.objects.push_back({{std::shared_ptr<const Surface>(), &surface}, {{}}});
    Film film(view.width(), view.height(), {});
    return seconds_of([&] { counts = render(scene, view, {}, film); });
  }

  void pass_seconds(const View& view, FrameTimes& times) const {
    std::unique_ptr<PrimaryPass> pass;
    times.binning = std::min(times.binning, seconds_of([&] { pass = surface_.primary(view); }));
    if (!pass) return;
    const auto block = std::make_unique_for_overwrite<BlockHits>();
    TraceCounts counts;
    const int pixels = kBlockTiles * kTileSize, across = (view.width() + pixels - 1) / pixels,
              down = (view.height() + pixels - 1) / pixels;
    times.hits = std::min(times.hits, seconds_of([&] {
                            for (int i = 0; i < across * down; ++i) {
                              block->reset(false);
                              pass->first_hits(i % across, i / across, 0.5, 0.5, *block, counts);
                            }
                          }));
  }

  const FrameVolume& source_;
  const FrameOptions& options_;
  std::shared_ptr<const Volume> volume_;
  VolumeSurface surface_;
  double solve_;
};

}  // namespace

std::vector<FrameTimes> run_frames(const FrameOptions& options) {
  std::vector<FrameTimes> frames;
  Progress progress("bench frames", std::ssize(kVolumes) * std::ssize(options.sizes) * 2);
  for (const FrameVolume& volume : kVolumes)
    for (const int samples : options.sizes)
      for (const SampleType type : {SampleType::f32, SampleType::u8}) {
        progress.add();
        if (type == SampleType::f32 && samples > kLargestFloat) continue;
        FrameRun run(volume, samples, type, options);  // sampled by all threads, measured on one
        const oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
        for (const char* camera : kCameras) frames.push_back(run.run(camera));
      }
  return frames;
}

}  // namespace isocast::bench
