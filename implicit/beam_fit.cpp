#include <isocast/implicit/beam_fit.h>
#include <isocast/math/rounding.h>

#include <algorithm>
#include <cmath>

namespace isocast {
namespace {

// 16 unit roundoffs: more than any of the sums below makes.
constexpr double kRoundings = 0x1p-49;

// The places of points, from -1 to 1, and what least squares need of them.
struct Places {
  int count;
  double u[BeamPoints::kMost], v[BeamPoints::kMost], per_uu, per_vv;

  Places(const BeamPoints& points, const BeamFrame& frame) : count(points.count) {
    double uu = 0, vv = 0;
    for (int i = 0; i < count; ++i) {
      u[i] = (points.u[i] - frame.u) / frame.half_u, v[i] = (points.v[i] - frame.v) / frame.half_v;
      uu += u[i] * u[i], vv += v[i] * v[i];
    }
    per_uu = uu > 0 ? 1 / uu : 0, per_vv = vv > 0 ? 1 / vv : 0;
  }
};

// value = c + u cu + v cv, and how far the points are from that, with numbers rounded to T.
template <class T> struct Plane {
  T c, cu, cv;
  double distance = 0;

  Plane(const Places& places, const double (&values)[BeamPoints::kMost]) {
    double mean = 0, uf = 0, vf = 0;
    for (int i = 0; i < places.count; ++i) mean += values[i];
    mean /= places.count;
    for (int i = 0; i < places.count; ++i) {
      const double f = values[i] - mean;
      uf += places.u[i] * f, vf += places.v[i] * f;
    }
    c = static_cast<T>(mean);
    cu = static_cast<T>(uf * places.per_uu), cv = static_cast<T>(vf * places.per_vv);
    const double at = double(c), along_u = double(cu), along_v = double(cv);
    for (int i = 0; i < places.count; ++i)
      distance =
          std::max(distance, std::abs(values[i] - (at + places.u[i] * along_u + places.v[i] * along_v)));
    distance += kRoundings * (std::abs(mean) + std::abs(along_u) + std::abs(along_v));
  }
  [[nodiscard]] double size() const {
    return std::abs(double(c)) + std::abs(double(cu)) + std::abs(double(cv));
  }
};

template <class T> T rounded_up(double x) { return std::nextafter(static_cast<T>(x), kInfinity<T>); }

BeamFrame frame_of(const BeamPoints& points) {
  const auto [u0, u1] = std::minmax_element(points.u, points.u + points.count);
  const auto [v0, v1] = std::minmax_element(points.v, points.v + points.count);
  const auto half = [](double lo, double hi) { return hi > lo ? 0.5 * (hi - lo) : 1; };
  return {0.5 * (*u0 + *u1), 0.5 * (*v0 + *v1), half(*u0, *u1), half(*v0, *v1)};
}

}  // namespace

bool BeamPlanes::enclose(const ClippedRay* rays, int size) {
  double sum[3] = {};
  for (int i = 0; i < size; ++i)
    for (int a = 0; a < 3; ++a) sum[a] += rays[i].misses() ? 0 : rays[i].d[a];
  for (int a = 1; a < 3; ++a)
    if (std::abs(sum[a]) > std::abs(sum[axis])) axis = a;
  sign = sum[axis] < 0 ? -1 : 1;
  constexpr double kMostSlanted = 4;
  for (int i = 0; i < size; ++i) {
    const ClippedRay& ray = rays[i];
    if (ray.misses()) continue;
    const double d = sign * ray.d[axis], o = sign * ray.o[axis];
    for (int a = 0; a < 3; ++a)
      if (!(std::abs(ray.d[a]) <= kMostSlanted * d)) return false;
    from = std::min(from, o + ray.near * d);
    to = std::max(to, o + ray.far * d);
  }
  const double rounding = 0x1p-45 * (std::abs(from) + std::abs(to));
  from -= rounding, to += rounding;
  return from < to && std::isfinite(to - from);
}

AxisPath BeamPlanes::path(const ClippedRay& ray) const {
  const double o = sign * ray.o[axis], per_d = 1 / (sign * ray.d[axis]);
  const double t0 = (from - o) * per_d, dt = (to - from) * per_d;
  return {t0, dt, kRoundings * (std::abs(t0) + dt + (std::abs(from) + std::abs(o)) * per_d)};
}

void BeamPoints::add(const BeamPlanes& planes, const ClippedRay& ray, const AxisPath& path, double at_u,
                     double at_v) {
  const int i = count++;
  u[i] = at_u, v[i] = at_v;
  for (int a = 0; a < 3; ++a) {
    const double offset = path.t0 * ray.d[a], o = ray.o[a];
    const bool along = a == planes.axis;
    start[a][i] = along ? planes.sign * planes.from : o + offset;
    span[a][i] = along ? planes.sign * (planes.to - planes.from) : path.dt * ray.d[a];
    rounding[a] = std::max(rounding[a], path.rounding * std::abs(ray.d[a]) +
                                            kRoundings * (std::abs(o) + std::abs(offset) +
                                                          std::abs(span[a][i]) + std::abs(start[a][i])));
  }
}

template <class T> BeamFrame fit_beam(const BeamPoints& points, BeamStream<T>& beams, int b) {
  const BeamFrame frame = frame_of(points);
  const Places places(points, frame);
  for (int a = 0; a < 3; ++a) {
    const Plane<T> start(places, points.start[a]), span(places, points.span[a]);
    beams.e[a][b] = start.c, beams.eu[a][b] = start.cu, beams.ev[a][b] = start.cv;
    beams.d[a][b] = span.c, beams.du[a][b] = span.cu, beams.dv[a][b] = span.cv;
    // what the kernel rounds
    const double rounding = 8.0 * kSpacing<T> * (start.size() + span.size()) + 8.0 * kSmallest<T>;
    beams.slack[a][b] = rounded_up<T>(start.distance + points.rounding[a] + rounding);
    beams.spread[a][b] = rounded_up<T>(span.distance + 8.0 * kSmallest<T>);
  }
  return frame;
}

template <class T>
void add_corners(const BeamStream<T>& beams, int b, const BeamFrame& frame, BeamPoints& points) {
  for (const double u : {-1.0, 1.0})
    for (const double v : {-1.0, 1.0}) {
      const int i = points.count++;
      points.u[i] = frame.u + u * frame.half_u, points.v[i] = frame.v + v * frame.half_v;
      for (int a = 0; a < 3; ++a) {
        points.start[a][i] = double(beams.e[a][b]) + u * double(beams.eu[a][b]) + v * double(beams.ev[a][b]);
        points.span[a][i] = double(beams.d[a][b]) + u * double(beams.du[a][b]) + v * double(beams.dv[a][b]);
        points.rounding[a] =
            std::max(points.rounding[a],
                     double(beams.slack[a][b]) + double(beams.spread[a][b]) +
                         kRoundings * (std::abs(points.start[a][i]) + std::abs(points.span[a][i])));
      }
    }
}

template BeamFrame fit_beam(const BeamPoints&, BeamStream<float>&, int);
template BeamFrame fit_beam(const BeamPoints&, BeamStream<double>&, int);
template void add_corners(const BeamStream<float>&, int, const BeamFrame&, BeamPoints&);
template void add_corners(const BeamStream<double>&, int, const BeamFrame&, BeamPoints&);

}  // namespace isocast
