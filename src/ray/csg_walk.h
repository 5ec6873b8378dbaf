// Rays on their way from crossing to crossing of a solid's operands.
#pragma once

#include <isocast/ray/csg_sides.h>
#include <isocast/ray/stretch.h>
#include <oneapi/tbb/enumerable_thread_specific.h>

#include <array>
#include <memory>

namespace isocast {

/// The bits of HitStream::sides of a solid that tell the sides of the operand; above them its number.
inline constexpr std::uint32_t kSidesOfOperand = (1u << CsgSurface::kMostIsos) - 1;

/// Of every operand the next crossing waits for its turn; only where it was taken the operand is asked for
/// the following one. Boxes are asked first, and a ray whose fate the others have settled asks no more.
class CsgWalk {
 public:
  /// Begins at the start of all rays.
  CsgWalk(const CsgSurface& csg, const RayStream& rays, TraceCounts& counts);

  /// Takes each of the open rays to the first hit behind its first passed[i] crossings, into `hits` of the
  /// solid's object; a slot whose ray meets none any more keeps all but its certificate, which becomes
  /// undecided where that is not proved. HitStream::s of a hit is the number of crossings up to it.
  void find(RaySet open, const int (&passed)[kStreamSize], HitStream& hits, TraceCounts& counts);

  /// Whether the open rays are those of this walk, and none has come further than to its hit: then find goes
  /// on from here.
  [[nodiscard]] bool leads_to(const RayStream& rays, const RaySet& open, const HitStream& hits) const;

  /// What the operands' first hits cost.
  [[nodiscard]] std::uint32_t cost(int i) const;

 private:
  struct Events;
  [[nodiscard]] const RayStream& rays_of(std::size_t k);
  [[nodiscard]] bool carries(std::size_t k, int i) const;
  void trace(std::size_t k, TraceCounts& counts);
  void settle();
  void take_nearest(int i, Events& events);
  void find_operands(const RaySet& before, Events& events);
  void follow(const RaySet& open, TraceCounts& counts);
  void follow_doubtful(std::size_t k, const RaySet& taken, HitStream& asked, TraceCounts& counts);
  void emit(int i, int operand, const HitStream& found, HitStream& hits);

  const CsgSurface& csg_;
  const RayStream rays_;
  const std::size_t count_;  // of operands
  CsgSides sides_;
  RayStream carried_;                                  // rays as one operand sees them
  std::unique_ptr<HitStream[]> waiting_;               // per operand
  std::vector<RaySet> taken_;                          // per operand: rays whose waiting crossing was
  std::unique_ptr<Stretch[][kStreamSize]> stretches_;  // per operand
  int crossings_[kStreamSize] = {};                    // passed so far
  double t_[kStreamSize];                              // of the last hit
  RaySet starts_here_, doubt_, settled_;  // settled: the solid is nowhere, or everywhere along the ray
};

/// How far each thread has followed the crossings of the solid, by the kind of the rays.
struct CsgWalks {
  using OfKinds = std::array<std::unique_ptr<CsgWalk>, 4>;
  oneapi::tbb::enumerable_thread_specific<OfKinds> of_threads;
};

}  // namespace isocast
