// The rays of a picture, block by block, as linear models.
#pragma once

#include <isocast/implicit/beams/block.h>
#include <isocast/math/box.h>

namespace isocast {

class View;

/// The primary rays of a view: points start + u start_u + v start_v + z (span + u span_u + v span_v), u and v
/// in pixels from the picture's corner, z the depth along the camera's axis.
class BlockFrame {
 public:
  /// box  where roots are sought
  BlockFrame(const View& view, const Box& box);

  /// False where no ray of the picture meets the box.
  [[nodiscard]] bool meets() const { return nearest_ < farthest_; }

  [[nodiscard]] const Box& box() const { return box_; }

  /// Block (bx, by), its rays through (x + offset_u, y + offset_v) of their pixels, with brackets of `eps`, a
  /// world length.
  template <class T>
  [[nodiscard]] BlockRays<T> block(int bx, int by, double offset_u, double offset_v, double eps) const;

  /// A depth of a block's rays, z - rays.depth, as the parameter t of the ray at (x, y) of the block.
  template <class T>
  [[nodiscard]] static double distance(const BlockRays<T>& rays, int x, int y, double depth);

  /// A box around the rays of a square of pixels between two depths.
  template <class T>
  [[nodiscard]] static Box box_around(const BlockRays<T>& rays, int x, int y, int size, DepthRange<T> part);

 private:
  Double3 start_, start_u_, start_v_, span_, span_u_, span_v_;
  Box box_;
  int width_, height_;
  double start_error_, span_error_;  // of all points: how far stored rays are off
  double nearest_, farthest_;        // z of the box
};

}  // namespace isocast
