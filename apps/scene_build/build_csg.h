// Solids of solids, from their description.
#pragma once

#include <isocast/apps/scene_build/build_object.h>

namespace isocast {

/// Builds the operands and what they make together. Operands are solids: volumes where they are above their
/// iso-value, formulas where they are below theirs, each closed at its box; meshes inside. Every operand has
/// its own materials unless the whole has some. Throws InputError.
void build_csg(ObjectSurface& object, const CsgSource& source, const ObjectDescription& wanted,
               const BuildContext& context);

}  // namespace isocast
