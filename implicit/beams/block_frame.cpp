#include <isocast/implicit/beams/block_frame.h>
#include <isocast/math/rounding.h>
#include <isocast/ray/primary_pass.h>
#include <isocast/render/camera.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace isocast {
namespace {

static_assert(kBlockSide == kBlockTiles * kTileSize);

double largest(const Double3& a) { return std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])}); }

// A number of the model in T, and what its rounding makes of points that are `times` of it away.
template <class T> T rounded(double value, double times, double& error) {
  const T y = static_cast<T>(value);
  error += times * std::abs(value - static_cast<double>(y));
  return y;
}

}  // namespace

BlockFrame::BlockFrame(const View& view, const Box& box)
    : box_(box), width_(view.width()), height_(view.height()) {
  // the model goes through three rays of the picture or beyond its edge
  const int tiles = std::max(width_, height_) / kTileSize + 1;
  const double pixels = tiles * kTileSize;
  const auto rays = std::make_unique<RayStream>();
  Double3 o[3], d[3];
  for (int i = 0; i < 3; ++i) {
    view.fill(i == 1 ? tiles : 0, i == 2 ? tiles : 0, 0, 0, *rays);
    o[i] = {rays->ox[0], rays->oy[0], rays->oz[0]};
    d[i] = {rays->dx[0], rays->dy[0], rays->dz[0]};
    d[i] = (1 / dot(d[i], view.forward())) * d[i];
  }
  start_ = o[0], start_u_ = (1 / pixels) * (o[1] - o[0]), start_v_ = (1 / pixels) * (o[2] - o[0]);
  span_ = d[0], span_u_ = (1 / pixels) * (d[1] - d[0]), span_v_ = (1 / pixels) * (d[2] - d[0]);
  // some dozens of roundings of numbers as large as these
  constexpr double kRoundings = 0x1p-47;
  start_error_ = kRoundings * (largest(o[0]) + largest(o[1]) + largest(o[2]));
  span_error_ = kRoundings * (largest(d[0]) + largest(d[1]) + largest(d[2]));

  // z of the box; rays begin at z = 0
  nearest_ = kInfinity<double>, farthest_ = -kInfinity<double>;
  double scale = 0;
  for (int corner = 0; corner < 8; ++corner) {
    Double3 p;
    for (int a = 0; a < 3; ++a) p[a] = corner >> a & 1 ? box.hi[a] : box.lo[a];
    const double z = dot(p - o[0], view.forward());
    nearest_ = std::min(nearest_, z), farthest_ = std::max(farthest_, z);
    scale = std::max(scale, largest(p) + largest(o[0]));
  }
  nearest_ = std::max(nearest_ - 0x1p-40 * scale, 0.0), farthest_ += 0x1p-40 * scale;
}

