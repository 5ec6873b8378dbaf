// What is found out when the picture is complete and nobody wants another one.
#pragma once

#include <isocast/apps/isocast/probe_ray.h>
#include <isocast/apps/viewer/mailbox.h>
#include <isocast/apps/viewer/scene_keeper.h>

#include <functional>
#include <mutex>
#include <vector>

namespace isocast::viewer {

/// What a job may look at, and change for as long as it runs.
struct JobScene {
  SceneKeeper& keeper;
  const View& view;
  const Picture& picture;
  std::stop_token stop;
};
struct MethodPoint;
using Job = std::function<void(const JobScene&)>;

/// Statistics of the volumes of `scene` (SceneNews) by object, null: none; the methods' points.
struct IdleResults {
  using OfVolumes = std::vector<std::shared_ptr<const VolumeStatistics>>;
  std::atomic<std::shared_ptr<const OfVolumes>> statistics;
  std::atomic<int> scene = 0;
  std::atomic<std::shared_ptr<const std::vector<MethodPoint>>> points;
};

/// Of the render thread but for post() and results().
class IdleWork {
 public:
  void post(Job job);
  [[nodiscard]] bool empty() const;
  /// Drops all jobs: there is nothing to look at.
  void forget();
  /// Everything that is not done yet, as long as nobody stops it; what was stopped is dropped.
  void run(const JobScene& scene);
  /// What the wish asks for beyond its picture.
  void run_extras(const JobScene& scene, const Wish& wish, const std::function<void(Picture)>& show);
  [[nodiscard]] const IdleResults& results() const { return results_; }

 private:
  void find_statistics(const JobScene& scene);

  mutable std::mutex mutex_;
  std::vector<Job> jobs_;
  IdleResults results_;
};

}  // namespace isocast::viewer
