// What evaluates a scene: this processor's instruction sets, or a GPU.
#pragma once

#include <isocast/cuda/cuda_module.h>
#include <isocast/isa/cpu.h>

#include <memory>
#include <string>
#include <string_view>

namespace isocast {

/// How the scene is evaluated, the same for all its objects. device: what solves rays of volumes and
/// formulas, if not this processor; all else is this processor's work.
struct EvaluationSettings {
  Isa isa = widest_isa();
  bool double_precision = false, mixed_precision = false;
  std::shared_ptr<const ComputeDevice> device = {};
};

/// From the words of --isa and --precision; "cuda" opens the device, once per process. Throws InputError for
/// unknown words, where the program was built without CUDA, and where there is no device.
[[nodiscard]] EvaluationSettings evaluation_from(std::string_view isa, std::string_view precision);

/// "scalar" ... "avx512", or "cuda".
[[nodiscard]] std::string isa_word(const EvaluationSettings& evaluation);

}  // namespace isocast
