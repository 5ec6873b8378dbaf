// Compiled once per instruction set: streams of rays over the native registers.
#include <isocast/volume/stream/chords.h>
#include <isocast/volume/stream/enter.h>
#include <isocast/volume/stream/kernels.h>
#include <isocast/volume/stream/march_rays.h>

namespace isocast::inline ISO_ISA {

extern const StreamKernels stream_kernel_table;

namespace {

using R = Native<double>;
using F = Native<float>;

}  // namespace

const StreamKernels stream_kernel_table = {enter_rays<R>, march_rays<F>, find_chords<R, float>,
                                           find_chords<R, double>};

}  // namespace isocast::inline ISO_ISA
