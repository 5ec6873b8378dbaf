// What passes over the blocks of a picture of a formula have in common.
#pragma once

#include <isocast/implicit/beams/block_frame.h>
#include <isocast/implicit/beams/kernels.h>
#include <isocast/implicit/components.h>
#include <isocast/implicit/expression/tape.h>
#include <isocast/ray/surface.h>

#include <span>

namespace isocast {

/// What a pass needs of a surface.
///
/// tape        the query's
/// prunes      whether runs of it without what is not needed pay; levels: of which only f's sides matter
/// eps         brackets of hits, a world length
/// components  of hits, or null
struct FormulaPassInputs {
  const Surface& surface;
  const Tape& tape;
  bool prunes;
  std::span<const double> levels;
  double eps;
  Isa isa;
  std::uint16_t object;
  const Components* components;
};

/// view, query  for as long as the pass lives
template <class T> class BlockPass {
 public:
  BlockPass(const View& view, const FormulaQuery<T>& query, const FormulaPassInputs& inputs);

 protected:
  /// Room for the roots of a block and for registers, the thread's own.
  [[nodiscard]] static BlockRoots<T>& roots();
  [[nodiscard]] void* registers() const;
  [[nodiscard]] const BlockKernels<T>& kernels() const { return beam_kernels(inputs_.isa).template of<T>(); }
  /// Tells which components the surface's hits of tile (tx, ty) belong to, if that was asked for.
  void note_components(int tx, int ty, double offset_u, double offset_v, HitStream& found) const;

  const View& view_;
  FormulaQuery<T> query_;
  FormulaPassInputs inputs_;
  BlockFrame frame_;
};

}  // namespace isocast
