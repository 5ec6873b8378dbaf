#include <fmt/format.h>
#include <isocast/apps/scene_build/build_csg.h>
#include <isocast/base/error.h>

#include <algorithm>

namespace isocast {
namespace {

void add_missing(std::vector<std::string>& list, const std::vector<std::string>& more) {
  for (const std::string& word : more)
    if (std::ranges::find(list, word) == list.end()) list.push_back(word);
}

void add(BuiltObject& whole, const BuiltObject& part) {
  add_missing(whole.features, part.features);
  add_missing(whole.left_out, part.left_out);
  whole.load_ms += part.load_ms;
  whole.build_ms += part.build_ms;
  whole.volume_bytes += part.volume_bytes;
  whole.acceleration_bytes += part.acceleration_bytes;
}

// One operand as a part, with a material for each of its iso-values and faces.
CsgPart operand(const ObjectSurface& object, std::uint16_t number, std::vector<Material>& materials) {
  if (object.built.components > 0)
    throw InputError(fmt::format("object '{}': color_components cannot be in an operand", object.built.name));
  materials.insert(materials.end(), object.materials.begin(), object.materials.end());
  const CsgOperand solid{object.surface, static_cast<int>(object.materials.size()), object.above};
  if (!object.solid) return {CsgOperation::operand, solid, {}};
  materials.push_back(object.materials.front());
  return closed(solid, object.solid->box, object.solid->world_from_box, number);
}

}  // namespace

void build_csg(ObjectSurface& object, const CsgSource& source, const ObjectDescription& wanted,
               const BuildContext& context) {
  CsgPart whole{source.operation, {}, {}};
  for (ObjectDescription description : source.of) {
    if (!description.clips.empty() || description.color_by)
      throw InputError(
          fmt::format("object '{}': found clip or color_by in an operand, expected them in the csg "
                      "(what an operand keeps is an intersection)",
                      wanted.name));
    description.place = wanted.place * description.place;
    const ObjectSurface built = build_object(description, context);
    whole.parts.push_back(operand(built, context.number, object.materials));
    add(object.built, built.built);
  }
  const auto surface = std::make_shared<CsgSurface>(std::move(whole), context.number);
  const MaterialDescription& own = wanted.materials;
  if (!own.colors.empty() || !own.opacities.empty() || !own.reflectivities.empty() ||
      !own.speculars.empty()) {
    // one material for all, as of one solid
    const Material material = material_of(own, 0);
    std::ranges::fill(object.materials, material);
  }
  object.surface = surface;
  object.built.method = "csg";
  object.built.proves = surface->proves();
  object.built.iso.assign(object.materials.size(), 0);
  object.built.features.push_back("csg");
}

}  // namespace isocast
