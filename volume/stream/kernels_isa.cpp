// Compiled once per instruction set: streams of rays over the native registers.
#include <isocast/volume/stream/chords.h>
#include <isocast/volume/stream/enter.h>
#include <isocast/volume/stream/kernels.h>
#include <isocast/volume/stream/march_lanes.h>

namespace isocast::inline ISO_ISA {

extern const StreamKernels stream_kernel_table;

namespace {

using R = Native<double>;

}  // namespace

const StreamKernels stream_kernel_table = {enter_rays<R>, resume_rays<R>, march_rays<R>, find_chords<R>};

}  // namespace isocast::inline ISO_ISA
