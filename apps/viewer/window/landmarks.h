// Where the widgets are, by name: what a person sees and a script must know.
#pragma once

#include <array>
#include <map>
#include <mutex>
#include <optional>
#include <string>

namespace isocast::viewer {

/// On the screen, in pixels. `seen`: none of it is scrolled out of sight.
struct Landmark {
  double x0, y0, x1, y1;
  bool seen = true;
};

/// The interface's thread writes a frame's landmarks and publishes them at its end; any thread reads the last
/// frame's.
class Landmarks {
 public:
  /// Of the last widget. A name is SECTION.WIDGET, or section.NAME for a section's header.
  void mark(const std::string& name);
  void mark(const std::string& name, const Landmark& place);
  /// ends a frame; (x, y): the window on the screen
  void publish(const std::array<int, 2>& window);

  [[nodiscard]] std::optional<Landmark> find(const std::string& name) const;
  /// Counts published frames.
  [[nodiscard]] std::uint64_t frame() const;

 private:
  std::map<std::string, Landmark> next_, shown_;
  std::uint64_t frame_ = 0;
  mutable std::mutex mutex_;
};

}  // namespace isocast::viewer
