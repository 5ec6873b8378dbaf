#include <isocast/apps/bench/evaluate_kernels.h>

namespace isocast {

namespace scalar {
extern const bench::EvaluateKernels evaluate_kernel_table;
}
namespace sse4 {
extern const bench::EvaluateKernels evaluate_kernel_table;
}
namespace avx2 {
extern const bench::EvaluateKernels evaluate_kernel_table;
}
namespace avx512 {
extern const bench::EvaluateKernels evaluate_kernel_table;
}

const bench::EvaluateKernels& bench::evaluate_kernels(Isa isa) {
  switch (isa) {
    case Isa::avx512: return avx512::evaluate_kernel_table;
    case Isa::avx2: return avx2::evaluate_kernel_table;
    case Isa::sse4: return sse4::evaluate_kernel_table;
    default: return scalar::evaluate_kernel_table;
  }
}

}  // namespace isocast
