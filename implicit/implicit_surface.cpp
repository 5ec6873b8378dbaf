#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/implicit/expression/simplify.h>
#include <isocast/implicit/gradient_scale.h>
#include <isocast/implicit/implicit_surface.h>
#include <isocast/implicit/ray_beams.h>
#include <isocast/implicit/register_memory.h>
#include <isocast/implicit/traced_ray.h>
#include <isocast/math/interval.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace isocast {

ImplicitSurface::ImplicitSurface(const Expression& expression, const Domain& domain,
                                 const ImplicitSurfaceOptions& options)
    : tape_(make_tape(simplify(expression))) {
  if (options.components) components_.emplace(expression);
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
    if (options_.method.nearest) query.iso_lo[i] = query.iso_hi[i] = static_cast<T>(options_.iso[i]);
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
  if (method.marches()) eps_ = method.options.step > 0 ? method.options.step : 0x1p-8 * longest;
  shadow_eps_ = std::max(eps_, method.shadow_eps_rel * longest);
  gradient_ = !method.marches() ? 0 : median_gradient(tape_, bounds_, options.time);
  pruning_ = method.prune ? plan_pruning(tape_, bounds_, options.time, options.iso) : PruningPlan{};
  prepare_frustum();
  float_query_ = make_query<float>();
  double_query_ = make_query<double>();
  use_device();
}

bool ImplicitSurface::forms_suit(const PolynomialDegree& degree) const {
  const FormulaMethodChoice& method = options_.method;
  // beams are faster for quadrics; roots in float are told apart by no less
  constexpr int kLeast = 3;
  constexpr double kFinest = 0x1p-17;
  return method.pass == FormulaPass::certified && degree.degree && *degree.degree >= kLeast &&
         *degree.degree <= kMostFormDegree && method.proves() && method.options.delta == 0 && !components_ &&
         !options_.device && (options_.double_precision || eps_ >= kFinest * bounds_.diagonal());
}

void ImplicitSurface::prepare_frustum() {
  frustum_ = forms_ = nullptr;
  const FormulaMethodChoice& method = options_.method;
  if (!method.has_form() && method.pass != FormulaPass::certified) return;
  const PolynomialDegree degree = polynomial_degree(tape_);
  if (method.has_form() && !degree.degree)
    throw InputError(fmt::format("--method {} needs a polynomial in x, y and z, and the formula is {}",
                                 name_of(method), degree.reason));
  if (!method.has_form() && !forms_suit(degree)) return;
  FrustumOptions options;
  options.degree = *degree.degree;
  options.iso = options_.iso;
  options.time = options_.time;
  options.finder = method.finder;
  if (!method.has_form()) {
    options.finder.finder = RootFinder::signs;
    options.finder.eps = std::min(options.finder.eps, eps_ / (16 * bounds_.diagonal()));
  }
  options.precision = options_.double_precision                        ? FrustumPrecision::full
                      : options_.mixed_precision || !method.has_form() ? FrustumPrecision::mixed
                                                                       : FrustumPrecision::single;
  options.proves = method.proves();
  options.normals = has_form_normals();
  options.isa = options_.isa;
  options.object = options_.object;
  options.device = options_.device;
  (method.has_form() ? frustum_ : forms_) = std::make_shared<const FrustumTracer>(tape_, bounds_, options);
}

template <class T> const FormulaSolver<T>& ImplicitSurface::solver() const {
  return formula_kernels(options_.isa, options_.method.nearest).solver<T>(options_.method.method);
}

void ImplicitSurface::begin(bool next, const RayStream& rays, HitStream& hits, TracedRay* traced) const {
  for (int i = 0; i < rays.size; ++i) {
    TracedRay& one = traced[i];
    const bool has_hit =
        hits.object[i] == options_.object && hits.t[i] < std::numeric_limits<double>::infinity();
    one.ray = clip(rays, i, bounds_);
    if (next && has_hit) one.ray.near = std::max(one.ray.near, hits.t_hi[i]);
    one.begin = one.ray.near;
    one.active = !one.ray.misses() && (has_hit || !next);
    one.carried = next || rays.start_object[i] == options_.object;
    one.doubt = false;
    one.sides = next && has_hit ? sides_behind(hits, i) : rays.start_sides[i];
    if (next && has_hit) hits.t[i] = hits.t_lo[i] = hits.t_hi[i] = std::numeric_limits<double>::infinity();
  }
}

