// Beams of formulas cast by an engine.
#pragma once

#include <isocast/cuda/queue_pool.h>

namespace isocast {

/// `pool` for as long as the caster lives.
[[nodiscard]] std::unique_ptr<const BeamCaster> make_beam_caster(std::shared_ptr<const QueuePool> pool,
                                                                 const BeamCastKey& key, const Tape& tape);

}  // namespace isocast
