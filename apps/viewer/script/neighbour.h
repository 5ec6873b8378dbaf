// Another program on the same X server: files are dragged from it, and what was copied is pasted there.
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace isocast::viewer {

/// Speaks to the window through the X server alone. pause: called while an answer is awaited; may throw.
class Neighbour {
 public:
  /// Throws InputError without an X server.
  Neighbour();
  ~Neighbour();
  Neighbour(const Neighbour&) = delete;
  Neighbour& operator=(const Neighbour&) = delete;

  /// Drops a file at a place of the screen, in pixels. Throws InputError where no window takes it.
  ///
  /// source  Drag-and-Drop Protocol for the X Window System (XDND), version 5
  void drop(const std::string& file, int x, int y, const std::function<void()>& pause);

  /// The text in the clipboard. Throws InputError where there is none.
  [[nodiscard]] std::string clipboard(const std::function<void()>& pause);

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;
};

}  // namespace isocast::viewer
