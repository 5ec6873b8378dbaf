#include <isocast/cuda/beam_device.h>
#include <isocast/cuda/beam_work.h>

namespace isocast {
namespace {

enum Buffer { kCounters, kEvenCells, kOddCells, kParts, kRoots, kLevels };

class Caster final : public BeamCaster {
 public:
  Caster(std::shared_ptr<const QueuePool> pool, const BeamCastKey& key, const Tape& tape)
      : pool_(std::move(pool)), kernel_(pool_->engine().beam_kernel(key, tape)) {}

  void cast(const FormulaQuery<float>& query, const BlockRays<float>& rays, int finer, bool adaptive,
            BlockRoots<float>& roots, std::uint8_t* levels) const override {
    cast_block(query, rays, finer, adaptive, roots, levels);
  }
  void cast(const FormulaQuery<double>& query, const BlockRays<double>& rays, int finer, bool adaptive,
            BlockRoots<double>& roots, std::uint8_t* levels) const override {
    cast_block(query, rays, finer, adaptive, roots, levels);
  }

 private:
  // Breadth first: nothing comes back before the last level, since a level has a thread for each cell that it
  // could have.
  template <class T>
  void cast_block(const FormulaQuery<T>& query, const BlockRays<T>& rays, int finer, bool adaptive,
                  BlockRoots<T>& roots, std::uint8_t* levels) const {
    BeamCounters counters;
    pool_->with_workplace([&](Workplace& place) {
      Queue& queue = *place.queue;
      const std::size_t finest = std::size_t(kBlockPixels) << 2 * finer;
      const auto buffer = [&]<class U>(Buffer purpose, std::size_t count, U*& there) {
        there = reinterpret_cast<U*>(place.buffer(purpose, count * sizeof(U)));
      };
      BeamWork<T> work = {query,   rays,    BeamStep::begin, CastLevel::first(adaptive, finer), nullptr, {},
                          nullptr, nullptr, nullptr};
      buffer(kCounters, 1, work.counters);
      buffer(kEvenCells, finest, work.cells[0]), buffer(kOddCells, finest, work.cells[1]);
      buffer(kParts, finest, work.parts);
      buffer(kRoots, 1, work.roots), buffer(kLevels, kBlockPixels, work.levels);
      const auto launch = [&](BeamStep step, std::size_t threads) {
        work.step = step;
        queue.launch(*kernel_, &work, sizeof work, static_cast<std::int64_t>(threads));
      };
      launch(BeamStep::begin, finest);
      for (CastLevel level = work.level; level.size >= 1; level = level.next()) {
        work.level = level;
        launch(BeamStep::cast,
               std::size_t(level.across(rays.columns)) * std::size_t(level.across(rays.rows)));
      }
      launch(BeamStep::end, kBlockPixels);
      queue.download(static_cast<PixelRoots<T>*>(&roots), work.roots, sizeof(PixelRoots<T>));
      queue.download(levels, work.levels, kBlockPixels);
      queue.download(&counters, work.counters, sizeof counters);
    });
    roots.evaluations = counters.evaluations;
  }

  std::shared_ptr<const QueuePool> pool_;
  std::shared_ptr<const Kernel> kernel_;
};

}  // namespace

std::unique_ptr<const BeamCaster> make_beam_caster(std::shared_ptr<const QueuePool> pool,
                                                   const BeamCastKey& key, const Tape& tape) {
  return std::make_unique<Caster>(std::move(pool), key, tape);
}

}  // namespace isocast
