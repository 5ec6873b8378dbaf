#include <isocast/implicit/solve/kernels.h>
#include <isocast/isa/cpu.h>

namespace isocast {

#define ISOCAST_FORMULA_KERNELS(build)              \
  namespace build {                                 \
  extern const FormulaKernels formula_kernel_table; \
  }
ISOCAST_FORMULA_KERNELS(scalar)
ISOCAST_FORMULA_KERNELS(sse4)
ISOCAST_FORMULA_KERNELS(avx2)
ISOCAST_FORMULA_KERNELS(avx512)
ISOCAST_FORMULA_KERNELS(scalar_nearest)
ISOCAST_FORMULA_KERNELS(sse4_nearest)
ISOCAST_FORMULA_KERNELS(avx2_nearest)
ISOCAST_FORMULA_KERNELS(avx512_nearest)
#undef ISOCAST_FORMULA_KERNELS

const FormulaKernels& formula_kernels(Isa isa, bool nearest) {
  switch (isa) {
    case Isa::avx512: return nearest ? avx512_nearest::formula_kernel_table : avx512::formula_kernel_table;
    case Isa::avx2: return nearest ? avx2_nearest::formula_kernel_table : avx2::formula_kernel_table;
    case Isa::sse4: return nearest ? sse4_nearest::formula_kernel_table : sse4::formula_kernel_table;
    default: return nearest ? scalar_nearest::formula_kernel_table : scalar::formula_kernel_table;
  }
}

}  // namespace isocast
