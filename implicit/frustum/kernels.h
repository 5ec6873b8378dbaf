// The table of the frustum form's solvers, one per instruction set.
#pragma once

#include <isocast/implicit/frustum/block_query.h>
#include <isocast/implicit/frustum/ray_query.h>

namespace isocast {

enum class Isa : std::uint8_t;  // isa/cpu.h

/// single: all in float; mixed: the rays' polynomials in double, their roots in float, and those that float
/// cannot tell in double again
enum class FrustumPrecision : std::uint8_t { single, mixed, full };
inline constexpr int kFrustumPrecisions = 3;

/// solve_block  calls found for every tile that may be hit, (x, y) counted in the block; scratch holds
///              frustum_scratch doubles, registers Tape::registers times register_bytes, both aligned to 64
/// solve_rays   the first roots of rays that no view orders
struct FrustumKernels {
  using SolveBlock = void(const FrustumQuery&, double* scratch, void* registers, FrustumCounts&,
                          void* context, void (*found)(void* context, int x, int y, const TileRoots&));
  SolveBlock* solve_block[kFrustumPrecisions];
  void (*solve_rays)(const RayFormQuery&, const RayFormStream&, RayFormRoots&, void* registers);
  std::size_t register_bytes;
};

/// Numbers that solve_block needs room for.
[[nodiscard]] std::size_t frustum_scratch(const FrustumQuery& query);

/// The table of an instruction set that runs here. The same bits in all of them.
[[nodiscard]] const FrustumKernels& frustum_kernels(Isa isa);

}  // namespace isocast
