#include <isocast/implicit/beams/kernels.h>
#include <isocast/isa/cpu.h>

namespace isocast {

#define ISOCAST_BEAM_KERNELS(build)           \
  namespace build {                           \
  extern const BeamKernels beam_kernel_table; \
  }
ISOCAST_BEAM_KERNELS(scalar_beams)
ISOCAST_BEAM_KERNELS(sse4_beams)
ISOCAST_BEAM_KERNELS(avx2_beams)
ISOCAST_BEAM_KERNELS(avx512_beams)
#undef ISOCAST_BEAM_KERNELS

const BeamKernels& beam_kernels(Isa isa) {
  switch (isa) {
    case Isa::avx512: return avx512_beams::beam_kernel_table;
    case Isa::avx2: return avx2_beams::beam_kernel_table;
    case Isa::sse4: return sse4_beams::beam_kernel_table;
    default: return scalar_beams::beam_kernel_table;
  }
}

}  // namespace isocast
