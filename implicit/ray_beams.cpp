#include <isocast/implicit/ray_beams.h>
#include <isocast/math/rounding.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isocast {
namespace {

// Where a ray meets the planes of one axis: t = t0 + k dt for 0 <= k <= 1, within `rounding`.
struct AxisPath {
  double t0, dt, rounding;
};

// The planes from `from` to `to` along `sign` times an axis, between which all rays run.
struct Planes {
  int axis = 0;
  double sign = 1, from = std::numeric_limits<double>::infinity(), to = -from;

  [[nodiscard]] AxisPath path(const ClippedRay& ray) const {
    const double o = sign * ray.o[axis], per_d = 1 / (sign * ray.d[axis]);
    const double t0 = (from - o) * per_d, dt = (to - from) * per_d;
    return {t0, dt, 0x1p-49 * (std::abs(t0) + dt + (std::abs(from) + std::abs(o)) * per_d)};
  }
};

// False where a ray is too slanted.
bool find_planes(const ClippedRay* rays, int size, Planes& planes) {
  double sum[3] = {};
  for (int i = 0; i < size; ++i)
    for (int a = 0; a < 3; ++a) sum[a] += rays[i].misses() ? 0 : rays[i].d[a];
  for (int a = 1; a < 3; ++a)
    if (std::abs(sum[a]) > std::abs(sum[planes.axis])) planes.axis = a;
  planes.sign = sum[planes.axis] < 0 ? -1 : 1;
  constexpr double kMostSlanted = 4;
  for (int i = 0; i < size; ++i) {
    const ClippedRay& ray = rays[i];
    if (ray.misses()) continue;
    const double d = planes.sign * ray.d[planes.axis], o = planes.sign * ray.o[planes.axis];
    for (int a = 0; a < 3; ++a)
      if (!(std::abs(ray.d[a]) <= kMostSlanted * d)) return false;
    planes.from = std::min(planes.from, o + ray.near * d);
    planes.to = std::max(planes.to, o + ray.far * d);
  }
  const double rounding = 0x1p-45 * (std::abs(planes.from) + std::abs(planes.to));
  planes.from -= rounding, planes.to += rounding;
  return std::isfinite(planes.to - planes.from);
}

// A box around the rays' starts and spans, axis by axis, and what their roundings make.
struct Hull {
  double start[3][2], span[3][2], rounding[3] = {};
  bool empty = true;

  Hull() {
    for (int a = 0; a < 3; ++a) {
      start[a][0] = span[a][0] = std::numeric_limits<double>::infinity();
      start[a][1] = span[a][1] = -start[a][0];
    }
  }
  void add(int a, double from, double length, double slack) {
    start[a][0] = std::min(start[a][0], from), start[a][1] = std::max(start[a][1], from);
    span[a][0] = std::min(span[a][0], length), span[a][1] = std::max(span[a][1], length);
    rounding[a] = std::max(rounding[a], slack);
    empty = false;
  }
  void add(const Hull& other) {
    if (other.empty) return;
    for (int a = 0; a < 3; ++a)
      for (int end = 0; end < 2; ++end) add(a, other.start[a][end], other.span[a][end], other.rounding[a]);
  }
  void add(const Planes& planes, const ClippedRay& ray, const AxisPath& path) {
    for (int a = 0; a < 3; ++a) {
      if (a == planes.axis) {
        add(a, planes.sign * planes.from, planes.sign * (planes.to - planes.from),
            0x1p-49 * (std::abs(planes.from) + std::abs(planes.to)));
        continue;
      }
      const double offset = path.t0 * ray.d[a], length = path.dt * ray.d[a];
      add(a, ray.o[a] + offset, length,
          path.rounding * std::abs(ray.d[a]) +
              0x1p-49 * (std::abs(ray.o[a]) + std::abs(offset) + std::abs(length)));
    }
  }
};

template <class T> T rounded_up(double x) { return std::nextafter(static_cast<T>(x), kInfinity<T>); }

template <class T> void set_beam(BeamStream<T>& beams, int b, const Hull& hull) {
  for (int a = 0; a < 3; ++a) {
    const auto [e0, e1] = hull.start[a];
    const auto [d0, d1] = hull.span[a];
    const T e = beams.e[a][b] = static_cast<T>(0.5 * (e0 + e1)),
            d = beams.d[a][b] = static_cast<T>(0.5 * (d0 + d1));
    // what RayPart and the kernel round
    const double size = std::abs(double(e)) + std::abs(double(d));
    beams.slack[a][b] = rounded_up<T>((1 + 4.0 * kSpacing<T>)*std::max(e1 - double(e), double(e) - e0) +
                                      hull.rounding[a] + 5.0 * kSpacing<T> * size + 4.0 * kSmallest<T>);
    beams.spread[a][b] =
        rounded_up<T>((1 + 4.0 * kSpacing<T>)*std::max(d1 - double(d), double(d) - d0) + 4.0 * kSmallest<T>);
  }
}

}  // namespace

