// From a scene to its truth: the only place that knows every kind of reference.
#pragma once

#include <isocast/apps/reference/ray_reference.h>
#include <isocast/apps/scene_build/scene_build.h>

#include <memory>

namespace isocast::reference {

/// The reference for the scene's object, with the iso-values that it was built with. Opens the module
/// `reference` for a formula; throws InputError where that is missing. The options are those of formulas.
[[nodiscard]] std::unique_ptr<RayReference> make_reference(const SceneDescription& description,
                                                           const BuiltScene& built,
                                                           const ReferenceOptions& options = {});

}  // namespace isocast::reference
