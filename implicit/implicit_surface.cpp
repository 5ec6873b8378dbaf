#include <fmt/format.h>
#include <isocast/base/error.h>
#include <isocast/implicit/expression/simplify.h>
#include <isocast/implicit/implicit_surface.h>
#include <isocast/implicit/solve/inclusion.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>

namespace isocast {
namespace {

// Registers of a tape for one thread, kept from packet to packet.
void* registers_of(std::size_t bytes) {
  struct Free {
    void operator()(void* p) const { std::free(p); }
  };
  thread_local std::unique_ptr<void, Free> memory;
  thread_local std::size_t size = 0;
  if (bytes > size) {
    size = (bytes + 63) & ~std::size_t(63);
    memory.reset(std::aligned_alloc(64, size));
    if (!memory) throw std::bad_alloc();
  }
  return memory.get();
}

// The numbers of a type at and beside an inclusion in doubles.
template <class T> void enclose(const Interval<double>& x, T& lo, T& hi) {
  lo = enclosed<T>(x.lo, true).lo;
  hi = enclosed<T>(x.hi, true).hi;
}

// A ray clipped to the box: p(t) for t in [near, far].
struct ClippedRay {
  Double3 o, d;
  double near, far;
  [[nodiscard]] bool misses() const { return !(near < far); }
};
ClippedRay clip(const RayStream& rays, int i, const Box& box) {
  ClippedRay ray{{rays.ox[i], rays.oy[i], rays.oz[i]},
                 {rays.dx[i], rays.dy[i], rays.dz[i]},
                 rays.t_min[i],
                 rays.t_max[i]};
  for (int a = 0; a < 3; ++a) {
    if (ray.d[a] == 0) {
      if (!(ray.o[a] >= box.lo[a] && ray.o[a] <= box.hi[a]))
        ray.far = -std::numeric_limits<double>::infinity();
      continue;
    }
    const double t0 = (box.lo[a] - ray.o[a]) / ray.d[a], t1 = (box.hi[a] - ray.o[a]) / ray.d[a];
    ray.near = std::max(ray.near, std::min(t0, t1));
    ray.far = std::min(ray.far, std::max(t0, t1));
  }
  return ray;
}

}  // namespace

ImplicitSurface::ImplicitSurface(const Expression& expression, const Domain& domain,
                                 const ImplicitSurfaceOptions& options)
    : tape_(make_tape(simplify(expression))) {
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
  for (std::size_t i = 0; i < options_.iso.size(); ++i)
    enclose(Interval<double>(options_.iso[i]), query.iso_lo[i], query.iso_hi[i]);
  query.time = options_.time;
  query.options = options_.method.options;
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
  eps_ = options.method.eps > 0 ? options.method.eps : options.method.eps_rel * longest;
  float_query_ = make_query<float>();
  double_query_ = make_query<double>();
}

template <class T>
void ImplicitSurface::trace(const FormulaQuery<T>& query, bool next, const RayStream& rays, HitStream& hits,
                            TraceCounts& counts) const {
  const FormulaKernels& kernels = formula_kernels(options_.isa);
  void* const registers = registers_of(tape_.registers * kernels.register_bytes);
  const auto method = static_cast<std::size_t>(options_.method.method);
  for (int first = 0; first < rays.size; first += kSegments) {
    SegmentPacket<T> packet = {};
    ClippedRay clipped[kSegments];
    for (int l = 0; l < kSegments && first + l < rays.size; ++l) {
      const int i = first + l;
      const bool has_hit =
          hits.object[i] == options_.object && hits.t[i] < std::numeric_limits<double>::infinity();
      if (next && !has_hit) continue;
      const ClippedRay ray = clipped[l] = clip(rays, i, bounds_);
      const bool carried = next || rays.start_object[i] == options_.object;
      packet.sides[l] = next ? sides_behind(hits, i) : rays.start_sides[i];
      packet.begin[l] = next ? static_cast<T>(hits.s_hi[i]) : T(0);
      if (next) hits.t[i] = hits.t_lo[i] = hits.t_hi[i] = std::numeric_limits<double>::infinity();
      if (ray.misses()) continue;
      packet.active |= 1u << l;
      packet.carried |= static_cast<std::uint32_t>(carried) << l;
      double squared = 0;
      for (int a = 0; a < 3; ++a) {
        const Interval<double> o(ray.o[a]), d(ray.d[a]), near(ray.near), far(ray.far),
            e = o + near * d, span = (far - near) * d;
        enclose(e, packet.e_lo[a][l], packet.e_hi[a][l]);
        enclose(span, packet.d_lo[a][l], packet.d_hi[a][l]);
        const double longest = std::max(std::abs(span.lo), std::abs(span.hi));
        squared += longest * longest;
      }
      packet.smallest[l] = static_cast<T>(std::min(1.0, eps_ / std::sqrt(squared)));
    }
    if (packet.active == 0) continue;
    SegmentRoots<T> roots;
    if constexpr (sizeof(T) == 4) kernels.solve_float[method](query, packet, roots, registers);
    else kernels.solve_double[method](query, packet, roots, registers);

    for (std::uint32_t rest = packet.active; rest; rest &= rest - 1) {
      const int l = __builtin_ctz(rest), i = first + l;
      const bool hit = roots.hit >> l & 1, proved = roots.proved >> l & 1;
      hits.cost[i] += roots.evaluations[l];
      counts.evaluations += roots.evaluations[l];
      if (!hit) {
        if (!proved) hits.certificate[i] = Certificate::undecided;
        continue;
      }
      const ClippedRay& ray = clipped[l];
      const auto t_at = [&](T s) { return ray.near + static_cast<double>(s) * (ray.far - ray.near); };
      const double t = t_at(roots.s[l]);
      if (!(t < hits.t[i])) continue;
      hits.t[i] = t;
      // what the roundings of t_at can make
      const double slack = 0x1p-51 * std::max(std::abs(ray.near), std::abs(ray.far));
      hits.t_lo[i] = t_at(roots.s_lo[l]) - slack;
      hits.t_hi[i] = t_at(roots.s_hi[l]) + slack;
      hits.s[i] = static_cast<double>(roots.s[l]);
      hits.s_hi[i] = static_cast<double>(roots.s_hi[l]);
      hits.iso[i] = roots.iso[l];
      hits.object[i] = options_.object;
      hits.sides[i] = roots.sides[l];
      hits.certificate[i] = proved ? Certificate::proved_hit : Certificate::undecided;
    }
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

void ImplicitSurface::dress(const RayStream& rays, const HitStream& hits, const DressWishes& wishes,
                            DressedHits& dressed) const {
  const DefaultFloatEnvironment environment;
  using F = Gradient<double>;
  auto* const registers = static_cast<F*>(registers_of(tape_.registers * sizeof(F)));
  for (int i = 0; i < rays.size; ++i) {
    if (hits.object[i] != options_.object || !(hits.t[i] < std::numeric_limits<double>::infinity())) continue;
    const Double3 d = {rays.dx[i], rays.dy[i], rays.dz[i]},
                  p = Double3{rays.ox[i], rays.oy[i], rays.oz[i]} + hits.t[i] * d;
    if (wishes.position)
      for (int a = 0; a < 3; ++a) dressed.position[a][i] = p[a];
    if (!wishes.normal && !wishes.value) continue;
    const F inputs[4] = {{p[0], 1, 0, 0}, {p[1], 0, 1, 0}, {p[2], 0, 0, 1}, F(options_.time)};
    const F f = evaluate(tape_.view(), inputs, registers);
    if (wishes.value) dressed.value[i] = f.value;
    if (!wishes.normal) continue;
    const Double3 normal = normalized({f.dx, f.dy, f.dz});
    const double turn = dot(normal, d) > 0 ? -1 : 1;
    for (int a = 0; a < 3; ++a) dressed.normal[a][i] = turn * normal[a];
  }
}

}  // namespace isocast
