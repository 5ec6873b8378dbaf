// A solid that hits can be asked to lie in.
#pragma once

#include <isocast/ray/hit.h>

namespace isocast {

/// Whether a hit lies in a solid; `sure` if it does so wherever in [t_lo, t_hi] the root may be.
struct Place {
  bool inside, sure;
};

/// All calls are const and may come from any thread.
class Region {
 public:
  virtual ~Region() = default;

  /// For every slot that holds a hit, where its point lies.
  virtual void locate(const RayStream& rays, const HitStream& hits, Place (&places)[kStreamSize]) const = 0;

  /// Whether `narrow` can tell anything.
  [[nodiscard]] virtual bool narrows() const { return false; }
  /// Cuts t_min and t_max of rays down to a part outside of which the ray is outside the solid for sure.
  virtual void narrow(RayStream& /*rays*/) const {}
};

}  // namespace isocast
