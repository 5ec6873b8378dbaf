#include <isocast/implicit/expression/evaluate.h>
#include <isocast/implicit/expression/simplify.h>
#include <isocast/implicit/formula_region.h>
#include <isocast/implicit/register_memory.h>
#include <isocast/implicit/solve/inclusion.h>
#include <isocast/isa/cpu.h>

#include <algorithm>

namespace isocast {

FormulaRegion::FormulaRegion(const Expression& g, double time)
    : tape_(make_tape(simplify(g))), time_(time), quadric_(Quadric::of(tape_, time)) {}

void FormulaRegion::narrow(RayStream& rays) const {
  const DefaultFloatEnvironment environment;
  for (int i = 0; i < rays.size; ++i) {
    if (rays.t_min[i] > rays.t_max[i]) continue;
    const LinePart part =
        quadric_->inside({rays.ox[i], rays.oy[i], rays.oz[i]}, {rays.dx[i], rays.dy[i], rays.dz[i]});
    rays.t_max[i] = std::min(rays.t_max[i], part.hi);
    if (!(part.lo > rays.t_min[i])) continue;
    rays.t_min[i] = part.lo;
    rays.start_object[i] = kNoObject;
  }
}

void FormulaRegion::locate(const RayStream& rays, const HitStream& hits, Place (&places)[kStreamSize]) const {
  using I = Interval<double>;
  const DefaultFloatEnvironment environment;
  void* const registers = registers_of(tape_.registers * sizeof(I));
  for (int i = 0; i < rays.size; ++i) {
    if (!is_hit(hits, i)) continue;
    const double o[3] = {rays.ox[i], rays.oy[i], rays.oz[i]}, d[3] = {rays.dx[i], rays.dy[i], rays.dz[i]};
    const I t(hits.t_lo[i], hits.t_hi[i]);
    I box[4];
    double point[4];
    for (int a = 0; a < 3; ++a) {
      box[a] = I(o[a]) + t * I(d[a]);
      point[a] = o[a] + hits.t[i] * d[a];
    }
    box[3] = I(point[3] = time_);
    const I g = evaluate(tape_.view(), box, static_cast<I*>(registers));
    const bool all_inside = !g.empty && g.defined && g.hi <= 0, all_outside = g.empty || g.lo > 0;
    const bool inside =
        all_inside || (!all_outside && evaluate(tape_.view(), point, static_cast<double*>(registers)) <= 0);
    places[i] = {inside, all_inside || all_outside};
  }
}

}  // namespace isocast
