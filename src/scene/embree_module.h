// What the module `embree` offers to box_tree.cpp.
#pragma once

#include <isocast/scene/box_tree.h>

namespace isocast {

struct EmbreeModule {
  const BoxTree* (*make)(const std::vector<Box>& boxes);  // to be deleted by the caller
};

}  // namespace isocast