template <class T>
void ImplicitSurface::trace(const FormulaQuery<T>& query, bool next, const RayStream& rays, HitStream& hits,
                            TraceCounts& counts) const {
  TracedRay traced[kStreamSize];
  begin(next, rays, hits, traced);
  // where pruning cuts rays to pieces, the whole tape is too long for beams
  if (options_.method.beams && !next && rays.kind == RayKind::primary && pruning_.parts == 1)
    narrow(query, rays, traced, counts);
  for (int part = 1; part <= pruning_.parts; ++part)
    trace_part(query, double(part) / pruning_.parts, rays, traced, hits, counts);
}

// Cuts the rays of a tile to where they may hit; those that cannot hit any more are proved misses.
template <class T>
void ImplicitSurface::narrow(const FormulaQuery<T>& query, const RayStream& rays, TracedRay* traced,
                             TraceCounts& counts) const {
  const FormulaSolver<T>& solver = this->solver<T>();
  if (!solver.narrow) return;
  ClippedRay clipped[kStreamSize];
  KnownCrossing known[kStreamSize];
  for (int i = 0; i < rays.size; ++i) {
    if (traced[i].carried) return;
    clipped[i] = traced[i].ray;
  }
  counts.evaluations += narrow_rays(query, solver, rays, eps_, clipped, known,
                                    registers_of(tape_.registers * solver.register_bytes));
  for (int i = 0; i < rays.size; ++i) {
    traced[i].ray = clipped[i];
    traced[i].begin = clipped[i].near;
    traced[i].known = known[i];
    traced[i].active = traced[i].active && !clipped[i].misses();
  }
}

// The part of the rays that ends at `end`, a share of their way through the box; false if none has one.
template <class T>
bool ImplicitSurface::set_part(double end, const RayStream& rays, const TracedRay* traced,
                               TracedPart<T>& part) const {
  SegmentStream<T>& segments = part.segments;
  segments.size = rays.size;
  bool any_active = false;
  for (int i = 0; i < rays.size; ++i) {
    const TracedRay& one = traced[i];
    ClippedRay& piece = part.pieces[i] = one.ray;
    piece.near = one.begin;
    if (end < 1 && !one.known.crosses) piece.far = one.ray.near + end * (one.ray.far - one.ray.near);
    segments.active[i] = one.active && !piece.misses();
    if (!segments.active[i]) continue;
    any_active = true;
    segments.begin[i] = T(0);
    segments.carried[i] = one.carried;
    segments.sides[i] = one.known.crosses ? one.known.sides : one.sides;
    segments.given[i] = one.known.crosses;
    segments.given_iso[i] = one.known.iso;
    set_segment(segments, i, piece, rays.kind == RayKind::shadow ? shadow_eps_ : eps_);
    if (options_.method.nearest)
      for (auto& slack : segments.slack) slack[i] = 0;
  }
  return any_active;
}

template <class T>
void ImplicitSurface::trace_part(const FormulaQuery<T>& whole, double end, const RayStream& rays,
                                 TracedRay* traced, HitStream& hits, TraceCounts& counts) const {
  TracedPart<T> part;
  if (!set_part(end, rays, traced, part)) return;
  SegmentStream<T>& segments = part.segments;
  for (int first = 0; first < rays.size; first += kPacketSize)
    segments.together[first / kPacketSize] = whole.options.packets && march_together(segments, first);

  const FormulaSolver<T>& solver = this->solver<T>();
  FormulaQuery<T> query = whole;
  if (pruning_.prunes) {
    const bool sides = !options_.method.marches() && options_.method.options.delta == 0;
    query.tape = pruned_along(segments, tape_, options_.time,
                              sides ? std::span<const double>(options_.iso) : std::span<const double>())
                     .view();
  }
  solver.solve(query, segments, part.roots, registers_of(tape_.registers * solver.register_bytes));
  take_roots(end, part, traced, hits, counts);
}

