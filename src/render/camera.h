// The camera, and the primary rays of a tile.
#pragma once

#include <isocast/math/box.h>
#include <isocast/ray/pixel_lines.h>
#include <isocast/ray/stream.h>
#include <isocast/ray/tile.h>
#include <isocast/render/kernels.h>

#include <optional>

namespace isocast {

/// World space, right-handed; fov is the vertical angle in degrees, ortho_height (when set) the height of the
/// picture in world units of an orthographic camera.
struct Camera {
  Double3 position, target, up;
  double fov = 45;
  std::optional<double> ortho_height;
};

/// The parts that a user fixed; frame() fills in the rest.
struct CameraWishes {
  std::optional<Double3> position, target, up;
  std::optional<double> fov, ortho_height;
};

/// A camera that shows the whole box: target its centre, at a distance that fits its bounding sphere, seen
/// obliquely from the front (-y) and above (+z), with up = z. Throws InputError when the wishes leave no
/// direction (position = target, up along the view, fov outside (0, 180), no finite numbers).
[[nodiscard]] Camera frame(const Box& box, const CameraWishes& wishes, double aspect);

/// Pixels per side of a tile: one stream.
inline constexpr int kTileSize = 16;

/// A camera with a picture size: everything that primary rays need.
class View {
 public:
  View(const Camera& camera, int width, int height);

  /// The view whose pixel (x, y) is this one's (x + columns, y + rows).
  [[nodiscard]] View shifted(int columns, int rows) const;

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// Unit vector from the camera into the scene.
  [[nodiscard]] const Double3& forward() const { return forward_; }

  [[nodiscard]] const RayFrame& ray_frame() const { return frame_; }

  /// Rays of tile (tx, ty) through (x + offset_u, y + offset_v) of each pixel (0.5: the centre), first row on
  /// top, in packets of 4x4 pixels; slots outside the picture are empty. Directions have unit length, t_min
  /// is 0. id is x + y * width.
  void fill(int tx, int ty, double offset_u, double offset_v, RayStream& rays) const;

  /// All primary rays as one map, with s = 1 at distance 1 along forward().
  [[nodiscard]] PixelLines lines() const;

  /// The solid that holds the tile's primary rays.
  [[nodiscard]] TileFrustum frustum(int tx, int ty) const;

 private:
  // Point on the image plane (perspective: relative to the eye, at distance 1), u and v in pixels.
  [[nodiscard]] Double3 image_point(double u, double v) const;

  void set_frame();

  int width_, height_, left_ = 0, top_ = 0;  // left_, top_: where the picture begins
  bool orthographic_;
  Double3 eye_, forward_, right_, down_;  // right_ and down_: one pixel
  RayFrame frame_;
};

}  // namespace isocast
