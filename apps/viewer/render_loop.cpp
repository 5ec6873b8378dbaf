#include <isocast/apps/viewer/best_in_time.h>
#include <isocast/apps/viewer/make_picture.h>
#include <isocast/apps/viewer/render_loop.h>
#include <isocast/base/error.h>
#include <isocast/base/interrupt.h>

#include <algorithm>
#include <optional>

namespace isocast::viewer {
namespace {

// One sample a pixel and edges as they are: what comes before the final picture.
RenderSettings quick(RenderSettings settings) {
  settings.spp = 1;
  settings.silhouettes = settings.coverage = false;
  return settings;
}

// What decides how long a picture takes, apart from where it is seen from and from what is dragged.
std::vector<std::string> traced_words(RenderWords words) {
  words.params.clear();
  words.time.clear();
  std::vector<std::string> list = source_of(words);
  list.insert(list.end(),
              {words.method, words.precision, words.isa, words.size, words.shadows ? "shadows" : ""});
  return list;
}

void raise_to(std::atomic<double>& largest, double value) { largest = std::max(largest.load(), value); }

}  // namespace

RenderLoop::RenderLoop(std::function<void()> tell) : tell_(std::move(tell)), thread_([this] { run(); }) {}
RenderLoop::~RenderLoop() { mailbox_.close(); }

std::uint64_t RenderLoop::ask(Wish wish) {
  wish.revision = ++asked_;
  std::vector<std::string> source = source_of(wish.words);
  const bool other = source != source_;
  source_ = std::move(source);
  mailbox_.put(std::make_shared<const Wish>(std::move(wish)));
  if (other) mailbox_.end_now(asked_);
  return asked_;
}

void RenderLoop::post(Job job) {
  idle_.post(std::move(job));
  if (in_extras_) mailbox_.end_now();
  mailbox_.wake();
}

bool RenderLoop::at_rest() const { return asked_ > 0 && rested_ == asked_ && idle_.empty(); }

void RenderLoop::run() {
  std::uint64_t done = 0;
  while (!mailbox_.closed()) {
    const std::shared_ptr<const Wish> wish = mailbox_.wait_for_newer(done);
    if (mailbox_.closed() || !wish) continue;
    done = wish->revision;
    try {
      fulfil(*wish);
      if (!mailbox_.has_newer(done)) rested_ = done;
      tell_();
    } catch (const Interrupted&) {  // something newer is there, or the end
      in_extras_ = false;
    } catch (const std::exception& problem) {
      publish_news(done, problem.what());
      rested_ = done;
    }
  }
}

void RenderLoop::fulfil(const Wish& wish) {
  begun_ = Clock::now();
  if (complete_ != wish.revision) {
    const int scene = keeper_.scene();
    load(wish);
    if (keeper_.scene() != scene) begun_ = Clock::now();
    if (!keeper_.any()) return idle_.forget();
    make_pictures(wish);
    if (mailbox_.has_newer(wish.revision)) return;
    complete_ = wish.revision;
  }
  const std::shared_ptr<const Picture> picture = picture_.load();
  if (!view_ || !picture) return idle_.forget();
  const Mailbox::Work work(mailbox_, wish.revision, begun_);
  const InterruptibleWork interruptible(work.stop());
  const JobScene scene{keeper_, *view_, *picture, work.stop()};
  idle_.run(scene);
  if (rested_ != wish.revision) {
    in_extras_ = true;
    idle_.run_extras(scene, wish, [this](Picture shown) { show(std::move(shown)); });
    in_extras_ = false;
  }
}

void RenderLoop::load(const Wish& wish) {
  const Mailbox::Work work(mailbox_, wish.revision, kStays);
  const InterruptibleWork interruptible(work.stop());
  loading_ = true;
  std::string error;
  try {
    keeper_.show(wish.words);
  } catch (const InputError& problem) { error = problem.what(); } catch (const Interrupted&) {
    error = "loading was cancelled";
  } catch (const std::exception& problem) { error = problem.what(); }
  loading_ = false;
  publish_news(wish.revision, error);
}

void RenderLoop::publish_news(std::uint64_t revision, const std::string& error) {
  SceneNews news = keeper_.news();
  news.revision = revision;
  news.error = error;
  counts_.scenes = news.scene;
  news_ = std::make_shared<const SceneNews>(std::move(news));
  tell_();
}

void RenderLoop::make_pictures(const Wish& wish) {
  const auto [width, height] = parse_size(wish.words.size);
  // as far as the words are understood: their scene may be one that cannot be built
  CameraWishes wishes = keeper_.description().camera;
  change_camera(wish.words, wishes);
  const Camera camera = frame(keeper_.built().scene.bounds(), wishes, double(width) / height);
  const RenderSettings final = settings_of(wish.words, keeper_.description().wishes);
  const bool smooth = final.spp > 1 || final.silhouettes || final.coverage;
  if (std::vector<std::string> traced = traced_words(wish.words); traced != traced_) {
    budget_.forget();
    traced_ = std::move(traced);
  }
  if (!make_first_pictures(wish, camera, quick(final), smooth ? Stage::full : Stage::final)) return;
  view_.emplace(camera, width, height);
  if (smooth) show_picture(make_picture(wish, camera, final, Stage::final, 1, begun_), wish);
}

// Up to the full one, each shown as it is done, but one that is coarser than what fits into the budget only
// where there is no time for a finer one, or at the budget's end. false: a newer wish is there.
bool RenderLoop::make_first_pictures(const Wish& wish, const Camera& camera, const RenderSettings& settings,
                                     Stage last) {
  if (wish.hold_full) {
    show_picture(make_picture(wish, camera, settings, last, 1, kStays), wish);
    return !mailbox_.has_newer(wish.revision);
  }
  constexpr double kInTime = 0.8;  // what is shown at the end is seen before the budget's
  const Clock::time_point end = begun_ + milliseconds(kInTime * wish.budget_ms);
  BestInTime best(
      end, [&](Picture picture) { show_picture(std::move(picture), wish); }, [&] { mailbox_.nudge(); });
  const bool known = budget_.knows_previews();
  const int target = budget_.divisor(-ms_since(end));
  Clock::time_point stays_until = end;
  for (int divisor = known ? std::min(4 * target, kCoarsest) : kCoarsest;;) {
    const Stage stage = divisor == 1 ? last : divisor >= target ? Stage::preview : Stage::coarse;
    const Clock::time_point start = Clock::now();
    Picture picture =
        make_picture(wish, camera, settings, stage, divisor, divisor == kCoarsest ? kStays : stays_until);
    const double ms = ms_since(start);
    // a finer one takes at least four times as long: is there time for it?
    const bool keeps = divisor > target && 4 * ms < -ms_since(end);
    if (divisor == 1 || (divisor >= target && !(keeps && known))) budget_.note(divisor, ms);
    if (keeps) best.keep(std::move(picture));
    else best.show_now(std::move(picture)), stays_until = begun_;
    if (mailbox_.has_newer(wish.revision) && Clock::now() >= stays_until) return false;
    if (divisor == 1) return true;
    divisor = divisor > target                                       ? std::max(target, divisor / 4)
              : divisor <= 4 || budget_.full_is_near(wish.budget_ms) ? 1
                                                                     : divisor / 4;
  }
}

Picture RenderLoop::make_picture(const Wish& wish, const Camera& camera, const RenderSettings& settings,
                                 Stage stage, int divisor, Clock::time_point stays_until) {
  const auto [width, height] = parse_size(wish.words.size);
  const View view(camera, (width + divisor - 1) / divisor, (height + divisor - 1) / divisor);
  if (divisor == 1 && keeper_.choose_methods()) publish_news(wish.revision, {});
  const Clock::time_point start = Clock::now();
  const auto film = std::make_shared<Film>(view.width(), view.height(), layers_of(wish.overlay));
  Progress progress("rendering", tile_count(view));
  Mailbox::Work work(mailbox_, wish.revision, stays_until, &progress);
  Picture picture;
  try {
    const Scene& scene = stage == Stage::preview ? keeper_.preview_scene() : keeper_.built().scene;
    picture.counts = render(scene, view, settings, *film, work.stop(), &progress);
  } catch (const Interrupted&) {
    const StopMoment& stopped = work.stopped();
    ++counts_.cancelled;
    counts_.tiles_rendered += progress.done();
    counts_.tiles_cancelled += tile_count(view) - progress.done();
    counts_.tiles_after_end = std::max(counts_.tiles_after_end.load(), progress.done() - stopped.tiles);
    raise_to(counts_.longest_end_ms, ms_since(stopped.time));
    if (stage == Stage::preview || divisor == 1) budget_.note_ended(divisor, ms_since(start));
    if (first_of_ != wish.revision) note_first(wish);
    throw;
  }
  counts_.tiles_rendered += progress.done();
  picture.ms = ms_since(start);
  picture.rgba = screen_pixels(*film, wish.overlay);
  picture.film = film;
  picture.revision = wish.revision;
  picture.stage = stage;
  picture.divisor = divisor;
  picture.width = view.width(), picture.height = view.height();
  return picture;
}

void RenderLoop::show_picture(Picture picture, const Wish& wish) {
  picture.latency_ms = ms_since(wish.made);
  ++counts_.pictures[static_cast<std::size_t>(picture.stage)];
  if (first_of_ != wish.revision) {
    first_of_ = wish.revision;
    counts_.first.add(picture.latency_ms);
    note_first(wish);
  }
  if (picture.stage == Stage::final) counts_.complete.add(picture.latency_ms);
  show(std::move(picture));
}

// The first picture of a wish is there, or will never be.
void RenderLoop::note_first(const Wish& wish) {
  if (wish.hold_full) return;
  const double ms = ms_since(begun_);
  raise_to(counts_.longest_preview_ms, ms);
  counts_.late_previews += ms > wish.budget_ms;
}

void RenderLoop::show(Picture picture) {
  picture_ = std::make_shared<const Picture>(std::move(picture));
  tell_();
}

}  // namespace isocast::viewer
