// Everything behind the window: what is wanted, what came back, and what the panels remember.
#pragma once

#include <isocast/apps/viewer/clip_planes.h>
#include <isocast/apps/viewer/probe_work.h>
#include <isocast/apps/viewer/render_loop.h>
#include <isocast/apps/viewer/session.h>
#include <isocast/apps/viewer/viewer_module.h>
#include <isocast/apps/viewer/window/landmarks.h>
#include <isocast/apps/viewer/window/texture.h>
#include <isocast/apps/viewer/window/window.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace isocast::viewer {

/// Text that is being typed and what it was when the words last agreed with it.
struct TypedText {
  std::string text, agreed;
};

/// How long the interface's thread worked on its frames, in processor time, without waiting for the screen.
struct FrameTimes {
  std::int64_t frames = 0, slow = 0;  // slow: over 16 ms
  double longest_ms = 0, last_ms = 0;
};

struct App {
  explicit App(const ViewRequest& request);

  /// One turn of the interface: waits until there is something to do, takes what is new, draws, asks for what
  /// is wanted now.
  void frame();
  /// The picture's size in pixels.
  [[nodiscard]] std::array<int, 2> picture_size() const;
  /// The camera in use; none before there is a scene.
  [[nodiscard]] std::optional<Camera> camera() const;
  /// The words that make the picture.
  [[nodiscard]] RenderWords picture_words() const;
  /// What is known of the object that the panels show, and the statistics of its volume or null.
  [[nodiscard]] const ObjectNews& object_news() const;
  [[nodiscard]] std::shared_ptr<const VolumeStatistics> statistics() const;
  /// Copies the command line that makes the picture; writes the scene file that it needs.
  void copy_command();
  /// Another input, without what belonged to the one before.
  void open(const std::string& input);
  void save(const std::string& path);
  void probe(int x, int y);
  /// All that was asked for is done and shown.
  [[nodiscard]] bool at_rest() const { return loop.at_rest() && shown == loop.picture() && settled; }

  ViewRequest request;
  Session session;
  Window window;
  Landmarks landmarks;
  Texture texture, other_texture;

  // what is wanted beside the session
  Overlay overlay = Overlay::none;
  std::string other_method;
  bool hold_full = false, points = false, playing = false, blender_mouse = false;
  double divider = 0.5;
  std::vector<ClipPlane> planes;

  // what came back
  std::shared_ptr<const Picture> shown;
  std::shared_ptr<const SceneNews> news = std::make_shared<const SceneNews>();
  std::shared_ptr<const PixelProbe> probed;
  std::atomic<std::shared_ptr<const PixelProbe>> new_probe;
  std::atomic<std::shared_ptr<const std::string>> new_message;
  std::string message;

  // what the panels remember
  TypedText formula, domain, path, color_of, color_map, color_range;
  std::string output = "picture.png";
  std::map<std::string, std::string> fields;  // numbers as they are typed, by landmark
  std::string editing;                        // the one that has the keyboard
  double enclosed = 50, profile_zoom = 1, iso_reach = 1;
  double played_frames = 0;  // since the last whole one
  int dragged_iso = -1;
  bool probe_open = false;
  std::array<int, 2> canvas = {0, 0};
  FrameTimes times;
  bool settled = false;
  std::atomic<bool> resting = false;

  RenderLoop loop;  // goes first: its work writes to what came back

 private:
  [[nodiscard]] double patience() const;
  void take_results();
  void adopt_news();
  void ask();
  Wish asked_;
  std::uint64_t asked_revision_ = 0;
  int lively_ = 0;  // frames that an event still has coming
};

}  // namespace isocast::viewer
