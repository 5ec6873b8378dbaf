#include <isocast/apps/viewer/camera_motion.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isocast::viewer {
namespace {

constexpr double kPi = std::numbers::pi;

// v turned around a unit axis (Rodrigues' formula).
Double3 turned(const Double3& v, const Double3& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return c * v + s * cross(axis, v) + ((1 - c) * dot(axis, v)) * axis;
}

double distance(const Camera& camera) { return length(camera.position - camera.target); }

}  // namespace

Camera orbit(const Camera& camera, double dx, double dy) {
  const Double3 up = normalized(camera.up), arm = camera.position - camera.target;
  // the angle from `up`, which stays off the poles
  constexpr double kPole = 1e-3;
  const double angle = std::acos(std::clamp(dot(normalized(arm), up), -1.0, 1.0)),
               wanted = std::clamp(angle - dy * kPi, kPole, kPi - kPole);
  const Double3 right = normalized(cross(up, arm));
  Camera moved = camera;
  const Double3 tilted = length(right) > 0 ? turned(arm, right, wanted - angle) : arm;
  moved.position = camera.target + turned(tilted, up, -dx * kPi);
  return moved;
}

Camera pan(const Camera& camera, double dx, double dy) {
  const Double3 forward = normalized(camera.target - camera.position),
                right = normalized(cross(forward, camera.up)), down = cross(forward, right);
  const Double3 shift = -height_at_target(camera) * (dx * right + dy * down);
  Camera moved = camera;
  moved.position = camera.position + shift;
  moved.target = camera.target + shift;
  return moved;
}

Camera zoom(const Camera& camera, double steps) {
  const double factor = std::pow(0.9, steps);
  Camera moved = camera;
  if (moved.ortho_height) *moved.ortho_height *= factor;
  else moved.position = camera.target + factor * (camera.position - camera.target);
  return moved;
}

Camera fit(const Camera& camera, const Box& box, double aspect) {
  if (box.empty()) return camera;
  const double half = std::atan(std::tan(camera.fov * kPi / 360) * std::min(1.0, aspect)),
               radius = 0.5 * box.diagonal();
  Camera moved = camera;
  moved.target = box.center();
  moved.position = moved.target + (radius / std::sin(half)) * normalized(camera.position - camera.target);
  if (moved.ortho_height) *moved.ortho_height = 2 * radius / std::min(1.0, aspect);
  return moved;
}

std::span<const StandardView> standard_views() {
  static const StandardView views[] = {
      {"Front", {0, -1, 0}, {0, 0, 1}},     {"Back", {0, 1, 0}, {0, 0, 1}}, {"Left", {-1, 0, 0}, {0, 0, 1}},
      {"Right", {1, 0, 0}, {0, 0, 1}},      {"Top", {0, 0, 1}, {0, 1, 0}},  {"Bottom", {0, 0, -1}, {0, 1, 0}},
      {"Corner", {0.5, -1, 0.4}, {0, 0, 1}}};
  return views;
}

Camera look_from(const Camera& camera, const StandardView& view) {
  Camera moved = camera;
  moved.position = camera.target + distance(camera) * normalized(view.from);
  moved.up = view.up;
  return moved;
}

Camera with_perspective(const Camera& camera, bool perspective) {
  Camera changed = camera;
  const double height = height_at_target(camera);
  if (perspective && camera.ortho_height) {
    changed.ortho_height.reset();
    const double away = height / (2 * std::tan(camera.fov * kPi / 360));
    changed.position = camera.target + away * normalized(camera.position - camera.target);
  } else if (!perspective) changed.ortho_height = height;
  return changed;
}

double height_at_target(const Camera& camera) {
  return camera.ortho_height.value_or(2 * distance(camera) * std::tan(camera.fov * kPi / 360));
}

}  // namespace isocast::viewer
