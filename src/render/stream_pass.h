// The primary rays of a picture as streams, many at a time: for what answers many rays sooner than few.
#pragma once

#include <isocast/ray/primary_pass.h>
#include <isocast/ray/surface.h>
#include <isocast/render/camera.h>

#include <functional>

namespace isocast {

/// First hits of many streams together: hits[i] belongs to rays[i].
using TraceStreams = std::function<void(std::span<const RayStream> rays, std::span<HitStream* const> hits,
                                        TraceCounts& counts)>;

/// A block's tiles that the surface may meet, as one batch of streams for `trace`.
class StreamPass final : public PrimaryPass {
 public:
  StreamPass(const Surface& surface, const View& view, TraceStreams trace)
      : surface_(surface), view_(view), trace_(std::move(trace)) {}

  void first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                  TraceCounts& counts) const override;

 private:
  const Surface& surface_;
  View view_;
  TraceStreams trace_;
};

}  // namespace isocast
