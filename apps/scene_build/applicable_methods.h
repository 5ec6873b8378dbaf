// Which methods an object can be rendered with.
#pragma once

#include <isocast/apps/scene_build/description.h>
#include <isocast/ray/method.h>

#include <vector>

namespace isocast {

/// What is asked of methods: to be usable, or to have an answer of their own to rays that no view orders.
enum class MethodWish : std::uint8_t { usable, own_answers };

/// The rows of the method table for the object's kind, in its order. Forms are for polynomials alone, and
/// prove something up to kMostFormDegree; single rays are those of other methods where only a whole picture's
/// pass differs.
[[nodiscard]] std::vector<Method> applicable_methods(const ObjectDescription& object,
                                                     MethodWish wish = MethodWish::usable);

}  // namespace isocast
