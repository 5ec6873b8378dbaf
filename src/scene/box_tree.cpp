#include <isocast/base/module.h>
#include <isocast/scene/box_tree.h>
#include <isocast/scene/embree_module.h>

#include <cstdlib>
#include <string_view>

namespace isocast {

bool has_embree() {
  static const bool found = !find_part("isocast_embree.so").empty();
  const char* const wanted = std::getenv("ISOCAST_EMBREE");
  return found && !(wanted && std::string_view(wanted) == "0");
}

std::unique_ptr<const BoxTree> make_box_tree(std::vector<Box> boxes) {
  if (!has_embree()) return make_plain_box_tree(std::move(boxes));
  const auto& module = module_table<EmbreeModule>("embree", "boxes of several objects");
  return std::unique_ptr<const BoxTree>(module.make(boxes));
}

}  // namespace isocast
