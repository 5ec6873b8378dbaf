#include <isocast/apps/scene_build/compute_device.h>
#include <isocast/base/module.h>

namespace isocast {

EvaluationSettings evaluation_from(std::string_view isa, std::string_view precision) {
  EvaluationSettings evaluation;
  evaluation.double_precision = precision == "double";
  evaluation.mixed_precision = precision == "mixed";
  if (isa == "cuda") {
    static const std::shared_ptr<const ComputeDevice> device =
        module_table<CudaModule>("cuda", "--isa cuda").open();
    evaluation.device = device;
  } else {
    evaluation.isa = isa_from_name(isa);
  }
  return evaluation;
}

std::string isa_word(const EvaluationSettings& evaluation) {
  return evaluation.device ? "cuda" : std::string(name_of(evaluation.isa));
}

}  // namespace isocast
