// How the mouse moves the camera: pure functions of a camera and what was dragged.
#pragma once

#include <isocast/math/box.h>
#include <isocast/render/camera.h>

#include <span>

namespace isocast::viewer {

/// Turns around the target as on a turntable, `up` staying upright: half a turn for each height of the
/// picture that is dragged to the right or (as far as the poles) down. dx, dy in heights of the picture.
[[nodiscard]] Camera orbit(const Camera& camera, double dx, double dy);

/// Moves with what lies at the target's depth, which follows the mouse. dx, dy in heights of the picture.
[[nodiscard]] Camera pan(const Camera& camera, double dx, double dy);

/// One step of the wheel: a tenth nearer to the target (steps below 0: farther), orthographic: a tenth
/// larger.
[[nodiscard]] Camera zoom(const Camera& camera, double steps);

/// The same direction and kind of camera, with the whole box in the picture.
[[nodiscard]] Camera fit(const Camera& camera, const Box& box, double aspect);

/// A name for a button, from where the camera looks, and its upper side.
struct StandardView {
  const char* name;
  Double3 from, up;
};
[[nodiscard]] std::span<const StandardView> standard_views();
[[nodiscard]] Camera look_from(const Camera& camera, const StandardView& view);

/// The other kind of camera, which shows what lies at the target's depth at the same size.
[[nodiscard]] Camera with_perspective(const Camera& camera, bool perspective);

/// Height of the picture at the target's depth, in world units.
[[nodiscard]] double height_at_target(const Camera& camera);

}  // namespace isocast::viewer
