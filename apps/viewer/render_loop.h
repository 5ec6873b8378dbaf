// Renders beside the interface: always the newest wish, from a preview to what `isocast render` makes.
#pragma once

#include <isocast/apps/isocast/probe_ray.h>
#include <isocast/apps/viewer/frame_budget.h>
#include <isocast/apps/viewer/idle_work.h>
#include <isocast/apps/viewer/loop_counts.h>
#include <isocast/apps/viewer/mailbox.h>
#include <isocast/apps/viewer/scene_keeper.h>

#include <optional>
#include <thread>

namespace isocast::viewer {

/// All calls are the interface's, and none waits for work: wishes go in and results come out by exchanging
/// pointers. A wish ends older work within a tile, but for a preview in its time, which is shown first, and
/// for loading, which goes on unless the input is another one. At the end of a wish's frame budget the best
/// picture that there is is shown.
class RenderLoop {
 public:
  /// tell: called in the render thread when there is something new.
  explicit RenderLoop(std::function<void()> tell = [] {});
  ~RenderLoop();
  RenderLoop(const RenderLoop&) = delete;
  RenderLoop& operator=(const RenderLoop&) = delete;

  /// Replaces the wish before; revisions are the loop's: returns this wish's.
  std::uint64_t ask(Wish wish);
  /// Ends loading and whatever else is going on.
  void cancel() { mailbox_.end_now(); }
  /// Something to do with the scene and its complete picture, as soon as there are no newer wishes.
  void post(Job job);

  /// The newest results; null or empty before there are any.
  [[nodiscard]] std::shared_ptr<const Picture> picture() const { return picture_.load(); }
  [[nodiscard]] std::shared_ptr<const SceneNews> news() const { return news_.load(); }
  [[nodiscard]] const IdleResults& idle() const { return idle_.results(); }
  /// The picture of the newest wish is complete, and all that was posted is done; or it has failed.
  [[nodiscard]] bool at_rest() const;
  /// Loading or building goes on for a wish whose scene is not there yet.
  [[nodiscard]] bool loading() const { return loading_; }
  [[nodiscard]] ProgressWatch::Work work() const { return watch_.work(); }
  [[nodiscard]] const LoopCounts& counts() const { return counts_; }

 private:
  void run();
  void fulfil(const Wish& wish);
  void load(const Wish& wish);
  void publish_news(std::uint64_t revision, const std::string& error);
  void make_pictures(const Wish& wish);
  bool make_first_pictures(const Wish& wish, const Camera& camera, const RenderSettings& settings,
                           Stage last);
  Picture make_picture(const Wish& wish, const Camera& camera, const RenderSettings& settings, Stage stage,
                       int divisor, Clock::time_point stays_until);
  void show_picture(Picture picture, const Wish& wish);
  void note_first(const Wish& wish);
  void show(Picture picture);

  std::function<void()> tell_;
  ProgressWatch watch_;
  Mailbox mailbox_;
  SceneKeeper keeper_;
  FrameBudget budget_;
  LoopCounts counts_;
  IdleWork idle_;
  std::atomic<std::shared_ptr<const Picture>> picture_;
  std::atomic<std::shared_ptr<const SceneNews>> news_;
  std::atomic<std::uint64_t> rested_ = 0;
  std::atomic<bool> loading_ = false, in_extras_ = false;
  std::uint64_t complete_ = 0;               // the render thread's
  std::atomic<std::uint64_t> first_of_ = 0;  // the newest wish that has had a picture
  Clock::time_point begun_;                  // the wish that is worked on, the render thread's
  std::optional<View> view_;                 // of the complete picture, the render thread's
  std::uint64_t asked_ = 0;                  // the interface's
  std::vector<std::string> source_;          // of the newest wish, the interface's
  std::vector<std::string> traced_;          // what the budget knows, the render thread's
  std::jthread thread_;
};

}  // namespace isocast::viewer
