#include <isocast/apps/reference/formula_module.h>
#include <isocast/apps/reference/scene_reference.h>
#include <isocast/apps/reference/volume_reference.h>
#include <isocast/base/module.h>

namespace isocast::reference {

std::unique_ptr<RayReference> make_reference(const SceneDescription& description, const BuiltScene& built,
                                             const ReferenceOptions& options) {
  if (const auto* formula = std::get_if<FormulaSource>(&description.objects.front().source))
    return module_table<FormulaModule>("reference", "the reference of a formula")
        .make(formula->expression, formula->domain, formula->time, built.objects.front().iso, options);
  return std::make_unique<VolumeReference>(built.objects.front().volume, built.objects.front().iso);
}

}  // namespace isocast::reference
