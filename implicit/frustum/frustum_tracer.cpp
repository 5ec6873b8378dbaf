#include <isocast/implicit/frustum/collocation.h>
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
    : tape_(tape), domain_(domain), options_(options) {
  options_.degree = std::max(1, options_.degree);
  if (options_.device)
    solver_ = options_.device->ray_form_solver_of(
        {options_.finder.finder, options_.precision == FrustumPrecision::single, ray_degree(options_.degree),
         static_cast<int>(options_.iso.size())},
        tape_);
}

std::unique_ptr<PrimaryPass> FrustumTracer::primary(const View& view, const DoubtfulRays& doubtful) const {
  if (solver_ || options_.degree > kMostFormDegree ||
      FrustumPass::tiles_of_form(view.lines(), domain_, options_.degree) == 0)
    return nullptr;
  return std::make_unique<FrustumPass>(tape_, domain_, options_, view, doubtful);
}

// A stream's rays as polynomials are made of them.
struct FrustumTracer::Traced {
  RayFormStream forms;
  RayFormRoots roots;
  ClippedRay clipped[kStreamSize];
  bool open[kStreamSize];
};

RayFormQuery FrustumTracer::ray_query() const {
  RayFormQuery query = {};
  query.tape = tape_.view();
  query.time = options_.time;
  query.iso_count = static_cast<int>(options_.iso.size());
  std::copy(options_.iso.begin(), options_.iso.end(), query.iso);
  query.table = collocation(ray_degree(options_.degree)).view();
  query.slack = 0x1p-50;
  query.exact = options_.proves && parts_of(options_.degree) == 1;
  query.single = options_.precision == FrustumPrecision::single;
  query.finder = options_.finder;
  return query;
}

void FrustumTracer::begin(bool next, const RayStream& rays, HitStream& hits, Traced& traced) const {
  RayFormStream& forms = traced.forms;
  forms.size = rays.size;
  for (int i = 0; i < rays.size; ++i) {
    ClippedRay& clipped = traced.clipped[i] = clip(rays, i, domain_);
    const bool has_hit = hits.object[i] == options_.object && is_hit(hits, i);
    if (next && has_hit) clipped.near = std::max(clipped.near, hits.t_hi[i]);
    traced.open[i] = !clipped.misses() && (has_hit || !next);
    forms.carried[i] = next || rays.start_object[i] == options_.object;
    forms.sides[i] = next && has_hit ? sides_behind(hits, i) : rays.start_sides[i];
    if (next && has_hit) hits.t[i] = hits.t_lo[i] = hits.t_hi[i] = Box::inf;
    for (int a = 0; a < 3; ++a) forms.o[a][i] = clipped.o[a], forms.d[a][i] = clipped.d[a];
  }
}

// The part-th of the rays' parts; false if no ray is left.
bool FrustumTracer::set_part(int part, Traced& traced, TraceCounts& counts) const {
  const int degree = ray_degree(options_.degree), parts = parts_of(options_.degree);
  RayFormStream& forms = traced.forms;
  bool any_open = false;
  for (int i = 0; i < forms.size; ++i) {
    const bool open = forms.active[i] = traced.open[i];
    any_open = any_open || open;
    counts.solves += open;
    counts.evaluations += open ? degree + 1 : 0;
    const ClippedRay& clipped = traced.clipped[i];
    const double length = clipped.far - clipped.near;
    forms.near[i] = open ? clipped.near + length * part / parts : 0;
    forms.far[i] = open ? clipped.near + length * (part + 1) / parts : 1;
  }
  return any_open;
}

void FrustumTracer::take_roots(Traced& traced, HitStream& hits) const {
  const RayFormRoots& roots = traced.roots;
  for (int i = 0; i < traced.forms.size; ++i) {
    if (!traced.open[i]) continue;
    hits.cost[i] += static_cast<std::uint32_t>(roots.steps[i]);
    const Certificate otherwise = options_.proves ? Certificate::undecided : Certificate::no_proof;
    if (!roots.hit[i]) {
      if (!roots.proved[i] && options_.proves) hits.certificate[i] = Certificate::undecided;
      traced.forms.carried[i] = true;
      traced.forms.sides[i] = roots.sides_at_far[i];
      continue;
    }
    traced.open[i] = false;
    if (!(roots.t[i] < hits.t[i])) continue;
    hits.t[i] = roots.t[i], hits.t_lo[i] = roots.lo[i], hits.t_hi[i] = roots.hi[i];
    hits.s[i] = kNoNormal;
    hits.iso[i] = roots.iso[i];
    hits.sides[i] = roots.sides[i];
    hits.object[i] = options_.object;
    hits.certificate[i] = roots.proved[i] ? Certificate::proved_hit : otherwise;
  }
}

void FrustumTracer::solve(std::span<Traced* const> streams) const {
  const RayFormQuery query = ray_query();
  if (!solver_) {
    const FrustumKernels& kernels = frustum_kernels(options_.isa);
    void* const registers = registers_of(tape_.registers * kernels.register_bytes);
    for (Traced* const one : streams) kernels.solve_rays(query, one->forms, one->roots, registers);
    return;
  }
  std::vector<const RayFormStream*> forms;
  std::vector<RayFormRoots*> roots;
  for (Traced* const one : streams) {
    forms.push_back(&one->forms);
    roots.push_back(&one->roots);
  }
  solver_->solve(query, forms, roots);
}

void FrustumTracer::trace(bool next, std::span<const RayStream> rays, std::span<HitStream* const> hits,
                          TraceCounts& counts) const {
  std::vector<std::unique_ptr<Traced>> all;
  for (std::size_t s = 0; s < rays.size(); ++s) {
    all.push_back(std::make_unique_for_overwrite<Traced>());
    begin(next, rays[s], *hits[s], *all.back());
  }
  for (int part = 0; part < parts_of(options_.degree); ++part) {
    std::vector<Traced*> open;
    std::vector<HitStream*> open_hits;
    for (std::size_t s = 0; s < all.size(); ++s) {
      if (!set_part(part, *all[s], counts)) continue;
      open.push_back(all[s].get());
      open_hits.push_back(hits[s]);
    }
    if (open.empty()) return;
    solve(open);
    for (std::size_t n = 0; n < open.size(); ++n) take_roots(*open[n], *open_hits[n]);
  }
}

}  // namespace isocast
