// The method `certified` for formulas: the primary rays of a picture by trees of beams.
#pragma once

#include <isocast/implicit/beams/block_frame.h>
#include <isocast/implicit/beams/kernels.h>
#include <isocast/implicit/components.h>
#include <isocast/ray/surface.h>

namespace isocast {

/// What the pass needs of a surface.
///
/// query       for as long as the surface lives; `registers` of its tape
/// eps         brackets of hits, a world length
/// components  of hits, or null
struct FormulaPassInputs {
  const Surface& surface;
  std::uint32_t registers;
  double eps;
  Isa isa;
  std::uint16_t object;
  const Components* components;
};

/// Hits are proved by beams where they can be; rays that those leave open are solved by the surface's
/// first_hit, each for itself, from where they were left.
///
/// proofs  as ImplicitSurface's
template <class T> class CertifiedPass final : public PrimaryPass {
 public:
  CertifiedPass(const View& view, const FormulaQuery<T>& query, const FormulaPassInputs& inputs);
  void first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                  TraceCounts& counts) const override;

 private:
  void note_components(int tx, int ty, double offset_u, double offset_v, HitStream& found) const;
  void solve_open_rays(int bx, int by, double offset_u, double offset_v, const BlockRays<T>& rays,
                       const BlockRoots<T>& roots, BlockHits& hits, TraceCounts& counts) const;

  const View& view_;
  FormulaQuery<T> query_;
  FormulaPassInputs inputs_;
  BlockFrame frame_;
};

}  // namespace isocast
