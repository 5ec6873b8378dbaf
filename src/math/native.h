// The widest Real there is: a register's lanes, or one number for a thread of a GPU.
#pragma once

#ifdef __CUDACC__
#include <isocast/math/real.h>

namespace isocast::inline ISO_ISA {
template <class T> using Native = T;
}  // namespace isocast::inline ISO_ISA
#else
#include <isocast/math/pack.h>
#endif

namespace isocast::inline ISO_ISA {
using Wide = Native<double>;
}  // namespace isocast::inline ISO_ISA
