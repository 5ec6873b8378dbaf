#include <fmt/format.h>
#include <isocast/apps/viewer/script/script_run.h>
#include <isocast/base/error.h>
#include <isocast/base/output_file.h>
#include <isocast/render/image_file.h>
#include <isocast/scene/srgb.h>

#include <algorithm>
#include <cmath>

namespace isocast::viewer {
namespace {

// The section of the panel that holds a widget.
std::string section_of(const std::string& name) {
  const std::string prefix = name.substr(0, name.find('.'));
  const bool input = prefix == "formula" || prefix == "param" || prefix == "time" || prefix == "frame";
  return "section." + (input ? "input" : prefix);
}

}  // namespace

ScriptRun::ScriptRun(App& app, const std::filesystem::path& file) : app_(app), commands_(read_script(file)) {
  thread_ = std::jthread([this, file] {
    for (const ScriptCommand& command : commands_) {
      try {
        run(command);
      } catch (const Interrupted&) { return; } catch (const std::exception& problem) {
        failure_ = std::make_exception_ptr(InputError(
            fmt::format("{}:{}: {}: {}", file.string(), command.line, command.name, problem.what())));
        failed_ = true;
        Window::wake();
        return;
      }
    }
  });
}

void ScriptRun::after_frame() {
  if (failed_) std::rethrow_exception(failure_);
  const auto file = screenshot_.load();
  if (!file) return;
  const auto [width, height] = app_.window.size();
  const std::vector<std::uint8_t> rgb = app_.window.pixels();
  std::vector<float> rgba(rgb.size() / 3 * 4, 1.0f);
  for (std::size_t i = 0; i < rgb.size(); ++i)
    rgba[i / 3 * 4 + i % 3] = static_cast<float>(linear_from_srgb(rgb[i] / 255.0));
  write_png(*file, width, height, rgba.data());
  screenshot_.store(nullptr);
}

void ScriptRun::run(const ScriptCommand& command) {
  const std::vector<std::string>& words = command.words;
  const auto number = [&](std::size_t i) { return std::stod(words[i]); };
  const std::string& name = command.name;
  if (name == "wait") wait_until("the picture", [&] { return app_.resting.load(); });
  else if (name == "iso") set_iso(number(0));
  else if (name == "orbit") drag(Button::left, number(0), number(1));
  else if (name == "pan") drag(Button::middle, number(0), number(1));
  else if (name == "zoom") {
    const Landmark place = reveal("canvas.picture");
    pointer_.move(0.4 * place.x0 + 0.6 * place.x1, 0.6 * place.y0 + 0.4 * place.y1);
    settle();
    for (int i = 0; i < std::abs(number(0)); ++i) {
      const Button wheel = number(0) > 0 ? Button::wheel_up : Button::wheel_down;
      pointer_.press(wheel, true);
      pointer_.press(wheel, false);
      settle();
    }
  } else if (name == "method") choose("method.name", words[0]);
  else if (name == "overlay") choose("sure.overlay", words[0]);
  else if (name == "object") click(reveal("objects." + words[0]));
  else if (name == "press") click(reveal(words[0]));
  else if (name == "type") enter(words[0], words[1]);
  else if (name == "key") press_key(words[0].c_str());
  else if (name == "drop") {
    const Landmark place = reveal("canvas.picture");
    neighbour_.drop(words[0], int(place.x0) + 9, int(place.y0) + 9, [this] { settle(); });
    settle();
  } else if (name == "clipboard")
    write_text_file(words[0], neighbour_.clipboard([this] { settle(); }) + "\n");
  else if (name == "formula")
    enter(app_.landmarks.find("input.path") ? "input.path" : "formula.text", words[0]);
  else if (name == "time") enter("time.value", words[0]);
  else if (name == "frame") enter("frame.value", words[0]);
  else if (name == "param") enter("param." + words[0], words[1]);
  else if (name == "click") {
    const Landmark place = reveal("canvas.picture");
    click(place.x0 + number(0) + 0.5, place.y0 + number(1) + 0.5);
  } else if (name == "screenshot") {
    settle();
    screenshot_ = std::make_shared<const std::string>(words[0]);
    wait_until("the screenshot", [&] { return !screenshot_.load(); });
  } else if (name == "save") {
    enter("output.file", words[0]);
    click(reveal("output.save"));
    wait_until("the file", [&] { return app_.resting.load(); });
  } else if (name == "quit") chord("Control_L", 'q');
}

// The handle is dragged as near as pixels allow; the rest is typed.
void ScriptRun::set_iso(double value) {
  const Landmark slider = reveal("iso.slider"), range = *app_.landmarks.find("iso.range"),
                 handle = reveal("iso.handle");
  const double share = std::clamp((value - range.x0) / (range.x1 - range.x0), 0.0, 1.0),
               to = slider.x0 + share * (slider.x1 - slider.x0), y = 0.5 * (slider.y0 + slider.y1);
  pointer_.move(handle.x0, y);
  settle();
  pointer_.press(Button::left, true);
  settle();
  constexpr int kSteps = 20;
  for (int i = 1; i <= kSteps; ++i) {
    pointer_.move(std::lerp(handle.x0, to, double(i) / kSteps), y);
    settle();
  }
  pointer_.press(Button::left, false);
  settle();
  enter("iso.value", fmt::format("{}", value));
}

void ScriptRun::drag(Button button, double dx, double dy) {
  const Landmark place = reveal("canvas.picture");
  const double x = 0.4 * place.x0 + 0.6 * place.x1, y = 0.6 * place.y0 + 0.4 * place.y1;
  pointer_.move(x, y);
  settle();
  pointer_.press(button, true);
  settle();
  constexpr int kSteps = 10;
  for (int i = 1; i <= kSteps; ++i) {
    pointer_.move(x + dx * i / kSteps, y + dy * i / kSteps);
    settle();
  }
  pointer_.press(button, false);
  settle();
}

void ScriptRun::choose(const std::string& list, const std::string& name) {
  click(reveal(list));
  const std::string row = list + "." + name;
  wait_until(("'" + name + "' in the list").c_str(), [&] { return app_.landmarks.find(row).has_value(); });
  click(*app_.landmarks.find(row));
}

void ScriptRun::enter(const std::string& field, const std::string& text) {
  click(reveal(field));
  chord("Control_L", 'a');
  for (const char c : text) pointer_.type(c);
  settle();
  press_key("Return");
}

void ScriptRun::click(const Landmark& place) {
  click(0.5 * (place.x0 + place.x1), 0.5 * (place.y0 + place.y1));
}

void ScriptRun::click(double x, double y) {
  pointer_.move(x, y);
  settle();
  pointer_.press(Button::left, true);
  settle();
  pointer_.press(Button::left, false);
  settle();
}

void ScriptRun::press_key(const char* name) {
  pointer_.key(name, true);
  settle();
  pointer_.key(name, false);
  settle();
}

void ScriptRun::chord(const char* modifier, char c) {
  const char name[] = {c, 0};
  pointer_.key(modifier, true);
  pointer_.key(name, true);
  settle();
  pointer_.key(name, false);
  pointer_.key(modifier, false);
  settle();
}

Landmark ScriptRun::reveal(const std::string& name) {
  const std::string section = section_of(name);
  wait_until(name.c_str(), [&] { return app_.landmarks.find(name) || app_.landmarks.find(section); });
  if (!app_.landmarks.find(name)) click(reveal(section));
  settle();
  wait_until(name.c_str(), [&] { return app_.landmarks.find(name).has_value(); });
  constexpr int kMost = 100;
  for (int i = 0; i < kMost; ++i) {
    const Landmark place = *app_.landmarks.find(name);
    if (place.seen) return place;
    const Landmark panel = *app_.landmarks.find("panel");
    scroll(panel, place.y1 > panel.y1);
  }
  throw InputError(name + " cannot be scrolled into sight");
}

void ScriptRun::scroll(const Landmark& panel, bool down) {
  const Button wheel = down ? Button::wheel_down : Button::wheel_up;
  pointer_.move(panel.x0 + 3, 0.5 * (panel.y0 + panel.y1));
  settle();
  pointer_.press(wheel, true);
  pointer_.press(wheel, false);
  settle();
}

void ScriptRun::settle() {
  const std::uint64_t from = app_.landmarks.frame();
  constexpr int kFrames = 2;
  while (app_.landmarks.frame() < from + kFrames) {
    if (ended_) throw Interrupted();
    Window::wake();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void ScriptRun::wait_until(const char* what, const std::function<bool()>& done) {
  const Clock::time_point start = Clock::now();
  constexpr double kLongest = 120e3;
  for (settle(); !done(); std::this_thread::sleep_for(std::chrono::milliseconds(1))) {
    if (ended_) throw Interrupted();
    if (ms_since(start) > kLongest) throw InputError(fmt::format("waited two minutes for {}", what));
  }
}

}  // namespace isocast::viewer
