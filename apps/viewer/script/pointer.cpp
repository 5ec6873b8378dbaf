#include <X11/XKBlib.h>
#include <X11/Xlib.h>
#include <X11/extensions/XTest.h>
#include <X11/keysym.h>
// X's macros end here
#undef None
#include <fmt/format.h>
#include <isocast/apps/viewer/script/pointer.h>
#include <isocast/base/error.h>

#include <cmath>

namespace isocast::viewer {

struct Pointer::Connection {
  Display* display = XOpenDisplay(nullptr);
  ~Connection() {
    if (display) XCloseDisplay(display);
  }
};

Pointer::Pointer() : connection_(std::make_unique<Connection>()) {
  int event = 0, error = 0, major = 0, minor = 0;
  if (!connection_->display || !XTestQueryExtension(connection_->display, &event, &error, &major, &minor))
    throw InputError("--script: found no X server with the extension XTEST");
}
Pointer::~Pointer() = default;

void Pointer::move(double x, double y) {
  XTestFakeMotionEvent(connection_->display, -1, static_cast<int>(std::floor(x)),
                       static_cast<int>(std::floor(y)), 0);
  XSync(connection_->display, False);
}

void Pointer::press(Button button, bool down) {
  XTestFakeButtonEvent(connection_->display, static_cast<unsigned>(button), down, 0);
  XSync(connection_->display, False);
}

void Pointer::type(char c) {
  Display* const display = connection_->display;
  const auto wanted = static_cast<KeySym>(static_cast<unsigned char>(c));  // Latin-1's are their codes
  int first = 0, last = 0;
  XDisplayKeycodes(display, &first, &last);
  for (int code = first; code <= last; ++code)
    for (int level = 0; level < 2; ++level) {
      if (XkbKeycodeToKeysym(display, static_cast<KeyCode>(code), 0, level) != wanted) continue;
      if (level) key("Shift_L", true);
      XTestFakeKeyEvent(display, static_cast<unsigned>(code), True, 0);
      XTestFakeKeyEvent(display, static_cast<unsigned>(code), False, 0);
      if (level) key("Shift_L", false);
      XSync(display, False);
      return;
    }
  throw InputError(fmt::format("--script: no key of this keyboard types '{}'", c));
}

void Pointer::key(const char* name, bool down) {
  Display* const display = connection_->display;
  XTestFakeKeyEvent(display, XKeysymToKeycode(display, XStringToKeysym(name)), down, 0);
  XSync(display, False);
}

}  // namespace isocast::viewer
