#include <isocast/implicit/beam_fit.h>
#include <isocast/implicit/ray_beams.h>
#include <isocast/math/rounding.h>

#include <algorithm>
#include <cmath>

namespace isocast {
namespace {

constexpr int kMostSlabs = 64;

template <class T> void copy_beam(const BeamStream<T>& from, int i, BeamStream<T>& to, int j) {
  for (int a = 0; a < 3; ++a) {
    to.e[a][j] = from.e[a][i], to.eu[a][j] = from.eu[a][i], to.ev[a][j] = from.ev[a][i];
    to.d[a][j] = from.d[a][i], to.du[a][j] = from.du[a][i], to.dv[a][j] = from.dv[a][i];
    to.slack[a][j] = from.slack[a][i], to.spread[a][j] = from.spread[a][i];
  }
  to.from[j] = from.from[i], to.to[j] = from.to[i];
}
template <class T> void copy_crossing(const BeamStream<T>& from, int i, BeamStream<T>& to, int j) {
  to.crosses[j] = from.crosses[i], to.rises[j] = from.rises[i], to.iso[j] = from.iso[i];
  to.at[j] = from.at[i], to.along_u[j] = from.along_u[i], to.along_v[j] = from.along_v[i];
  to.radius[j] = from.radius[i];
}
template <class T> void copy_findings(const BeamStream<T>& from, int i, BeamStream<T>& to, int j) {
  to.from[j] = std::max(from.from[i], to.from[j]), to.run_to[j] = from.run_to[i];
  copy_crossing(from, i, to, j);
}

// Beams around the packets of a tile, cut together with it and then each for itself.
template <class T> class PacketBeams {
 public:
  PacketBeams(const RayStream& stream, const ClippedRay* rays) {
    if (!planes_.enclose(rays, stream.size)) return;
    for (int i = 0; i < stream.size; ++i)
      if (!rays[i].misses()) {
        paths_[i] = planes_.path(rays[i]);
        longest_ = std::max(longest_, paths_[i].dt * length(rays[i].d));
      }
    BeamPoints tile;
    packets_.count = kMostBeams;
    for (int p = 0; p < kMostBeams; ++p) {
      BeamPoints points;
      for (int i = p * kPacketSize; i < std::min((p + 1) * kPacketSize, stream.size); ++i)
        if (!rays[i].misses()) points.add(planes_, rays[i], paths_[i], stream.u[i], stream.v[i]);
      packets_.from[p] = T(2), packets_.to[p] = T(-1);
      if (points.count == 0) continue;
      packets_.from[p] = T(0), packets_.to[p] = T(1);
      frames_[p] = fit_beam(points, packets_, p);
      add_corners(packets_, p, frames_[p], tile);
      usable_ = true;
    }
    if (usable_) (void)fit_beam(tile, tile_, 0);
  }
  [[nodiscard]] bool usable() const { return usable_; }
  /// A world length as a share of the longest ray between the planes.
  [[nodiscard]] double share_of(double world_length) const { return world_length / longest_; }
  [[nodiscard]] std::int64_t evaluations() const { return evaluations_; }

  void narrow(const FormulaQuery<T>& query, const FormulaSolver<T>& solver, double least, void* registers) {
    tile_.count = 1;
    tile_.slabs = kMostSlabs;
    tile_.from[0] = 0, tile_.to[0] = 1;
    solver.narrow(query, tile_, registers);
    evaluations_ = tile_.evaluations;
    for (int p = 0; p < kMostBeams; ++p) {
      packets_.from[p] = std::max(packets_.from[p], tile_.from[0]);
      packets_.to[p] = std::min(packets_.to[p], tile_.to[0]);
    }
    Batch batch;
    for (int p = 0; p < kMostBeams; ++p)
      if (packets_.from[p] <= packets_.to[p]) batch.add(packets_, p);
    if (batch.beams.count == 0) return;
    batch.beams.slabs = kMostSlabs / kMostBeams;
    look(batch, query, solver, registers);
    for (int b = 0; b < batch.beams.count; ++b) {
      const int p = batch.of[b];
      copy_findings(batch.beams, b, packets_, p);
      packets_.to[p] = batch.beams.to[b];
    }
    find_crossings(query, solver, least, registers);
  }

  // What is left of a ray.
  void cut(int i, double u, double v, const FormulaQuery<T>& query, double least, ClippedRay& ray,
           KnownCrossing& known) const {
    const int p = i / kPacketSize;
    if (packets_.from[p] > packets_.to[p]) {
      ray.far = ray.near;
      return;
    }
    const auto [t0, dt, rounding] = paths_[i];
    if (packets_.crosses[p]) {
      const BeamFrame& frame = frames_[p];
      const double at_u = (u - frame.u) / frame.half_u, at_v = (v - frame.v) / frame.half_v,
                   k = double(packets_.at[p]) + at_u * (double(packets_.along_u[p]) + shear_u_[p]) +
                       at_v * (double(packets_.along_v[p]) + shear_v_[p]),
                   radius = double(packets_.radius[p]);
      const double near = t0 + (k - radius) * dt - rounding, far = t0 + (k + radius) * dt + rounding;
      // a ray may end before, or begin behind
      if (near >= ray.near && far <= ray.far) {
        ray.near = near, ray.far = far;
        if (is_found(p, least)) known = {true, packets_.iso[p], sides_before(p, query)};
        return;
      }
    }
    // behind the last root f has its side again before the ray ends
    constexpr double kBehind = 1.0 / 64;
    const double begin = packets_.from[p], end = packets_.to[p];
    ray.near = std::max(ray.near, t0 + begin * dt - rounding);
    ray.far = std::min(ray.far, t0 + (end + kBehind * (end - begin)) * dt + rounding);
  }

 private:
  // Some of the packets, to be looked at together.
  struct Batch {
    BeamStream<T> beams = {};
    int of[kMostBeams];
    void add(const BeamStream<T>& packets, int p) {
      of[beams.count] = p;
      copy_beam(packets, p, beams, beams.count++);
    }
  };
  void look(Batch& batch, const FormulaQuery<T>& query, const FormulaSolver<T>& solver, void* registers) {
    solver.narrow(query, batch.beams, registers);
    evaluations_ += batch.beams.evaluations;
  }

  // Trims the first run of slabs, as one, and follows the slant of the crossing that it turns out to be, for
  // as long as it shrinks.
  void find_crossings(const FormulaQuery<T>& query, const FormulaSolver<T>& solver, double least,
                      void* registers) {
    constexpr T kWorth = T(0.7), kAround = T(0.25);
    T length[kMostBeams];
    std::ranges::fill(length, T(2));
    for (;;) {
      Batch batch;
      for (int p = 0; p < kMostBeams; ++p) {
        if (packets_.from[p] > packets_.to[p] || is_found(p, least)) continue;
        const T from = packets_.crosses[p] ? packets_.at[p] - 2 * packets_.radius[p] : packets_.from[p],
                to = packets_.crosses[p] ? packets_.at[p] + 2 * packets_.radius[p] : packets_.run_to[p];
        if (!(to - from < kWorth * length[p])) continue;
        length[p] = to - from;
        if (packets_.crosses[p]) shear(p);
        const int b = batch.beams.count;
        batch.add(packets_, p);
        const T around = packets_.crosses[p] ? T(0) : kAround * (to - from);
        batch.beams.from[b] = from - around, batch.beams.to[b] = to + around;
      }
      if (batch.beams.count == 0) return;
      batch.beams.slabs = 1;
      look(batch, query, solver, registers);
      for (int b = 0; b < batch.beams.count; ++b) {
        const int p = batch.of[b];
        if (packets_.crosses[p]) {
          // the same crossing, better known
          if (batch.beams.crosses[b]) copy_crossing(batch.beams, b, packets_, p);
          else packets_.along_u[p] = packets_.along_v[p] = T(0);
          continue;
        }
        const T end = packets_.run_to[p];
        copy_findings(batch.beams, b, packets_, p);
        // nothing in this run: the rest is left to the rays
        if (batch.beams.from[b] > batch.beams.to[b]) packets_.from[p] = packets_.run_to[p] = end;
      }
    }
  }
  // Counts k from the plane of the packet's crossing: k + u along_u + v along_v becomes k.
  void shear(int p) {
    const T su = packets_.along_u[p], sv = packets_.along_v[p];
    const double across = std::abs(double(su)) + std::abs(double(sv));
    for (int a = 0; a < 3; ++a) {
      const T d = packets_.d[a][p], u = su * d, v = sv * d;
      packets_.eu[a][p] += u, packets_.ev[a][p] += v;
      const double twist = std::abs(double(packets_.du[a][p])) + std::abs(double(packets_.dv[a][p])),
                   rounding = std::abs(double(u)) + std::abs(double(v)) +
                              std::abs(double(packets_.eu[a][p])) + std::abs(double(packets_.ev[a][p]));
      packets_.slack[a][p] = static_cast<T>(
          (1 + 4.0 * kSpacing<T>)*(double(packets_.slack[a][p]) + across * twist +
                                   across * double(packets_.spread[a][p]) + kSpacing<T> * rounding));
    }
    shear_u_[p] += double(su), shear_v_[p] += double(sv);
    packets_.along_u[p] = packets_.along_v[p] = T(0);
  }

  // Whether all rays of the packet cross, in brackets no longer than `least`, in k.
  [[nodiscard]] bool is_found(int p, double least) const {
    return packets_.crosses[p] && 2 * double(packets_.radius[p]) <= least;
  }
  // f lies on the same side of the other iso-values as the one that it crosses.
  [[nodiscard]] std::uint32_t sides_before(int p, const FormulaQuery<T>& query) const {
    const int crossed = packets_.iso[p];
    std::uint32_t sides = std::uint32_t(packets_.rises[p]) << crossed;
    for (int i = 0; i < query.iso_count; ++i)
      if (i != crossed) sides |= std::uint32_t(query.iso_lo[crossed] < query.iso_lo[i]) << i;
    return sides;
  }

  BeamPlanes planes_;
  AxisPath paths_[kStreamSize];
  BeamFrame frames_[kMostBeams];
  BeamStream<T> packets_ = {}, tile_ = {};
  std::int64_t evaluations_ = 0;
  double longest_ = 0, shear_u_[kMostBeams] = {}, shear_v_[kMostBeams] = {};
  bool usable_ = false;
};

}  // namespace

template <class T>
std::int64_t narrow_rays(const FormulaQuery<T>& query, const FormulaSolver<T>& solver,
                         const RayStream& stream, double eps, ClippedRay* rays, KnownCrossing* known,
                         void* registers) {
  PacketBeams<T> beams(stream, rays);
  if (!beams.usable()) return 0;
  const double least = beams.share_of(eps);
  beams.narrow(query, solver, least, registers);
  for (int i = 0; i < stream.size; ++i)
    if (!rays[i].misses()) beams.cut(i, stream.u[i], stream.v[i], query, least, rays[i], known[i]);
  return beams.evaluations();
}

template std::int64_t narrow_rays(const FormulaQuery<float>&, const FormulaSolver<float>&, const RayStream&,
                                  double, ClippedRay*, KnownCrossing*, void*);
template std::int64_t narrow_rays(const FormulaQuery<double>&, const FormulaSolver<double>&, const RayStream&,
                                  double, ClippedRay*, KnownCrossing*, void*);

}  // namespace isocast
