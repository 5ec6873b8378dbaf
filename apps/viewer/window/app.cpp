#include <fmt/format.h>
#include <imgui.h>
#include <isocast/apps/viewer/command_line.h>
#include <isocast/apps/viewer/window/app.h>
#include <isocast/apps/viewer/window/panels.h>
#include <isocast/base/error.h>
#include <isocast/render/image_file.h>

#include <ctime>

namespace isocast::viewer {
namespace {

double processor_ms() {
  timespec now = {};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

// With a size of its own, the picture decides how large the window is.
WindowWishes window_for(const ViewRequest& request) {
  return {request.window_width, request.window_height, request.scale};
}

}  // namespace

App::App(const ViewRequest& made)
    : request(made), session(start_session(made.words)), window(window_for(made)), loop(&Window::wake) {
  for (Texture* const one : {&texture, &other_texture}) {
    one->load(1, 1, {0, 0, 0, 0});
    one->set_smooth(one == &texture);
  }
}

std::array<int, 2> App::picture_size() const {
  return request.fixed_size ? parse_size(request.words.size) : canvas;
}

std::optional<Camera> App::camera() const {
  if (session.camera) return session.camera;
  const auto [width, height] = picture_size();
  if (!news->any || width < 1 || height < 1) return std::nullopt;
  return isocast::frame(news->bounds, news->camera, double(width) / height);
}

RenderWords App::picture_words() const {
  const auto [width, height] = picture_size();
  return words_of(session, width, height, clip_formulas(planes, news->bounds));
}

const ObjectNews& App::object_news() const {
  static const ObjectNews nothing;
  return session.current < news->objects.size() ? news->objects[session.current] : nothing;
}

std::shared_ptr<const VolumeStatistics> App::statistics() const {
  const auto of_volumes = loop.idle().statistics.load();
  const bool mine = of_volumes && loop.idle().scene == news->scene && session.current < of_volumes->size();
  return mine ? (*of_volumes)[session.current] : nullptr;
}

void App::copy_command() {
  try {
    const RenderWords words = write_scene(session, picture_words(), output);
    ImGui::SetClipboardText(command_line(words, output).c_str());
    message = words.input == picture_words().input ? "copied" : "copied, with " + words.input;
  } catch (const InputError& problem) { message = problem.what(); }
}

void App::open(const std::string& input) {
  RenderWords words = session.words;
  words.input = input;
  words.iso.clear();
  for (std::string* text : {&words.position, &words.target, &words.up, &words.domain}) text->clear();
  words.params.clear();
  words.method = "auto";
  words.camera.clear();
  words.set.clear();
  if (words.aa != "spp") words.aa.clear();  // the others are for formulas
  try {
    session = start_session(words);
  } catch (const InputError& problem) {
    message = problem.what();
    return;
  }
  planes.clear();
  probe_open = false;
}

void App::save(const std::string& file) {
  loop.post([this, file](const JobScene& scene) {
    const Film& film = *scene.picture.film;
    std::string said = "saved " + file;
    try {
      if (file.ends_with(".exr")) write_exr(file, film.width(), film.height(), image_layers(film));
      else if (file.ends_with(".png")) write_png(file, film.width(), film.height(), film.color().data());
      else said = fmt::format("{}: expected a name that ends with .png or .exr", file);
    } catch (const InputError& problem) { said = problem.what(); }
    new_message = std::make_shared<const std::string>(said);
  });
}

void App::probe(int x, int y) {
  probe_open = true;
  loop.post([this, x, y, chosen = session.current](const JobScene& scene) {
    new_probe = std::make_shared<const PixelProbe>(probe_pixel(scene, x, y, chosen));
  });
}

// Iso-values that the scene has by itself, and which may change from frame to frame.
void App::adopt_news() {
  if (!news->error.empty() || news->objects.size() != session.objects.size()) return;
  const bool newest = news->revision == asked_revision_;
  for (std::size_t k = 0; k < session.objects.size(); ++k) {
    SessionObject& object = session.objects[k];
    const bool animated = session.frame && newest && object.surfaces == object.adopted;
    if (object.surfaces.empty() || animated)
      adopt_surfaces(object, news->objects[k].iso, news->objects[k].materials);
  }
}

void App::take_results() {
  if (const auto now = loop.news(); now && now != news) {
    news = now;
    adopt_news();
  }
  if (auto now = new_probe.exchange(nullptr)) probed = now;
  if (auto now = new_message.exchange(nullptr)) message = *now;
  if (const auto now = loop.picture(); now && now != shown) {
    shown = now;
    texture.load(now->width, now->height, now->rgba);
    texture.set_smooth(now->divisor > 1);
    if (!now->other.empty()) {
      other_texture.load(now->width, now->height, now->other);
      other_texture.set_smooth(false);
    }
  }
  for (const std::string& file : window.take_dropped()) open(file);
}

void App::ask() {
  const auto [width, height] = picture_size();
  if (width < 1 || height < 1) return;
  Wish wish;
  wish.words = picture_words();
  wish.hold_full = hold_full;
  wish.budget_ms = request.budget_ms;
  wish.overlay = overlay;
  wish.other = other_method;
  wish.points = points;
  const bool of_object = points || overlay == Overlay::error || overlay == Overlay::difference;
  wish.object = of_object ? session.current : 0;  // another choice alone asks for no other picture
  const auto same = [&](const Wish& a, const Wish& b) {
    return a.words == b.words && a.hold_full == b.hold_full && a.overlay == b.overlay && a.other == b.other &&
           a.points == b.points && a.object == b.object;
  };
  settled = same(wish, asked_);
  if (settled) return;
  asked_ = wish;
  asked_revision_ = loop.ask(std::move(wish));
  settled = true;
}

// Seconds without a frame, unless an event or a result comes: drawing takes the processors from rendering.
double App::patience() const {
  constexpr double kMoving = 1.0 / 120, kProgress = 1.0 / 20, kResting = 0.25;
  if (lively_ > 0 || playing || times.frames < 6) return kMoving;
  return loop.loading() ? kProgress : kResting;
}

void App::frame() {
  constexpr int kLively = 3;  // until widgets have settled
  lively_ = window.begin_frame(patience()) ? kLively : lively_ - (lively_ > 0);
  const double start = processor_ms();
  take_results();
  draw_interface(*this);
  try {
    ask();
  } catch (const InputError& problem) { message = problem.what(); }
  window.draw();
  landmarks.publish(window.position());
  times.last_ms = processor_ms() - start;
  times.longest_ms = std::max(times.longest_ms, times.frames > 5 ? times.last_ms : 0);
  times.slow += times.frames > 5 && times.last_ms > 16;
  ++times.frames;
  resting = at_rest();
}

}  // namespace isocast::viewer
