// Compiled once per instruction set: the frustum form over the native registers of float and double.
#include <isocast/implicit/frustum/block.h>
#include <isocast/implicit/frustum/kernels.h>
#include <isocast/implicit/frustum/ray_roots.h>

namespace isocast::inline ISO_ISA {

extern const FrustumKernels frustum_kernel_table;

namespace {

template <class T, class C>
void solve_block(const FrustumQuery& query, double* scratch, void* registers, FrustumCounts& counts,
                 void* context, void (*found)(void*, int, int, const TileRoots&)) {
  FrustumBlock<T, C>(query, scratch, registers, counts, context, found).solve();
}

}  // namespace

// the most that evaluate_grid and RayForms keep of a register of the tape
const FrustumKernels frustum_kernel_table = {
    {solve_block<float, float>, solve_block<float, double>, solve_block<double, double>},
    solve_ray_forms,
    16 * sizeof(Wide) > 4 * sizeof(Interval<Wide>) ? 16 * sizeof(Wide) : 4 * sizeof(Interval<Wide>)};

}  // namespace isocast::inline ISO_ISA
