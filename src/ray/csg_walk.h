// Rays on their way from crossing to crossing of a solid's operands.
#pragma once

#include <isocast/ray/csg_surface.h>
#include <isocast/ray/stretch.h>

namespace isocast {

/// Of every operand the next crossing waits for its turn; only where it was taken the operand is asked for
/// the following one. Boxes are asked first, and a ray whose fate the others have settled asks no more.
class CsgWalk {
 public:
  /// Begins at the start of all rays.
  CsgWalk(const CsgSurface& csg, const RayStream& rays, TraceCounts& counts);

  /// Takes each ray with open[i] to the first hit behind its first passed[i] crossings, into `hits` of the
  /// solid's object; a slot whose ray meets none any more keeps all but its certificate, which becomes
  /// undecided where that is not proved. HitStream::s of a hit is the number of crossings up to it.
  void find(bool (&open)[kStreamSize], const int (&passed)[kStreamSize], HitStream& hits);

  /// What the operands' first hits cost.
  [[nodiscard]] std::uint32_t cost(int i) const;

 private:
  struct Event;
  [[nodiscard]] const RayStream& rays_of(int operand);
  [[nodiscard]] const RayStream& open_rays_of(int operand);
  [[nodiscard]] bool carries(int operand, int i) const;
  [[nodiscard]] bool is_inside(const CsgPart& part, int i, int& operand) const;
  [[nodiscard]] bool is_inside(int i) const;
  [[nodiscard]] bool in_operand(int operand, int i) const;
  [[nodiscard]] Event take_nearest(int i);
  void follow();
  void follow_doubtful(int operand, HitStream& asked);
  void emit(int i, int operand, const HitStream& found, int number, HitStream& hits) const;
  void trace(int operand);
  void settle(int asked);
  enum class Known : std::uint8_t { outside, inside, nothing };
  [[nodiscard]] Known known(const CsgPart& part, int i, int& operand) const;

  const CsgSurface& csg_;
  const RayStream& rays_;
  TraceCounts& counts_;
  const int count_;
  std::unique_ptr<HitStream[]> waiting_;                 // per operand
  std::unique_ptr<std::uint32_t[][kStreamSize]> sides_;  // per operand: where the ray is now
  std::unique_ptr<bool[][kStreamSize]> taken_;           // per operand: its crossing was
  std::unique_ptr<RayStream> carried_;                   // rays as one operand sees them
  std::unique_ptr<bool[]> traced_;                       // operands
  std::unique_ptr<Stretch[][kStreamSize]> stretches_;    // per operand
  HitStream doubtful_;  // crossings of which it is not known what lies behind
  int doubtful_operand_[kStreamSize];
  bool inside_before_[kStreamSize];
  bool starts_here_ = false, doubt_[kStreamSize] = {};
  bool settled_[kStreamSize] = {}, any_settled_ = false;  // the solid is nowhere, or everywhere along the ray
};

}  // namespace isocast