// What was found becomes hits, unless nearer ones are known.
template <class T>
void ImplicitSurface::take_roots(double end, const TracedPart<T>& part, TracedRay* traced, HitStream& hits,
                                 TraceCounts& counts) const {
  const SegmentRoots<T>& roots = part.roots;
  for (int i = 0; i < part.segments.size; ++i) {
    if (!part.segments.active[i]) continue;
    hits.cost[i] += roots.evaluations[i];
    counts.evaluations += roots.evaluations[i];
    TracedRay& one = traced[i];
    const ClippedRay& piece = part.pieces[i];
    const auto t_at = [&](T s) { return piece.near + static_cast<double>(s) * (piece.far - piece.near); };
    if (roots.hit[i] && !roots.proved[i] && !options_.method.marches() && roots.s_hi[i] >= T(1) && end < 1) {
      // the next part tells what it is
      one.begin = std::max(one.begin, t_at(roots.s_lo[i]));
      continue;
    }
    one.active = !roots.hit[i];
    one.doubt = one.doubt || !roots.proved[i];
    one.begin = piece.far;
    one.carried = false;
    if (!roots.hit[i]) {
      if (one.doubt && proves()) hits.certificate[i] = Certificate::undecided;
      continue;
    }
    const double t = t_at(roots.s[i]);
    if (!(t < hits.t[i])) continue;
    hits.t[i] = t;
    // what the roundings of t_at can make
    const double slack = 0x1p-51 * std::max(std::abs(piece.near), std::abs(piece.far));
    hits.t_lo[i] = t_at(roots.s_lo[i]) - slack;
    hits.t_hi[i] = t_at(roots.s_hi[i]) + slack;
    hits.iso[i] = roots.iso[i];
    hits.object[i] = options_.object;
    hits.sides[i] = roots.sides[i];
    if (components_) hits.cell[0][i] = components_->at(piece.o + t * piece.d, options_.time);
    hits.certificate[i] = !proves()   ? Certificate::no_proof
                          : one.doubt ? Certificate::undecided
                                      : Certificate::proved_hit;
  }
}

// Hits tell their component where a table of components is asked for.
void ImplicitSurface::set_components(const RayStream& rays, HitStream& hits) const {
  if (!components_) return;
  for (int i = 0; i < rays.size; ++i) {
    if (!is_hit(hits, i) || hits.object[i] != options_.object) continue;
    const Double3 o = {rays.ox[i], rays.oy[i], rays.oz[i]}, d = {rays.dx[i], rays.dy[i], rays.dz[i]};
    hits.cell[0][i] = components_->at(o + hits.t[i] * d, options_.time);
  }
}

void ImplicitSurface::trace_by_inclusion(bool next, const RayStream& rays, HitStream& hits,
                                         TraceCounts& counts) const {
  if (options_.double_precision) trace(double_query_, next, rays, hits, counts);
  else trace(float_query_, next, rays, hits, counts);
}

void ImplicitSurface::find_hit(bool next, const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  if (segment_solver_) return trace_on_device(next, {&rays, 1}, std::array{&hits}, counts);
  const DefaultFloatEnvironment environment;
  if (forms_) return trace_certified(next, rays, hits, counts);
  if (!frustum_) return trace_by_inclusion(next, rays, hits, counts);
  frustum_->trace(next, {&rays, 1}, std::array{&hits}, counts);
  set_components(rays, hits);
}
void ImplicitSurface::first_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  find_hit(false, rays, hits, counts);
}
void ImplicitSurface::next_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  find_hit(true, rays, hits, counts);
}

// for device_trace.cpp
template bool ImplicitSurface::set_part(double, const RayStream&, const TracedRay*, TracedPart<float>&) const;
template bool ImplicitSurface::set_part(double, const RayStream&, const TracedRay*,
                                        TracedPart<double>&) const;
template void ImplicitSurface::take_roots(double, const TracedPart<float>&, TracedRay*, HitStream&,
                                          TraceCounts&) const;
template void ImplicitSurface::take_roots(double, const TracedPart<double>&, TracedRay*, HitStream&,
                                          TraceCounts&) const;

}  // namespace isocast