template <class T>
std::int64_t narrow_rays(const FormulaQuery<T>& query, const FormulaSolver<T>& solver, ClippedRay* rays,
                         int size, void* registers) {
  Planes planes;
  if (!find_planes(rays, size, planes)) return 0;
  AxisPath paths[kStreamSize];
  Hull tile, packets[kMostBeams];
  for (int i = 0; i < size; ++i) {
    if (rays[i].misses()) continue;
    paths[i] = planes.path(rays[i]);
    packets[i / kPacketSize].add(planes, rays[i], paths[i]);
  }
  for (const Hull& packet : packets) tile.add(packet);

  BeamStream<T> beams = {};
  beams.count = 1;
  beams.from[0] = 0, beams.to[0] = 1;
  set_beam(beams, 0, tile);
  solver.narrow(query, beams, registers);
  T from[kMostBeams], to[kMostBeams];
  std::ranges::fill(from, beams.from[0]);
  std::ranges::fill(to, beams.to[0]);
  // twice, if once was worth it
  constexpr double kWorth = 0.8;
  bool more = true;
  for (int round = 0; round < 2 && more; ++round) {
    int of[kMostBeams];
    double before = 0, after = 0;
    beams.count = 0;
    for (int p = 0; p < kMostBeams; ++p) {
      if (packets[p].empty || from[p] > to[p]) continue;
      const int b = beams.count++;
      of[b] = p;
      set_beam(beams, b, packets[p]);
      beams.from[b] = from[p], beams.to[b] = to[p];
      before += to[p] - from[p];
    }
    if (beams.count == 0) break;
    solver.narrow(query, beams, registers);
    for (int b = 0; b < beams.count; ++b) {
      from[of[b]] = beams.from[b], to[of[b]] = beams.to[b];
      after += std::max(T(0), beams.to[b] - beams.from[b]);
    }
    more = after < kWorth * before;
  }

  // behind the last root f has its side again before the ray ends
  constexpr double kBehind = 1.0 / 64;
  for (int i = 0; i < size; ++i) {
    ClippedRay& ray = rays[i];
    if (ray.misses()) continue;
    const int p = i / kPacketSize;
    const auto [t0, dt, rounding] = paths[i];
    if (from[p] > to[p]) {
      ray.far = ray.near;
      continue;
    }
    const double begin = from[p], end = to[p], behind = kBehind * (end - begin);
    ray.near = std::max(ray.near, t0 + begin * dt - rounding);
    ray.far = std::min(ray.far, t0 + (end + behind) * dt + rounding);
  }
  return beams.evaluations;
}

template std::int64_t narrow_rays(const FormulaQuery<float>&, const FormulaSolver<float>&, ClippedRay*, int,
                                  void*);
template std::int64_t narrow_rays(const FormulaQuery<double>&, const FormulaSolver<double>&, ClippedRay*, int,
                                  void*);

}  // namespace isocast
