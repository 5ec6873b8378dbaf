#include <X11/Xatom.h>
#include <X11/Xlib.h>
// X's macros end here
#undef None
#include <fmt/format.h>
#include <isocast/apps/viewer/script/neighbour.h>
#include <isocast/base/error.h>

#include <chrono>
#include <filesystem>

namespace isocast::viewer {
namespace {

constexpr ::Window kNoWindow = 0;

}  // namespace

struct Neighbour::Connection {
  Display* display = XOpenDisplay(nullptr);
  ::Window own = kNoWindow;

  Connection() {
    if (!display) throw InputError("--script: found no X server");
    own = XCreateSimpleWindow(display, DefaultRootWindow(display), 0, 0, 1, 1, 0, 0, 0);
  }
  ~Connection() {
    if (display) XCloseDisplay(display);
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  [[nodiscard]] Atom atom(const char* name) const { return XInternAtom(display, name, False); }

  // The window under a place of the screen that takes files; none: kNoWindow.
  [[nodiscard]] ::Window target_at(int x, int y) const {
    ::Window window = DefaultRootWindow(display), child = kNoWindow;
    const ::Window root = window;
    for (int own_x = 0, own_y = 0;; window = child) {
      Atom type = 0;
      int format = 0;
      unsigned long count = 0, left = 0;
      unsigned char* data = nullptr;
      XGetWindowProperty(display, window, atom("XdndAware"), 0, 1, False, AnyPropertyType, &type, &format,
                         &count, &left, &data);
      if (data) XFree(data);
      if (type != 0) return window;
      if (!XTranslateCoordinates(display, root, window, x, y, &own_x, &own_y, &child) || child == kNoWindow)
        return kNoWindow;
    }
  }

  void tell(::Window target, const char* message, long a, long b, long c, long d, long e) const {
    XEvent event = {};
    event.xclient.type = ClientMessage;
    event.xclient.display = display;
    event.xclient.window = target;
    event.xclient.message_type = atom(message);
    event.xclient.format = 32;
    const long values[] = {a, b, c, d, e};
    for (int i = 0; i < 5; ++i) event.xclient.data.l[i] = values[i];
    XSendEvent(display, target, False, NoEventMask, &event);
    XFlush(display);
  }

  // The next event that `is` says yes to; of others none is of interest.
  template <class Is> XEvent wait_for(const char* what, const std::function<void()>& pause, Is is) const {
    using Clock = std::chrono::steady_clock;
    for (const Clock::time_point end = Clock::now() + std::chrono::seconds(20); Clock::now() < end; pause())
      while (XPending(display) > 0) {
        XEvent event;
        XNextEvent(display, &event);
        if (is(event)) return event;
      }
    throw InputError(fmt::format("waited in vain for {}", what));
  }
  [[nodiscard]] XEvent wait_for_message(const char* message, const std::function<void()>& pause) const {
    return wait_for(message, pause, [&](const XEvent& event) {
      return event.type == ClientMessage && event.xclient.message_type == atom(message);
    });
  }

  void answer(const XSelectionRequestEvent& request, const std::string& text) const {
    XChangeProperty(display, request.requestor, request.property, request.target, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size()));
    XEvent event = {};
    event.xselection = {
        SelectionNotify,  0,           True, display, request.requestor, request.selection, request.target,
        request.property, request.time};
    XSendEvent(display, request.requestor, False, NoEventMask, &event);
    XFlush(display);
  }
};

Neighbour::Neighbour() : connection_(std::make_unique<Connection>()) {}
Neighbour::~Neighbour() = default;

void Neighbour::drop(const std::string& file, int x, int y, const std::function<void()>& pause) {
  const Connection& c = *connection_;
  const ::Window target = c.target_at(x, y);
  if (target == kNoWindow) throw InputError("no window there takes files");
  const auto own = static_cast<long>(c.own);
  XSetSelectionOwner(c.display, c.atom("XdndSelection"), c.own, CurrentTime);
  constexpr long kVersion = 5;
  c.tell(target, "XdndEnter", own, kVersion << 24, static_cast<long>(c.atom("text/uri-list")), 0, 0);
  c.tell(target, "XdndPosition", own, 0, long(x) << 16 | y, CurrentTime,
         static_cast<long>(c.atom("XdndActionCopy")));
  const XEvent status = c.wait_for_message("XdndStatus", pause);
  if ((status.xclient.data.l[1] & 1) == 0) throw InputError("the window does not take the file");
  c.tell(target, "XdndDrop", own, 0, CurrentTime, 0, 0);
  const XEvent request =
      c.wait_for("a request", pause, [](const XEvent& event) { return event.type == SelectionRequest; });
  c.answer(request.xselectionrequest, "file://" + std::filesystem::absolute(file).string() + "\r\n");
  (void)c.wait_for_message("XdndFinished", pause);
}

std::string Neighbour::clipboard(const std::function<void()>& pause) {
  const Connection& c = *connection_;
  const Atom text = c.atom("UTF8_STRING"), place = c.atom("ISOCAST_CLIPBOARD");
  XConvertSelection(c.display, c.atom("CLIPBOARD"), text, place, c.own, CurrentTime);
  const XEvent answer =
      c.wait_for("the clipboard", pause, [](const XEvent& event) { return event.type == SelectionNotify; });
  if (answer.xselection.property == 0) throw InputError("the clipboard holds no text");
  Atom type = 0;
  int format = 0;
  unsigned long count = 0, left = 0;
  unsigned char* data = nullptr;
  constexpr long kMost = 1 << 20;
  XGetWindowProperty(c.display, c.own, place, 0, kMost, True, text, &type, &format, &count, &left, &data);
  const std::string copied(reinterpret_cast<const char*>(data), data && format == 8 ? count : 0);
  if (data) XFree(data);
  return copied;
}

}  // namespace isocast::viewer