template <class T>
BlockRays<T> BlockFrame::block(int bx, int by, double offset_u, double offset_v, double eps) const {
  BlockRays<T> rays = {};
  const double half = 0.5 * kBlockSide, u = bx * kBlockSide + half - 0.5 + offset_u,
               v = by * kBlockSide + half - 0.5 + offset_v;
  double longest = 0;
  for (int a = 0; a < 3; ++a) {
    const double span = span_[a] + u * span_u_[a] + v * span_v_[a],
                 start = start_[a] + u * start_u_[a] + v * start_v_[a];
    const double at = start + nearest_ * span, at_u = start_u_[a] + nearest_ * span_u_[a],
                 at_v = start_v_[a] + nearest_ * span_v_[a];
    double slack = start_error_ + nearest_ * span_error_ +
                   0x1p-49 * (std::abs(start) + nearest_ * std::abs(span)),
           spread = span_error_;
    rays.start[a] = rounded<T>(at, 1, slack);
    rays.start_u[a] = rounded<T>(at_u, half, slack), rays.start_v[a] = rounded<T>(at_v, half, slack);
    rays.span[a] = rounded<T>(span, 1, spread);
    rays.span_u[a] = rounded<T>(span_u_[a], half, spread);
    rays.span_v[a] = rounded<T>(span_v_[a], half, spread);
    // what kernels round
    const double size = std::abs(at) + half * (std::abs(at_u) + std::abs(at_v)),
                 span_size = std::abs(span) + half * (std::abs(span_u_[a]) + std::abs(span_v_[a]));
    rays.slack[a] = static_cast<T>((slack + 8.0 * kSpacing<T> * size) * (1 + 4.0 * kSpacing<T>));
    rays.spread[a] = static_cast<T>((spread + 8.0 * kSpacing<T> * span_size) * (1 + 4.0 * kSpacing<T>));
    rays.box_lo[a] = static_cast<T>(box_.lo[a]), rays.box_hi[a] = static_cast<T>(box_.hi[a]);
    rays.box_slack[a] = static_cast<T>(4.0 * kSpacing<T> * (std::abs(box_.lo[a]) + std::abs(box_.hi[a])));
    rays.exact[a] = span, rays.exact_u[a] = span_u_[a], rays.exact_v[a] = span_v_[a];
    longest += span_size * span_size;
  }
  const double per_depth = std::sqrt(longest);
  rays.depth = nearest_;
  const double depths = (farthest_ - nearest_) * (1 + 4.0 * kSpacing<T>);
  rays.most_depth = static_cast<T>(depths);
  rays.before = static_cast<T>(std::min(nearest_, 0x1p-10 * depths));
  // brackets cannot be much shorter than the roundings of depths
  rays.eps = static_cast<T>(std::max(eps / per_depth, 32.0 * kSpacing<T> * depths));
  rays.least = static_cast<T>(512.0 * kSpacing<T> * depths);
  rays.pixel = static_cast<T>(length(start_u_ + nearest_ * span_u_) / per_depth);
  rays.pixel_spread = static_cast<T>(length(span_u_) / per_depth);
  rays.columns = std::min(kBlockSide, width_ - bx * kBlockSide);
  rays.rows = std::min(kBlockSide, height_ - by * kBlockSide);
  return rays;
}

template <class T> double BlockFrame::distance(const BlockRays<T>& rays, int x, int y, double depth) {
  const double u = x - 0.5 * (kBlockSide - 1), v = y - 0.5 * (kBlockSide - 1);
  double squared = 0;
  for (int a = 0; a < 3; ++a) {
    const double d = rays.exact[a] + u * rays.exact_u[a] + v * rays.exact_v[a];
    squared += d * d;
  }
  return (rays.depth + depth) * std::sqrt(squared);
}

template <class T>
Box BlockFrame::box_around(const BlockRays<T>& rays, int x, int y, int size, DepthRange<T> part) {
  Box box;
  for (int corner = 0; corner < 8; ++corner) {
    const double u = x - 0.5 * (kBlockSide - 1) + (corner & 1 ? size - 1 : 0),
                 v = y - 0.5 * (kBlockSide - 1) + (corner & 2 ? size - 1 : 0),
                 t = corner & 4 ? part.to : part.from;
    Double3 p;
    for (int a = 0; a < 3; ++a)
      p[a] = rays.start[a] + u * rays.start_u[a] + v * rays.start_v[a] +
             t * (rays.span[a] + u * rays.span_u[a] + v * rays.span_v[a]);
    box.add(p);
  }
  const double longest = std::max(std::abs(double(part.from)), std::abs(double(part.to)));
  for (int a = 0; a < 3; ++a) {
    const double slack = 2 * (rays.slack[a] + longest * rays.spread[a]);
    box.lo[a] -= slack, box.hi[a] += slack;
  }
  return box;
}

template BlockRays<float> BlockFrame::block(int, int, double, double, double) const;
template BlockRays<double> BlockFrame::block(int, int, double, double, double) const;
template double BlockFrame::distance(const BlockRays<float>&, int, int, double);
template double BlockFrame::distance(const BlockRays<double>&, int, int, double);

template Box BlockFrame::box_around(const BlockRays<float>&, int, int, int, DepthRange<float>);
template Box BlockFrame::box_around(const BlockRays<double>&, int, int, int, DepthRange<double>);

}  // namespace isocast
