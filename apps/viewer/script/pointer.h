// A mouse and a keyboard made of the X server's own test events: the window cannot tell them from a person's.
#pragma once

#include <memory>
#include <string>

namespace isocast::viewer {

enum class Button : unsigned { left = 1, middle = 2, right = 3, wheel_up = 4, wheel_down = 5 };

class Pointer {
 public:
  /// Opens a connection of its own. Throws InputError without an X server that has XTEST.
  Pointer();
  ~Pointer();
  Pointer(const Pointer&) = delete;
  Pointer& operator=(const Pointer&) = delete;

  /// Pixels of the screen.
  void move(double x, double y);
  void press(Button button, bool down);
  /// Printable ASCII, by the keys of the keyboard's current layout. Throws InputError for what no key makes.
  void type(char c);
  /// Keys by X's names: "Return", "Control_L".
  void key(const char* name, bool down);

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;
};

}  // namespace isocast::viewer
