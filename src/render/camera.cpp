#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/render/camera.h>

#include <cmath>
#include <numbers>

namespace isocast {
namespace {

bool finite(const Double3& v) { return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]); }
double radians(double degrees) { return degrees * std::numbers::pi / 180; }

}  // namespace

Camera frame(const Box& box, const CameraWishes& wishes, double aspect) {
  const double fov = wishes.fov.value_or(45);
  if (!(fov > 0 && fov < 180))
    throw InputError(fmt::format("--fov {}: expected degrees between 0 and 180", fov));
  if (wishes.ortho_height && !(*wishes.ortho_height > 0 && std::isfinite(*wishes.ortho_height)))
    throw InputError(
        fmt::format("--ortho {}: expected a positive height in world units", *wishes.ortho_height));
  Camera camera;
  camera.fov = fov;
  camera.ortho_height = wishes.ortho_height;
  camera.up = wishes.up.value_or(Double3{0, 0, 1});
  camera.target = wishes.target.value_or(box.empty() ? Double3{0, 0, 0} : box.center());

  // fit the bounding sphere into the narrower of the two angles
  const double half = std::atan(std::tan(radians(fov) / 2) * std::min(1.0, aspect));
  const double radius = box.empty() ? 1 : 0.5 * box.diagonal();
  const Double3 from_front = normalized({0.5, -1, 0.4});
  camera.position = wishes.position.value_or(camera.target + (radius / std::sin(half)) * from_front);

  if (!finite(camera.position) || !finite(camera.target) || !finite(camera.up))
    throw InputError("the camera's position, target and up must be finite numbers");
  const Double3 forward = normalized(camera.target - camera.position);
  if (length(forward) == 0)
    throw InputError("the camera's position and target are the same point: there is no direction to look in");
  if (!(length(cross(forward, normalized(camera.up))) > 1e-9)) {
    if (wishes.up)
      throw InputError("the camera's up vector points along its view: there is no upper side of the picture");
    camera.up = {0, 1, 0};
  }
  return camera;
}

View::View(const Camera& camera, int width, int height)
    : width_(width),
      height_(height),
      orthographic_(camera.ortho_height.has_value()),
      eye_(camera.position),
      forward_(normalized(camera.target - camera.position)) {
  const double picture_height = orthographic_ ? *camera.ortho_height : 2 * std::tan(radians(camera.fov) / 2);
  const double pixel = picture_height / height;
  const Double3 right = normalized(cross(forward_, camera.up));
  right_ = pixel * right;
  down_ = pixel * cross(forward_, right);
  set_frame();
}

View View::shifted(int columns, int rows) const {
  View view = *this;
  view.left_ += columns;
  view.top_ += rows;
  view.set_frame();
  return view;
}

void View::set_frame() {
  const Double3 corner = image_point(0, 0), &fixed = orthographic_ ? forward_ : eye_;
  frame_ = {{}, {}, {}, {}, width_, height_, orthographic_};
  for (int a = 0; a < 3; ++a) {
    frame_.corner[a] = corner[a];
    frame_.right[a] = right_[a];
    frame_.down[a] = down_[a];
    frame_.fixed[a] = fixed[a];
  }
}

Double3 View::image_point(double u, double v) const {
  const Double3 across = (u + left_ - 0.5 * width_) * right_ + (v + top_ - 0.5 * height_) * down_;
  return orthographic_ ? eye_ + across : forward_ + across;
}

void View::fill(int tx, int ty, double offset_u, double offset_v, RayStream& rays) const {
  render_kernels().fill_rays(frame_, tx, ty, offset_u, offset_v, rays);
}

PixelLines View::lines() const {
  const Double3 corner = image_point(0, 0), still = {0, 0, 0};
  const Double3 &o = orthographic_ ? corner : eye_, &d = orthographic_ ? forward_ : corner;
  PixelLines lines;
  for (int a = 0; a < 3; ++a) {
    lines.o[a] = o[a], lines.d[a] = d[a];
    lines.o_u[a] = (orthographic_ ? right_ : still)[a], lines.o_v[a] = (orthographic_ ? down_ : still)[a];
    lines.d_u[a] = (orthographic_ ? still : right_)[a], lines.d_v[a] = (orthographic_ ? still : down_)[a];
  }
  return lines;
}

TileFrustum View::frustum(int tx, int ty) const {
  const double u0 = tx * kTileSize, v0 = ty * kTileSize;
  const double u1 = std::min<double>(u0 + kTileSize, width_), v1 = std::min<double>(v0 + kTileSize, height_);
  const Double3 corners[4] = {image_point(u0, v0), image_point(u1, v0), image_point(u1, v1),
                              image_point(u0, v1)};
  const Double3 inside = image_point(0.5 * (u0 + u1), 0.5 * (v0 + v1));
  TileFrustum tile;
  for (int i = 0; i < 4; ++i) {
    const Double3 &a = corners[i], &b = corners[(i + 1) % 4];
    const Double3 on_plane = orthographic_ ? a : eye_;
    Double3 normal = orthographic_ ? cross(b - a, forward_) : cross(a, b);
    const Double3 towards = orthographic_ ? inside - a : inside;
    if (dot(normal, towards) < 0) normal = -1.0 * normal;
    tile.normal[i] = normal;
    tile.offset[i] = dot(normal, on_plane);
  }
  return tile;
}

}  // namespace isocast
