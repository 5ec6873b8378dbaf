#include "open_volume.h"

#include <isocast/volume/io/read_volume.h>
#include <isocast/volume/statistics.h>
#include <isocast/volume/volume_surface.h>
#include <volume/rays.h>

#include <memory>

namespace isocast::hostile {
namespace {

// Rays from around the surface to its inside; first and next hits, dressed.
void trace(const VolumeSurface& surface) {
  const Box box = surface.bounds();
  if (box.empty()) return;
  const auto streams = test::make_streams();
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> around(-1, 2), inside(0, 1);
  const auto point = [&](auto& place) {
    Double3 p;
    for (int a = 0; a < 3; ++a) p[a] = box.lo[a] + place(random) * (box.hi[a] - box.lo[a]);
    return p;
  };
  while (streams->rays.size < kStreamSize) {
    const Double3 origin = point(around);
    test::add_ray(streams->rays, origin, point(inside) - origin);
  }
  TraceCounts counts;
  surface.first_hit(streams->rays, streams->hits, counts);
  const auto dressed = std::make_unique<DressedHits>();
  surface.dress(streams->rays, streams->hits, {true, true, true}, *dressed);
  surface.next_hit(streams->rays, streams->hits, counts);
}

}  // namespace

void open_volume(const std::filesystem::path& path) {
  const auto volume = std::make_shared<const Volume>(read_volume(path));
  const VolumeStatistics statistics = statistics_of(*volume);
  VolumeSurfaceOptions options;
  options.iso = {statistics.suggested_iso.empty() ? 0 : statistics.suggested_iso[0]};
  trace(VolumeSurface(volume, options));
}

}  // namespace isocast::hostile
