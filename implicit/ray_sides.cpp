// On which side of its iso-values a ray runs that crosses none.
#include <isocast/implicit/expression/evaluate.h>
#include <isocast/implicit/implicit_surface.h>
#include <isocast/implicit/ray_segments.h>
#include <isocast/implicit/register_memory.h>
#include <isocast/implicit/solve/inclusion.h>

namespace isocast {

void ImplicitSurface::find_sides(const RayStream& rays, const HitStream& hits,
                                 RaySides (&sides)[kStreamSize]) const {
  using I = Interval<double>;
  const DefaultFloatEnvironment environment;
  void* const registers = registers_of(tape_.registers * sizeof(I));
  const FormulaQuery<double>& query = double_query_;
  for (int i = 0; i < rays.size; ++i) {
    if (is_hit(hits, i)) continue;
    sides[i] = {0, true};
    const ClippedRay ray = clip(rays, i, bounds_);
    if (ray.misses()) continue;
    const Double3 p = ray.o + 0.5 * (ray.near + ray.far) * ray.d;
    const I point[4] = {I(p[0]), I(p[1]), I(p[2]), I(options_.time)};
    const I f = evaluate(tape_.view(), point, static_cast<I*>(registers));
    const bool known = !f.empty && f.defined;
    for (int iso = 0; iso < query.iso_count; ++iso) {
      const bool below = f.hi < query.iso_lo[iso], above = f.lo >= query.iso_hi[iso];
      const bool is_below = below || (!above && f.lo + f.hi < query.iso_lo[iso] + query.iso_hi[iso]);
      sides[i].below |= std::uint32_t(is_below) << iso;
      sides[i].sure = sides[i].sure && known && (below || above);
    }
  }
}

}  // namespace isocast
