// All crossings of rays with several objects, in order.
#pragma once

#include <isocast/render/frame.h>

#include <span>

namespace isocast {

/// Nearest first, none lost or repeated: of every object the next crossing waits for its turn, and only the
/// object whose crossing was taken is asked for its following one.
///
/// objects  the numbers of those that the rays may meet
class Crossings {
 public:
  /// The first crossing of every ray, into `hits` without any.
  void first(const Scene& scene, std::span<const std::uint16_t> objects, const RayStream& rays,
             HitStream& hits, TraceCounts& counts);

  /// The crossing behind each one in `hits`; a slot without one stays so.
  void next(const Scene& scene, std::span<const std::uint16_t> objects, const RayStream& rays,
            HitStream& hits, RenderCounts& counts);

 private:
  void take_nearest(int size, HitStream& hits);

  std::vector<HitStream> waiting_;  // per object, where there are several
};

}  // namespace isocast
