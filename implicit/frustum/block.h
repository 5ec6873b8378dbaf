// A block of the picture: the form of f over it is divided among its tiles as far as it may vanish there.
#pragma once

#include <isocast/implicit/frustum/patch.h>
#include <isocast/implicit/frustum/tile.h>

namespace isocast::inline ISO_ISA {

/// T: precision of the roots; C: of the rays' polynomials.
template <class T, class C> class FrustumBlock {
 public:
  using Found = void(void* context, int x, int y, const TileRoots& roots);

  /// scratch  doubles, as many as frustum_scratch says
  FrustumBlock(const FrustumQuery& query, double* scratch, void* registers, FrustumCounts& counts,
               void* context, Found* found)
      : query_(query),
        shape_{query.across.degree, query.along.degree},
        scratch_(scratch),
        registers_(registers),
        counts_(counts),
        context_(context),
        found_(found),
        tile_(query) {}

  void solve() {
    double* const b = scratch_;
    double* const free = b + shape_.size();
    interpolate(query_, b, free, registers_);
    counts_.evaluations += (shape_.across + 1) * (shape_.across + 1) * (shape_.along + 1);
    const double size = largest(b, shape_.size());
    if (!(size < kInfinity<double>)) margin_ = kInfinity<double>;
    else {
      // halving and trimming round as well
      margin_ = 0x1p-53 * 64 * (shape_.across + shape_.along + 8) * size;
      if (query_.check_points) {
        margin_ += form_error(query_, b, free, registers_) + query_.slack;
        counts_.evaluations += (query_.degree + 1) * (query_.degree + 1) * (query_.degree + 1);
      }
    }
    visit({0, 0, query_.tiles, 0, 1, {}, {}}, b, free);
  }

 private:
  void visit(FrustumPart part, double* b, double* free) {
    if (!trim(part, b)) return;
    if (part.size == 1) {
      const TileRoots* const roots = tile_.solve(part, b, margin_, free, counts_);
      if (roots) found_(context_, part.x, part.y, *roots);
      return;
    }
    const int half = part.size / 2, n = shape_.across + 1, size = shape_.size();
    double *const strip = free, *const child = free + size, *const rest = free + 2 * size;
    for (int v = 0; v < 2; ++v) {
      combine(strip, b, query_.across.halves[v], n, n, shape_.sheet());
      for (int u = 0; u < 2; ++u) {
        combine_in_rows(child, shape_.row(), strip, shape_.row(), query_.across.halves[u], n, n,
                        n * (shape_.along + 1));
        FrustumPart quarter = part;
        quarter.size = half;
        quarter.x += u * half, quarter.y += v * half;
        visit(quarter, child, rest);
      }
    }
  }

  // Least and largest coefficient of every depth.
  void find_hull(const double* b, double* lo, double* hi) const {
    constexpr int kLanes = kWidth<Wide>;
    const int row = shape_.row(), n = shape_.across + 1;
    double place[kLanes];
    for (int l = 0; l < kLanes; ++l) place[l] = l;
    for (int k = 0; k <= shape_.along; ++k) {
      Wide least = Wide(kInfinity<double>), most = Wide(-kInfinity<double>);
      for (int x = 0; x < n; x += kLanes) {
        const Mask<Wide> there = load<Wide>(place) < Wide(n - x);  // not what fills up the row
        for (int j = 0; j < n; ++j) {
          const Wide c = load<Wide>(b + j * shape_.sheet() + k * row + x);
          least = select(there, min(c, least), least), most = select(there, max(c, most), most);
        }
      }
      double ends[2][kLanes];
      store(ends[0], least), store(ends[1], most);
      lo[k] = ends[0][0], hi[k] = ends[1][0];
      for (int l = 1; l < kLanes; ++l) lo[k] = min(ends[0][l], lo[k]), hi[k] = max(ends[1][l], hi[k]);
    }
  }

  // Cuts off what the hull of the coefficients shows to be empty at both ends; false where that is all.
  bool trim(FrustumPart& part, double* b) {
    double lo[kMostFormDegree + 1], hi[kMostFormDegree + 1];
    const int d = shape_.along;
    for (int round = 0; round < 3; ++round) {
      find_hull(b, lo, hi);
      double first = 1, last = 0;
      FrustumPart::Sides front{}, back{};
      for (int i = 0; i < query_.iso_count; ++i) {
        const auto distance = [&](int k, bool above) {
          return (above ? lo[k] - query_.iso[i] : query_.iso[i] - hi[k]) - margin_;
        };
        // where the hull from one end on reaches zero: 2: never
        const auto reach = [&](int from, int step, bool above) {
          double s = 2, f[kMostFormDegree + 1] = {};
          for (int n = 0; n <= d; ++n) f[n] = distance(from + n * step, above);
          if (!(f[0] > 0)) return 0.0;
          for (int n = 1; n <= d; ++n) {
            if (f[n] > 0) continue;
            for (int m = 0; m < n; ++m)
              if (f[m] > 0) s = min((m + (n - m) * (f[m] / (f[m] - f[n]))) / d, s);
          }
          return s;
        };
        const bool above_front = distance(0, true) > 0, above_back = distance(d, true) > 0;
        const double near = reach(0, 1, above_front), far = 1 - reach(d, -1, above_back);
        const std::uint32_t bit = 1u << i;
        if (near > 0) front.known |= bit, front.negative |= above_front ? 0 : bit;
        if (far < 1) back.known |= bit, back.negative |= above_back ? 0 : bit;
        if (near > 1) continue;
        first = min(near, first), last = max(far, last);
      }
      if (first > last) return false;
      // room for the roundings of the hull
      first = max(first - 0x1p-40, 0.0), last = min(last + 0x1p-40, 1.0);
      if (!(last - first < 0.75)) return true;
      cut(b, first, last);
      const double length = part.w1 - part.w0;
      if (last < 1) part.behind = back, part.w1 = part.w0 + last * length;
      if (first > 0) part.before = front, part.w0 = part.w0 + first * length;
    }
    return true;
  }

  // De Casteljau's algorithm along the depth, for a row of u at a time.
  void cut(double* b, double first, double last) const {
    const int row = shape_.row(), d = shape_.along;
    const Wide s = Wide(last), before_s = Wide(1 - last), t = Wide(first / last),
               before_t = Wide(1 - first / last);
    for (int j = 0; j <= shape_.across; ++j)
      for (int x = 0; x < row; x += kWidth<Wide>) {
        double* const at = b + j * shape_.sheet() + x;
        Wide c[kMostFormDegree + 1];
        for (int k = 0; k <= d; ++k) c[k] = load<Wide>(at + k * row);
        if (last < 1)
          for (int r = 1; r <= d; ++r)
            for (int k = d; k >= r; --k) c[k] = before_s * c[k - 1] + s * c[k];
        if (first > 0)
          for (int r = 1; r <= d; ++r)
            for (int k = 0; k <= d - r; ++k) c[k] = before_t * c[k] + t * c[k + 1];
        for (int k = 0; k <= d; ++k) store(at + k * row, c[k]);
      }
  }

  const FrustumQuery& query_;
  const PatchShape shape_;
  double* const scratch_;
  void* const registers_;
  FrustumCounts& counts_;
  void* const context_;
  Found* const found_;
  double margin_ = 0;
  FrustumTile<T, C> tile_;
};

}  // namespace isocast::inline ISO_ISA
