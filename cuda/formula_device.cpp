#include <isocast/cuda/beam_device.h>
#include <isocast/cuda/formula_device.h>
#include <isocast/cuda/ray_form_work.h>
#include <isocast/cuda/segment_work.h>

namespace isocast {
namespace {

enum Buffer { kSegments, kRoots };

class Solver final : public SegmentSolver {
 public:
  Solver(std::shared_ptr<const QueuePool> pool, const SegmentSolverKey& key, const Tape& tape)
      : pool_(std::move(pool)), kernel_(pool_->engine().formula_kernel(key, tape)) {}

  void solve(const FormulaQuery<float>& query, std::span<const SegmentStream<float>* const> segments,
             std::span<SegmentRoots<float>* const> roots) const override {
    solve_all(query, segments, roots);
  }
  void solve(const FormulaQuery<double>& query, std::span<const SegmentStream<double>* const> segments,
             std::span<SegmentRoots<double>* const> roots) const override {
    solve_all(query, segments, roots);
  }

 private:
  template <class T>
  void solve_all(const FormulaQuery<T>& query, std::span<const SegmentStream<T>* const> segments,
                 std::span<SegmentRoots<T>* const> roots) const {
    pool_->with_workplace([&](Workplace& place) {
      Queue& queue = *place.queue;
      const std::size_t n = segments.size();
      auto* const from =
          reinterpret_cast<SegmentStream<T>*>(place.buffer(kSegments, n * sizeof(SegmentStream<T>)));
      auto* const to = reinterpret_cast<SegmentRoots<T>*>(place.buffer(kRoots, n * sizeof(SegmentRoots<T>)));
      for (std::size_t i = 0; i < n; ++i) queue.upload(from + i, segments[i], sizeof(SegmentStream<T>));
      const SegmentWork<T> work = {query, from, to, std::int32_t(n)};
      queue.launch(*kernel_, &work, sizeof work, std::int64_t(n) * kStreamSize);
      for (std::size_t i = 0; i < n; ++i) queue.download(roots[i], to + i, sizeof(SegmentRoots<T>));
    });
  }

  std::shared_ptr<const QueuePool> pool_;
  std::shared_ptr<const Kernel> kernel_;
};

enum RayFormBuffer { kRays, kRayRoots, kPoints, kFromValues, kAtPoints };

class RayForms final : public RayFormSolver {
 public:
  RayForms(std::shared_ptr<const QueuePool> pool, const RayFormKey& key, const Tape& tape)
      : pool_(std::move(pool)), kernel_(pool_->engine().ray_form_kernel(key, tape)) {}

  void solve(const RayFormQuery& query, std::span<const RayFormStream* const> rays,
             std::span<RayFormRoots* const> roots) const override {
    pool_->with_workplace([&](Workplace& place) {
      Queue& queue = *place.queue;
      const std::size_t n = rays.size(), points = static_cast<std::size_t>(query.table.degree) + 1;
      const auto copied = [&](RayFormBuffer buffer, const double* table, std::size_t count) {
        std::byte* const there = place.buffer(buffer, count * sizeof(double));
        queue.upload(there, table, count * sizeof(double));
        return reinterpret_cast<const double*>(there);
      };
      auto* const from = reinterpret_cast<RayFormStream*>(place.buffer(kRays, n * sizeof(RayFormStream)));
      auto* const to = reinterpret_cast<RayFormRoots*>(place.buffer(kRayRoots, n * sizeof(RayFormRoots)));
      RayFormWork work = {query, from, to, std::int32_t(n)};
      work.query.table = {query.table.degree,
                          copied(kPoints, query.table.points, points),
                          copied(kFromValues, query.table.from_values, points * points),
                          copied(kAtPoints, query.table.at_points, points * points),
                          query.table.lebesgue};
      for (std::size_t i = 0; i < n; ++i) queue.upload(from + i, rays[i], sizeof(RayFormStream));
      queue.launch(*kernel_, &work, sizeof work, std::int64_t(n) * kStreamSize);
      for (std::size_t i = 0; i < n; ++i) queue.download(roots[i], to + i, sizeof(RayFormRoots));
    });
  }

 private:
  std::shared_ptr<const QueuePool> pool_;
  std::shared_ptr<const Kernel> kernel_;
};

class Device final : public FormulaDevice {
 public:
  explicit Device(std::shared_ptr<const QueuePool> pool) : pool_(std::move(pool)) {}
  [[nodiscard]] std::unique_ptr<const SegmentSolver> solver_of(const SegmentSolverKey& key,
                                                               const Tape& tape) const override {
    return std::make_unique<Solver>(pool_, key, tape);
  }
  [[nodiscard]] std::unique_ptr<const RayFormSolver> ray_form_solver_of(const RayFormKey& key,
                                                                        const Tape& tape) const override {
    return std::make_unique<RayForms>(pool_, key, tape);
  }
  [[nodiscard]] std::unique_ptr<const BeamCaster> beam_caster_of(const BeamCastKey& key,
                                                                 const Tape& tape) const override {
    return make_beam_caster(pool_, key, tape);
  }

 private:
  std::shared_ptr<const QueuePool> pool_;
};

}  // namespace

std::shared_ptr<const FormulaDevice> make_formula_device(std::shared_ptr<const QueuePool> pool) {
  return std::make_shared<Device>(std::move(pool));
}

}  // namespace isocast
