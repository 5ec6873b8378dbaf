// What runs kernels: a device, or this processor in their place.
#pragma once

#include <isocast/implicit/segment_solver.h>

#include <cstddef>
#include <memory>
#include <string>

namespace isocast {

/// Memory that kernels see, for as long as this lives.
class KernelMemory {
 public:
  virtual ~KernelMemory() = default;
  [[nodiscard]] virtual void* data() const = 0;
  [[nodiscard]] virtual std::size_t bytes() const = 0;
};

/// A kernel that is ready to be launched: one argument, whose bytes are those of the body (volume_body.h,
/// formula_body.h, ...), for so many threads that each has one ray, or one beam.
class Kernel {
 public:
  virtual ~Kernel() = default;
};

/// Work that is done in order; several queues work side by side. Calls return before it is done. One thread
/// at a time may use a queue.
class Queue {
 public:
  virtual ~Queue() = default;
  virtual void upload(void* to, const void* from, std::size_t bytes) = 0;
  virtual void download(void* to, const void* from, std::size_t bytes) = 0;
  /// At least `threads` threads.
  virtual void launch(const Kernel& kernel, const void* body, std::size_t body_bytes,
                      std::int64_t threads) = 0;
  /// Until all is done. Returns the seconds that its launches took since the last call, by the device's
  /// clock.
  virtual double wait() = 0;
};

/// All calls are const and may come from any thread. They throw InputError where memory does not suffice or a
/// part that the user's machine should have is missing, std::runtime_error where the device fails.
class Engine {
 public:
  virtual ~Engine() = default;
  /// "NVIDIA H100, ..."; "host" for this processor.
  [[nodiscard]] virtual std::string name() const = 0;
  [[nodiscard]] virtual std::unique_ptr<KernelMemory> allocate(std::size_t bytes) const = 0;
  [[nodiscard]] virtual std::unique_ptr<Queue> make_queue() const = 0;
  /// "trace_float_u8" and the like.
  [[nodiscard]] virtual std::shared_ptr<const Kernel> volume_kernel(const std::string& name) const = 0;
  [[nodiscard]] virtual std::shared_ptr<const Kernel> formula_kernel(const SegmentSolverKey& key,
                                                                     const Tape& tape) const = 0;
  [[nodiscard]] virtual std::shared_ptr<const Kernel> ray_form_kernel(const RayFormKey& key,
                                                                      const Tape& tape) const = 0;
  [[nodiscard]] virtual std::shared_ptr<const Kernel> beam_kernel(const BeamCastKey& key,
                                                                  const Tape& tape) const = 0;
};

}  // namespace isocast
