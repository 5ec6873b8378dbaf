// What traces the rays of a volume in place of this processor's kernels.
#pragma once

#include <isocast/volume/query.h>

#include <memory>
#include <span>

namespace isocast {

struct Volume;
class MacroCells;
class SparseRangeTree;

/// What a query's pointers lead to: a dense grid has macrocells, a sparse one ranges.
struct VolumeParts {
  const Volume& volume;
  const MacroCells* macrocells;
  const SparseRangeTree* ranges;
};

/// Calls are const and may come from any thread.
class VolumeTracer {
 public:
  virtual ~VolumeTracer() = default;
  /// trace_first_hits, or trace_next_hits with `next` (query.h), for many streams: hits[i] belongs to
  /// rays[i]. The query's samples are those that the tracer was made for.
  virtual void trace(const VolumeQuery& query, bool next, std::span<const RayStream> rays,
                     std::span<HitStream* const> hits, TraceCounts& counts) const = 0;
};

/// Something that traces volumes: a device.
class VolumeDevice {
 public:
  virtual ~VolumeDevice() = default;
  /// A tracer that has the volume in its memory. Throws InputError where that does not suffice.
  [[nodiscard]] virtual std::unique_ptr<const VolumeTracer> tracer_of(const VolumeQuery& query,
                                                                      const VolumeParts& parts) const = 0;
};

}  // namespace isocast
