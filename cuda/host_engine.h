// This processor in a device's place: the same kernel bodies, thread after thread.
#pragma once

#include <isocast/cuda/engine.h>

#include <cstdint>

namespace isocast {

/// threads   of a block, any number
/// shuffle   not 0: blocks and their threads run in an order drawn from this seed
struct HostLaunches {
  int threads = 128;
  std::uint64_t shuffle = 0;
};

/// An engine that needs no device, for tests of everything but the device itself. Formulas are interpreted.
[[nodiscard]] std::shared_ptr<const Engine> make_host_engine(const HostLaunches& launches = {});

}  // namespace isocast
