#include <isocast/implicit/frustum/collocation.h>
#include <isocast/implicit/frustum/degree_tables.h>
#include <isocast/implicit/frustum/frustum_pass.h>
#include <isocast/implicit/frustum/frustum_tracer.h>
#include <isocast/implicit/ray_segments.h>
#include <isocast/implicit/register_memory.h>
#include <isocast/render/camera.h>

#include <cmath>
#include <limits>

namespace isocast {
namespace {

// Parts of a ray that a form of the largest degree follows closely.
int parts_of(int degree) { return degree <= kMostFormDegree ? 1 : (degree + 7) / 8; }

// Of the rays' own polynomials.
int ray_degree(int degree) { return std::clamp(degree, 1, kMostFormDegree); }

// In HitStream::s, where a pass leaves x and in s_hi y of a normal with z >= 0.
constexpr double kNoNormal = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::optional<Double3> form_normal(const HitStream& hits, int slot) {
  const double x = hits.s[slot], y = hits.s_hi[slot];
  if (!(x == x)) return std::nullopt;
  return Double3{x, y, std::sqrt(std::max(0.0, 1 - x * x - y * y))};
}

FrustumTracer::FrustumTracer(const Tape& tape, const Box& domain, const FrustumOptions& options)
    : tape_(tape),
      domain_(domain),
      options_(options),
      ray_tables_(ray_degree(options.degree), ray_degree(options.degree)) {
  options_.degree = std::max(1, options_.degree);
}

std::unique_ptr<PrimaryPass> FrustumTracer::primary(const View& view) const {
  if (options_.degree > kMostFormDegree ||
      FrustumPass::tiles_of_form(view.lines(), domain_, options_.degree) == 0)
    return nullptr;
  return std::make_unique<FrustumPass>(tape_, domain_, options_, view);
}

void FrustumTracer::trace(bool next, const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  const int degree = ray_degree(options_.degree), parts = parts_of(options_.degree);
  RayFormQuery query = {};
  query.tape = tape_.view();
  query.time = options_.time;
  query.iso_count = static_cast<int>(options_.iso.size());
  std::copy(options_.iso.begin(), options_.iso.end(), query.iso);
  query.table = ray_tables_.view();
  query.lebesgue = collocation(degree).lebesgue;
  query.slack = 0x1p-50;
  query.exact = options_.proves && parts == 1;
  query.single = options_.precision == FrustumPrecision::single;
  query.finder = options_.finder;

  RayFormStream forms;
  RayFormRoots roots;
  ClippedRay clipped[kStreamSize];
  bool open[kStreamSize];
  forms.size = rays.size;
  for (int i = 0; i < rays.size; ++i) {
    clipped[i] = clip(rays, i, domain_);
    const bool has_hit = hits.object[i] == options_.object && is_hit(hits, i);
    if (next && has_hit) clipped[i].near = std::max(clipped[i].near, hits.t_hi[i]);
    open[i] = !clipped[i].misses() && (has_hit || !next);
    forms.carried[i] = next || rays.start_object[i] == options_.object;
    forms.sides[i] = next ? sides_behind(hits, i) : rays.start_sides[i];
    if (next && has_hit) hits.t[i] = hits.t_lo[i] = hits.t_hi[i] = Box::inf;
    for (int a = 0; a < 3; ++a) forms.o[a][i] = clipped[i].o[a], forms.d[a][i] = clipped[i].d[a];
  }
  void* const registers = registers_of(tape_.registers * frustum_kernels(options_.isa).register_bytes);
  for (int part = 0; part < parts; ++part) {
    bool any_open = false;
    for (int i = 0; i < rays.size; ++i) {
      forms.active[i] = open[i];
      any_open = any_open || open[i];
      const double length = clipped[i].far - clipped[i].near;
      forms.near[i] = open[i] ? clipped[i].near + length * part / parts : 0;
      forms.far[i] = open[i] ? clipped[i].near + length * (part + 1) / parts : 1;
    }
    if (!any_open) return;
    frustum_kernels(options_.isa).solve_rays(query, forms, roots, registers);
    counts.evaluations += roots.counts.evaluations;
    counts.solves += roots.counts.solves;
    for (int i = 0; i < rays.size; ++i) {
      if (!open[i]) continue;
      hits.cost[i] += static_cast<std::uint32_t>(roots.steps[i]);
      const Certificate otherwise = options_.proves ? Certificate::undecided : Certificate::no_proof;
      if (!roots.hit[i]) {
        if (!roots.proved[i] && options_.proves) hits.certificate[i] = Certificate::undecided;
        forms.carried[i] = true;
        forms.sides[i] = roots.sides_at_far[i];
        continue;
      }
      open[i] = false;
      if (!(roots.t[i] < hits.t[i])) continue;
      hits.t[i] = roots.t[i], hits.t_lo[i] = roots.lo[i], hits.t_hi[i] = roots.hi[i];
      hits.s[i] = kNoNormal;
      hits.iso[i] = roots.iso[i];
      hits.sides[i] = roots.sides[i];
      hits.object[i] = options_.object;
      hits.certificate[i] = roots.proved[i] ? Certificate::proved_hit : otherwise;
    }
  }
}

}  // namespace isocast
