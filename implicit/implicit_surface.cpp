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

// The number nearest to the middle of x, and the half width of what lies between it and x's ends.
template <class T> void enclose(const Interval<double>& x, T& middle, double& radius) {
  middle = static_cast<T>(0.5 * x.lo + 0.5 * x.hi);
  radius = std::max(x.hi - static_cast<double>(middle), static_cast<double>(middle) - x.lo);
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

// Segment i of the stream from a clipped ray; parts below eps, a world length, need not be divided.
template <class T> void set_segment(SegmentStream<T>& segments, int i, const ClippedRay& ray, double eps) {
  double squared = 0;
  for (int a = 0; a < 3; ++a) {
    const Interval<double> o(ray.o[a]), d(ray.d[a]), near(ray.near), far(ray.far), start = o + near * d,
                                                                                   span = (far - near) * d;
    T& e_T = segments.e[a][i];
    T& d_T = segments.d[a][i];
    double e_radius = 0, d_radius = 0;
    enclose(start, e_T, e_radius);
    enclose(span, d_T, d_radius);
    // what RayPart rounds: at most eight times the unit roundoff of |e| + |d|
    const double size = std::abs(static_cast<double>(e_T)) + std::abs(static_cast<double>(d_T));
    const double slack = e_radius + d_radius + 5.0 * kSpacing<T> * size + 4.0 * kSmallest<T>;
    segments.slack[a][i] = std::nextafter(static_cast<T>(slack), kInfinity<T>);
    if (!(size <= kLargest<T>)) e_T = d_T = 0, segments.slack[a][i] = kInfinity<T>;
    const double longest = std::max(std::abs(span.lo), std::abs(span.hi));
    squared += longest * longest;
  }
  segments.smallest[i] = static_cast<T>(std::min(0x1p100, eps / std::sqrt(squared)));
  segments.k_offset[i] = 0;
  segments.k_scale[i] = 1;
}

// Sets one path for all rays of a packet along the axis that they follow most: false where one of them does
// not.
template <class T> bool march_together(SegmentStream<T>& segments, int first) {
  const int last = std::min(first + kPacketSize, segments.size);
  double sum[3] = {};
  for (int a = 0; a < 3; ++a)
    for (int i = first; i < last; ++i) sum[a] += segments.active[i] ? double(segments.d[a][i]) : 0;
  int axis = 0;
  for (int a = 1; a < 3; ++a)
    if (std::abs(sum[a]) > std::abs(sum[axis])) axis = a;
  const double sign = sum[axis] < 0 ? -1 : 1;
  double from = std::numeric_limits<double>::infinity(), to = -from;
  for (int i = first; i < last; ++i) {
    if (!segments.active[i]) continue;
    const double e = sign * segments.e[axis][i], d = sign * segments.d[axis][i];
    if (!(d > 0)) return false;
    from = std::min(from, e), to = std::max(to, e + d);
  }
  constexpr double kMostStretched = 1024;
  for (int i = first; i < last; ++i)
    if (segments.active[i] && !(to - from <= kMostStretched * sign * segments.d[axis][i])) return false;
  for (int i = first; i < last; ++i) {
    if (!segments.active[i]) continue;
    const double e = sign * segments.e[axis][i], d = sign * segments.d[axis][i];
    segments.k_offset[i] = static_cast<T>((from - e) / d);
    // a little further, so that rounding does not end the path early
    segments.k_scale[i] = static_cast<T>((to - from) / d * (1 + 4 * kSpacing<T>));
  }
  return true;
}

// The median length of f's gradient at points spread over the box (the sequence of the plastic number's
// cousin in three dimensions, Roberts 2018); 1 where it has none.
double median_gradient(const Tape& tape, const Box& box, double time) {
  using F = Gradient<double>;
  constexpr int kPoints = 1024;
  constexpr double kRatio = 1.2207440846057596;  // x^4 = x + 1
  auto* const registers = static_cast<F*>(registers_of(tape.registers * sizeof(F)));
  std::vector<double> lengths;
  for (int n = 1; n <= kPoints; ++n) {
    F inputs[4] = {F(0.0), F(0.0), F(0.0), F(time)};
    double step = 1;
    for (int a = 0; a < 3; ++a) {
      step /= kRatio;
      const double place = n * step - std::floor(n * step);
      inputs[a].value = box.lo[a] + place * (box.hi[a] - box.lo[a]);
    }
    inputs[0].dx = inputs[1].dy = inputs[2].dz = 1;
    const F f = evaluate(tape.view(), inputs, registers);
    const double size = length({f.dx, f.dy, f.dz});
    if (std::isfinite(size) && size > 0) lengths.push_back(size);
  }
  if (lengths.empty()) return 1;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
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
      set_segment(segments, i, ray, eps_);
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
