#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/implicit/expression/simplify.h>
#include <isocast/implicit/gradient_scale.h>
#include <isocast/implicit/implicit_surface.h>
#include <isocast/implicit/ray_segments.h>
#include <isocast/implicit/registers.h>
#include <isocast/math/interval.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isocast {

ImplicitSurface::ImplicitSurface(const Expression& expression, const Domain& domain,
                                 const ImplicitSurfaceOptions& options)
    : components_(expression), tape_(make_tape(simplify(expression))) {
  for (int a = 0; a < 3; ++a) {
    bounds_.lo[a] = domain.lo[a];
    bounds_.hi[a] = domain.hi[a];
    if (!(domain.lo[a] < domain.hi[a]) || !std::isfinite(domain.hi[a] - domain.lo[a]))
      throw InputError(
          fmt::format("the domain's axis {} goes from {} to {}, expected a finite low end below the high one",
                      "xyz"[a], domain.lo[a], domain.hi[a]));
  }
  set_options(options);
}

template <class T> FormulaQuery<T> ImplicitSurface::make_query() const {
  FormulaQuery<T> query = {};
  query.tape = tape_.view();
  query.iso_count = static_cast<int>(options_.iso.size());
  for (std::size_t i = 0; i < options_.iso.size(); ++i) {
    const Interval<T> iso = enclosed<T>(options_.iso[i] + options_.method.offset, true);
    query.iso_lo[i] = iso.lo, query.iso_hi[i] = iso.hi;
  }
  query.time = options_.time;
  FormulaOptions& method = query.options = options_.method.options;
  method.step = eps_;
  if (method.tau[0] == 0) method.tau[0] = gradient_ * eps_;
  if (method.tau[1] == 0) method.tau[1] = 2 * method.tau[0];
  if (method.tau[2] == 0) method.tau[2] = 0.1 * gradient_;
  return query;
}

void ImplicitSurface::set_options(const ImplicitSurfaceOptions& options) {
  if (options.iso.empty() || options.iso.size() > kMostIsos)
    throw InputError(fmt::format("{} iso-values were given; 1 to {} are possible for a formula",
                                 options.iso.size(), kMostIsos));
  for (const double iso : options.iso)
    if (!std::isfinite(iso)) throw InputError(fmt::format("iso-value {} is no finite number", iso));
  options_ = options;
  double longest = 0;
  for (int a = 0; a < 3; ++a) longest = std::max(longest, bounds_.hi[a] - bounds_.lo[a]);
  const FormulaMethodChoice& method = options.method;
  eps_ = method.eps > 0 ? method.eps : method.eps_rel * longest;
  if (!method.proves()) eps_ = method.options.step > 0 ? method.options.step : 0x1p-8 * longest;
  shadow_eps_ = std::max(eps_, method.shadow_eps_rel * longest);
  gradient_ = method.proves() ? 0 : median_gradient(tape_, bounds_, options.time);
  float_query_ = make_query<float>();
  double_query_ = make_query<double>();
}

template <class T>
void ImplicitSurface::trace(const FormulaQuery<T>& query, bool next, const RayStream& rays, HitStream& hits,
                            TraceCounts& counts) const {
  SegmentStream<T> segments;
  ClippedRay clipped[kStreamSize];
  segments.size = rays.size;
  bool any_active = false;
  for (int i = 0; i < rays.size; ++i) {
    const bool has_hit =
        hits.object[i] == options_.object && hits.t[i] < std::numeric_limits<double>::infinity();
    const ClippedRay ray = clipped[i] = clip(rays, i, bounds_);
    const bool active = segments.active[i] = !ray.misses() && (has_hit || !next);
    any_active = any_active || active;
    if (active) {
      segments.begin[i] = next ? static_cast<T>(hits.s_hi[i]) : T(0);
      segments.carried[i] = next || rays.start_object[i] == options_.object;
      segments.sides[i] = next ? sides_behind(hits, i) : rays.start_sides[i];
      set_segment(segments, i, ray, rays.kind == RayKind::shadow ? shadow_eps_ : eps_);
    }
    if (next && has_hit) hits.t[i] = hits.t_lo[i] = hits.t_hi[i] = std::numeric_limits<double>::infinity();
  }
  if (!any_active) return;
  for (int first = 0; first < rays.size; first += kPacketSize)
    segments.together[first / kPacketSize] = query.options.packets && march_together(segments, first);

  const FormulaSolver<T>& solver = formula_kernels(options_.isa).solver<T>(options_.method.method);
  SegmentRoots<T> roots;
  solver.solve(query, segments, roots, registers_of(tape_.registers * solver.register_bytes));
  for (int i = 0; i < rays.size; ++i) {
    if (!segments.active[i]) continue;
    hits.cost[i] += roots.evaluations[i];
    counts.evaluations += roots.evaluations[i];
    if (!roots.hit[i]) {
      if (!roots.proved[i] && proves()) hits.certificate[i] = Certificate::undecided;
      continue;
    }
    const ClippedRay& ray = clipped[i];
    const auto t_at = [&](T s) { return ray.near + static_cast<double>(s) * (ray.far - ray.near); };
    const double t = t_at(roots.s[i]);
    if (!(t < hits.t[i])) continue;
    hits.t[i] = t;
    // what the roundings of t_at can make
    const double slack = 0x1p-51 * std::max(std::abs(ray.near), std::abs(ray.far));
    hits.t_lo[i] = t_at(roots.s_lo[i]) - slack;
    hits.t_hi[i] = t_at(roots.s_hi[i]) + slack;
    hits.s[i] = static_cast<double>(roots.s[i]);
    hits.s_hi[i] = static_cast<double>(roots.s_hi[i]);
    hits.iso[i] = roots.iso[i];
    hits.object[i] = options_.object;
    hits.sides[i] = roots.sides[i];
    if (options_.components)
      hits.cell[0][i] = components_.at(
          Double3{rays.ox[i], rays.oy[i], rays.oz[i]} + t * Double3{rays.dx[i], rays.dy[i], rays.dz[i]},
          options_.time);
    hits.certificate[i] = !proves()         ? Certificate::no_proof
                          : roots.proved[i] ? Certificate::proved_hit
                                            : Certificate::undecided;
  }
}

void ImplicitSurface::first_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  const DefaultFloatEnvironment environment;
  if (options_.double_precision) trace(double_query_, false, rays, hits, counts);
  else trace(float_query_, false, rays, hits, counts);
}
void ImplicitSurface::next_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  const DefaultFloatEnvironment environment;
  if (options_.double_precision) trace(double_query_, true, rays, hits, counts);
  else trace(float_query_, true, rays, hits, counts);
}

}  // namespace isocast
