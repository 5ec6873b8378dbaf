// Volumes traced by an engine.
#pragma once

#include <isocast/cuda/queue_pool.h>
#include <isocast/volume/volume_tracer.h>

namespace isocast {

/// `pool` serves all tracers.
[[nodiscard]] std::shared_ptr<const VolumeDevice> make_volume_device(std::shared_ptr<const QueuePool> pool);

}  // namespace isocast
