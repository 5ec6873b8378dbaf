// A window of the system with OpenGL 3.3 and the interface's library in it.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

struct GLFWwindow;

namespace isocast::viewer {

/// Sizes in pixels; `scale` of text and widgets: 1 at 96 dots per inch; 0: the screen's own.
struct WindowWishes {
  int width = 1280, height = 800;
  double scale = 0;
};

/// Of the thread that made it, but for wake().
class Window {
 public:
  /// Throws InputError where there is no display or no OpenGL 3.3.
  explicit Window(const WindowWishes& wishes);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Waits for events, at most so long, and begins a frame of the interface. Returns whether the mouse, the
  /// keyboard or the system had something to say.
  bool begin_frame(double wait_seconds);
  /// Draws the frame's widgets; present() shows them.
  void draw();
  void present();

  [[nodiscard]] bool wants_to_close() const;
  void close();
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] std::array<int, 2> size() const;
  /// Of the upper left corner, on the screen.
  [[nodiscard]] std::array<int, 2> position() const;
  void toggle_full_screen();
  /// The whole window as it was drawn last: RGB of 8 bits, rows from the top.
  [[nodiscard]] std::vector<std::uint8_t> pixels() const;
  /// Names of files that were dropped since the last call.
  [[nodiscard]] std::vector<std::string> take_dropped();
  [[nodiscard]] const std::string& renderer() const { return renderer_; }
  /// Ends the wait for events; from any thread.
  static void wake();

 private:
  static std::atomic<bool> woken_;
  GLFWwindow* window_ = nullptr;
  double scale_ = 1;
  std::string renderer_;
  std::vector<std::string> dropped_;
  std::array<int, 4> windowed_ = {};
};

}  // namespace isocast::viewer
