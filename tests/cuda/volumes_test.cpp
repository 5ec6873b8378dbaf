// A device's kernels of volumes, run by this processor: the bits of the walk, whatever the blocks and their
// order.
#include <isocast/cuda/host_engine.h>
#include <isocast/cuda/volume_device.h>
#include <isocast/isa/cpu.h>
#include <test_size.h>

#include <catch2/catch.hpp>

#include "../volume/random_streams.h"
#include "../volume/test_fields.h"

using namespace isocast;
using namespace isocast::test;

namespace {

std::shared_ptr<const VolumeDevice> host_device(int threads, std::uint64_t shuffle) {
  return make_volume_device(std::make_shared<QueuePool>(make_host_engine({threads, shuffle})));
}

std::int64_t compare(std::mt19937_64& random, const std::shared_ptr<Volume>& volume, const Box& near,
                     VolumeSurfaceOptions options) {
  options.isa = Isa::scalar;
  options.order = RayOrder::walk;
  const VolumeSurface walk(volume, options);
  constexpr int kThreads[] = {1, 32, 77, 128, 1024};
  options.device = host_device(kThreads[random() % std::size(kThreads)], random() % 3);
  const VolumeSurface device(volume, options);
  const std::unique_ptr<Streams> asked = make_streams();
  fill_random(random, near.empty() ? walk.bounds() : near, *asked);
  return compare_hits(random, walk, device, *asked, 1);
}

constexpr const char* kMethods[] = {"midpoint", "linear", "neubauer", "schwarze", "marmitt", "certified"};

}  // namespace

TEST_CASE("dense grids: a thread's ray has the bits of the walk", "[property]") {
  std::mt19937_64 random(31);
  std::vector<std::shared_ptr<Volume>> volumes;
  for (const SampleType type :
       {SampleType::u8, SampleType::i8, SampleType::u16, SampleType::i16, SampleType::u32, SampleType::i32,
        SampleType::f16, SampleType::f32, SampleType::f64}) {
    volumes.push_back(make_volume(kDims, type, wavy));
    volumes.push_back(make_volume(kDims, type, flat));
  }
  volumes.push_back(with_holes(make_volume(kDims, SampleType::f32, wavy)));
  volumes.push_back(make_volume({2, 300, 3}, SampleType::u8, rough));
  std::int64_t hits = 0;
  const std::int64_t rounds = test::cases(500, 50000);
  for (std::int64_t round = 0; round < rounds; ++round) {
    const auto& volume = volumes[static_cast<std::size_t>(round) % volumes.size()];
    VolumeSurfaceOptions options = surface_options(0, Isa::scalar, kMethods[random() % std::size(kMethods)]);
    options.iso = random() % 2 ? std::vector<double>{41} : std::vector<double>{60, 20, 41};
    options.double_precision = random() % 2;
    INFO("round " << round);
    hits += compare(random, volume, {}, options);
  }
  CHECK(hits > 50 * rounds);
}

TEST_CASE("sparse grids: a thread's ray has the bits of the walk", "[property]") {
  std::mt19937_64 random(32);
  Box near;
  near.add(Double3{-16, -24, -16});
  near.add(Double3{40, 24, 32});
  std::int64_t hits = 0;
  for (const SparseType type :
       {SparseType::f32, SparseType::f64, SparseType::i16, SparseType::i32, SparseType::i64})
    for (const char* method : kMethods) {
      const std::shared_ptr<Volume> tree = patchy_tree(type);
      for (std::int64_t round = 0; round < test::cases(2, 200); ++round) {
        VolumeSurfaceOptions options = surface_options(0, Isa::scalar, method);
        options.iso = random() % 2 ? std::vector<double>{41} : std::vector<double>{20, 41, 55};
        options.double_precision = random() % 2;
        INFO("round " << round << ", " << method);
        hits += compare(random, tree, round % 2 ? near : Box{}, options);
      }
    }
  CHECK(hits > 2000);
}

TEST_CASE("a volume in which nothing is active meets no ray of a device") {
  const std::shared_ptr<Volume> empty = TreeMaker(SparseType::f32, 0).volume();
  VolumeSurfaceOptions options = surface_options(41);
  options.device = host_device(128, 0);
  const VolumeSurface surface(empty, options);
  const std::unique_ptr<Streams> streams = make_streams();
  clear(streams->hits);
  streams->rays.size = 0;
  add_ray(streams->rays, {0, 0, 0}, {1, 0, 0});
  TraceCounts counts;
  surface.first_hit(streams->rays, streams->hits, counts);
  CHECK_FALSE(is_hit(streams->hits, 0));
}
