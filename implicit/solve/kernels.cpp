#include <isocast/implicit/solve/kernels.h>
#include <isocast/isa/cpu.h>

namespace isocast {

namespace scalar {
extern const FormulaKernels formula_kernel_table;
}
namespace sse4 {
extern const FormulaKernels formula_kernel_table;
}
namespace avx2 {
extern const FormulaKernels formula_kernel_table;
}
namespace avx512 {
extern const FormulaKernels formula_kernel_table;
}

const FormulaKernels& formula_kernels(Isa isa) {
  switch (isa) {
    case Isa::avx512: return avx512::formula_kernel_table;
    case Isa::avx2: return avx2::formula_kernel_table;
    case Isa::sse4: return sse4::formula_kernel_table;
    default: return scalar::formula_kernel_table;
  }
}

}  // namespace isocast
