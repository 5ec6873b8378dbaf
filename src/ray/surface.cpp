#include <isocast/ray/surface.h>

namespace isocast {

void Surface::any_hit(const RayStream& rays, bool (&hit)[kStreamSize], TraceCounts& counts) const {
  HitStream hits;
  clear(hits);
  first_hit(rays, hits, counts);
  for (int i = 0; i < rays.size; ++i) hit[i] = hit[i] || hits.t[i] < __builtin_inf();
}

}  // namespace isocast
