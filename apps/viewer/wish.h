// What is asked of the render loop, and what it answers.
#pragma once

#include <isocast/apps/isocast/render_words.h>
#include <isocast/render/render.h>
#include <isocast/volume/statistics.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace isocast::viewer {

using Clock = std::chrono::steady_clock;
[[nodiscard]] inline Clock::duration milliseconds(double ms) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double, std::milli>(ms));
}
[[nodiscard]] inline double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// What lies over the picture. error and difference are made when the picture is complete.
enum class Overlay : std::uint8_t { none, certificate, cost, error, difference };

/// A picture that is wanted.
///
/// words      as for `isocast render`, with its size and camera
/// hold_full  never a preview; budget_ms: what a preview may take
/// object     the one that errors, a second picture and points are of
/// other      method of the second picture of Overlay::difference
/// points     error and time of every method in this view are wanted, when the picture is complete
struct Wish {
  std::uint64_t revision = 0;
  RenderWords words;
  bool hold_full = false;
  double budget_ms = 33;
  Overlay overlay = Overlay::none;
  std::size_t object = 0;
  std::string other;
  bool points = false;
  Clock::time_point made = Clock::now();
};

/// preview: within the frame budget; coarse: on the way to full; full: one sample a pixel; final: what
/// `isocast render` makes, the same as full where one sample is asked for.
enum class Stage : std::uint8_t { preview, coarse, full, final };

/// A finished picture, rows from the top, RGBA of 8 bits (sRGB, opaque).
///
/// divisor     pixels of the full picture along a side of its own
/// other       the second method's picture, or empty
/// ms          of rendering; latency_ms: from the wish to this picture
struct Picture {
  std::uint64_t revision = 0;
  Stage stage = Stage::preview;
  int width = 0, height = 0, divisor = 1;
  std::vector<std::uint8_t> rgba, other;
  std::shared_ptr<const Film> film;
  RenderCounts counts;
  double ms = 0, latency_ms = 0;
};

/// What is known of an object. iso, materials: of a mesh, a csg or instances one for the whole; without
/// methods there is none to choose.
struct ObjectNews {
  bool is_volume = false;
  std::vector<double> iso;
  std::vector<Material> materials;
  std::string method, method_reason;
  std::vector<std::string> methods;
};

/// What is known of the scene behind the pictures. error: why the newest wish cannot be fulfilled, else
/// empty; the scene is then the one before.
struct SceneNews {
  std::uint64_t revision = 0;
  std::string error;
  bool any = false, proves = false;
  Box bounds;
  CameraWishes camera;  // what is fixed of it
  std::vector<ObjectNews> objects;
  std::string isa, type;
  std::vector<std::string> features, left_out;
  std::int64_t volume_bytes = 0, acceleration_bytes = 0;
  double load_ms = 0, build_ms = 0;
  int scene = 0;  // counts scenes: another one, another histogram
};

}  // namespace isocast::viewer
