// A block of the picture: the form of f over it is divided among its tiles as far as it may vanish there,
// with degrees across that fall as the parts get smaller.
#pragma once

#include <isocast/implicit/frustum/interpolate.h>
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
        scratch_(scratch),
        registers_(registers),
        counts_(counts),
        context_(context),
        found_(found),
        tile_(query) {}

  void solve() {
    const int d = query_.along.degree;
    double* const free = scratch_ + PatchShape{d, d}.size();
    const BlockForm form = interpolate(query_, double(kUnitRoundoff<T>), scratch_, free, registers_);
    counts_.evaluations += points_across(d) * (d + 1);
    negligible_ = form.negligible;
    visit({0, 0, query_.tiles, 0, 1, {}, {}, form.shape, form.margin}, scratch_, free);
  }

 private:
  void visit(FrustumPart part, double* b, double* free) {
    if (!trim(part, b)) return;
    if (part.size == 1) {
      const TileRoots* const roots = tile_.solve(part, b, free, counts_);
      if (roots) found_(context_, part.x, part.y, *roots);
      return;
    }
    const int half = part.size / 2, size = part.shape.size();
    double *const strip = free, *const child = free + size, *const rest = free + 2 * size;
    for (int v = 0; v < 2; ++v) {
      halve<1>(strip, b, part.shape, query_.across.halves[v]);
      for (int u = 0; u < 2; ++u) {
        halve<0>(child, strip, part.shape, query_.across.halves[u]);
        FrustumPart quarter = part;
        quarter.size = half;
        quarter.x += u * half, quarter.y += v * half;
        quarter.margin += drop_degrees(child, quarter.shape, negligible_);
        visit(quarter, child, rest);
      }
    }
  }

  // Cuts off what the hull of the coefficients shows to be empty at both ends; false where that is all.
  bool trim(FrustumPart& part, double* b) {
    double lo[kMostDepths], hi[kMostDepths];
    const int d = part.shape.along;
    for (int round = 0; round < kMostCuts; ++round) {
      find_hull(b, part.shape, lo, hi);
      double first = 1, last = 0;
      FrustumPart::Sides front{}, back{};
      for (int i = 0; i < query_.iso_count; ++i) {
        const auto distance = [&](int k, bool above) {
          return (above ? lo[k] - query_.iso[i] : query_.iso[i] - hi[k]) - part.margin;
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
      cut(b, part.shape, first, last);
      const double length = part.w1 - part.w0;
      if (last < 1) part.behind = back, part.w1 = part.w0 + last * length;
      if (first > 0) part.before = front, part.w0 = part.w0 + first * length;
    }
    return true;
  }

  const FrustumQuery& query_;
  double* const scratch_;
  void* const registers_;
  FrustumCounts& counts_;
  void* const context_;
  Found* const found_;
  double negligible_ = 0;
  FrustumTile<T, C> tile_;
};

}  // namespace isocast::inline ISO_ISA
