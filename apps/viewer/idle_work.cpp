#include <isocast/apps/viewer/extras.h>
#include <isocast/apps/viewer/idle_work.h>
#include <isocast/base/error.h>

namespace isocast::viewer {

void IdleWork::post(Job job) {
  const std::lock_guard lock(mutex_);
  jobs_.push_back(std::move(job));
}

bool IdleWork::empty() const {
  const std::lock_guard lock(mutex_);
  return jobs_.empty();
}

void IdleWork::forget() {
  const std::lock_guard lock(mutex_);
  jobs_.clear();
}

void IdleWork::run(const JobScene& scene) {
  const auto next = [&] {
    const std::lock_guard lock(mutex_);
    return jobs_.empty() ? Job() : jobs_.front();
  };
  const auto drop = [&] {
    const std::lock_guard lock(mutex_);
    jobs_.erase(jobs_.begin());
  };
  while (const Job job = next()) {
    try {
      job(scene);
    } catch (...) {
      drop();
      throw;
    }
    drop();
  }
  find_statistics(scene);
}

void IdleWork::run_extras(const JobScene& scene, const Wish& wish, const std::function<void(Picture)>& show) {
  if (!scene.keeper.has_methods(wish.object)) return;
  if (wish.overlay == Overlay::difference && !wish.other.empty()) {
    Picture both = scene.picture;
    both.other = other_picture(scene, wish.object, wish.other);
    show(std::move(both));
  }
  if (wish.overlay == Overlay::error) show_errors(scene, wish.object, show);
  if (wish.points)
    find_points(scene, wish.object, [&](const std::vector<MethodPoint>& points) {
      results_.points = std::make_shared<const std::vector<MethodPoint>>(points);
    });
}

void IdleWork::find_statistics(const JobScene& scene) {
  if (results_.scene == scene.keeper.scene()) return;
  IdleResults::OfVolumes statistics;
  for (std::size_t k = 0; k < scene.keeper.built().objects.size(); ++k)
    statistics.push_back(scene.keeper.statistics(k));
  results_.statistics = std::make_shared<const IdleResults::OfVolumes>(std::move(statistics));
  results_.scene = scene.keeper.scene();
}

}  // namespace isocast::viewer
