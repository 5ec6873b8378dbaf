#include <fmt/format.h>
#include <isocast/cuda/volume_body.h>
#include <isocast/cuda/volume_device.h>
#include <isocast/cuda/volume_memory.h>
#include <isocast/volume/visit_grid.h>
#include <isocast/volume/volume.h>

namespace isocast {
namespace {

enum Buffer { kRays, kHits, kCounts };

class Tracer final : public VolumeTracer {
 public:
  Tracer(std::shared_ptr<const QueuePool> pool, const VolumeQuery& query, const VolumeParts& parts)
      : pool_(std::move(pool)), memory_(pool_->engine(), query, parts) {
    const std::string type = query.sparse ? fmt::format("tree_{}", name_of(query.tree.type))
                                          : std::string(name_of(query.grid.type));
    for (const char* const precision : {"float", "double"})
      kernels_.push_back(pool_->engine().volume_kernel(fmt::format("trace_{}_{}", precision, type)));
  }

  void trace(const VolumeQuery& query, bool next, std::span<const RayStream> rays,
             std::span<HitStream* const> hits, TraceCounts& counts) const override {
    const VolumeQuery there = memory_.translated(query);
    visit_grid(there, [&]<class Grid>(GridTag<Grid>) {
      if (query.double_precision) trace_as<double, Grid>(there, next, rays, hits, counts);
      else trace_as<float, Grid>(there, next, rays, hits, counts);
    });
  }

 private:
  template <class T, class Grid>
  void trace_as(const VolumeQuery& query, bool next, std::span<const RayStream> rays,
                std::span<HitStream* const> hits, TraceCounts& counts) const {
    TraceCounts done;
    pool_->with_workplace([&](Workplace& place) {
      Queue& queue = *place.queue;
      const std::size_t n = rays.size();
      auto* const rays_there = reinterpret_cast<RayStream*>(place.buffer(kRays, n * sizeof(RayStream)));
      auto* const hits_there = reinterpret_cast<HitStream*>(place.buffer(kHits, n * sizeof(HitStream)));
      auto* const counts_there = reinterpret_cast<TraceCounts*>(place.buffer(kCounts, sizeof(TraceCounts)));
      queue.upload(rays_there, rays.data(), n * sizeof(RayStream));
      for (std::size_t i = 0; i < n; ++i) queue.upload(hits_there + i, hits[i], sizeof(HitStream));
      queue.upload(counts_there, &done, sizeof done);
      const TraceVolume<T, Grid> body = {query,        Grid(query),     rays_there, hits_there,
                                         counts_there, std::int32_t(n), next};
      queue.launch(*kernels_[sizeof(T) == 8], &body, sizeof body, std::int64_t(n) * kStreamSize);
      for (std::size_t i = 0; i < n; ++i) queue.download(hits[i], hits_there + i, sizeof(HitStream));
      queue.download(&done, counts_there, sizeof done);
    });
    counts += done;
  }

  std::shared_ptr<const QueuePool> pool_;
  VolumeMemory memory_;
  std::vector<std::shared_ptr<const Kernel>> kernels_;  // in float, in double
};

class Device final : public VolumeDevice {
 public:
  explicit Device(std::shared_ptr<const QueuePool> pool) : pool_(std::move(pool)) {}
  [[nodiscard]] std::unique_ptr<const VolumeTracer> tracer_of(const VolumeQuery& query,
                                                              const VolumeParts& parts) const override {
    return std::make_unique<Tracer>(pool_, query, parts);
  }

 private:
  std::shared_ptr<const QueuePool> pool_;
};

}  // namespace

std::shared_ptr<const VolumeDevice> make_volume_device(std::shared_ptr<const QueuePool> pool) {
  return std::make_shared<Device>(std::move(pool));
}

}  // namespace isocast
