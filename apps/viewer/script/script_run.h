// A script drives the window in a thread of its own, as a person does: it looks where things are, moves the
// mouse there, and waits.
#pragma once

#include <isocast/apps/viewer/script/neighbour.h>
#include <isocast/apps/viewer/script/pointer.h>
#include <isocast/apps/viewer/script/script.h>
#include <isocast/apps/viewer/window/app.h>

#include <exception>
#include <thread>

namespace isocast::viewer {

/// Between the script and the window's thread.
class ScriptRun {
 public:
  /// Throws InputError for a script that cannot be used, or without XTEST.
  ScriptRun(App& app, const std::filesystem::path& file);
  ~ScriptRun() { ended_ = true; }

  /// To be called after each frame that was presented: takes the screenshots. Throws what ended the script.
  void after_frame();

 private:
  void run(const ScriptCommand& command);
  void set_iso(double value);
  void drag(Button button, double dx, double dy);
  void choose(const std::string& list, const std::string& name);
  void enter(const std::string& field, const std::string& text);
  void click(const Landmark& place);
  void click(double x, double y);
  void press_key(const char* name);
  void chord(const char* modifier, char c);
  /// Where it is, after its section was opened and scrolled into sight.
  Landmark reveal(const std::string& name);
  void scroll(const Landmark& panel, bool down);
  /// Two more frames: whatever happened before is seen.
  void settle();
  void wait_until(const char* what, const std::function<bool()>& done);

  App& app_;
  std::vector<ScriptCommand> commands_;
  Pointer pointer_;
  Neighbour neighbour_;
  std::atomic<bool> ended_ = false;
  std::atomic<std::shared_ptr<const std::string>> screenshot_;
  std::atomic<bool> failed_ = false;
  std::exception_ptr failure_;
  std::jthread thread_;
};

}  // namespace isocast::viewer
