// What objects are made of, somewhere else.
#pragma once

#include <isocast/math/transform.h>
#include <isocast/scene/mesh/mesh.h>
#include <isocast/volume/volume.h>

#include <memory>

namespace isocast {

[[nodiscard]] bool is_identity(const Transform& t);

/// The same samples. place: has an inverse
[[nodiscard]] std::shared_ptr<const Volume> moved(const std::shared_ptr<const Volume>& volume,
                                                  const Transform& place);
/// Corners and normals; a closed mesh keeps its inside where `place` mirrors.
void move(Mesh& mesh, const Transform& place);

}  // namespace isocast
