// A tile of the picture: its part of the block's form becomes the polynomials of its rays, row by row, and
// their first roots.
#pragma once

#include <isocast/implicit/frustum/form_normals.h>
#include <isocast/implicit/frustum/row_depths.h>
#include <isocast/implicit/frustum/row_roots.h>

namespace isocast::inline ISO_ISA {

/// A part of the block: `size` x `size` tiles from (x, y), depths w0 to w1 as shares of the block's.
///
/// before, behind  bit i of known: no ray of the part meets iso-value i before w0 (behind w1), and bit i of
///                 negative: f < iso i there
/// shape, margin   of its form, and what its coefficients are off by at most
struct FrustumPart {
  struct Sides {
    std::uint32_t known, negative;
  };
  int x, y, size;
  double w0, w1;
  Sides before, behind;
  PatchShape shape;
  double margin;
};

/// T: precision of the roots; C: of the rays' polynomials.
template <class T, class C> class FrustumTile {
 public:
  explicit FrustumTile(const FrustumQuery& query) : query_(query) {
    for (int i = 0; i <= query.along.degree; ++i)
      for (int x = 0; x < kTile; ++x)
        weights_u_[i][x] = C(query.weights_u[i][x]), weights_v_[i][x] = C(query.weights_v[i][x]);
    if (!query.normals) return;
    for (int i = 0; i <= query.along.degree; ++i)
      for (int x = 0; x < kTile; ++x)
        slopes_u_[i][x] = C(query.slopes_u[i][x]), slopes_v_[i][x] = C(query.slopes_v[i][x]);
  }

  /// The roots of a part that is one tile, valid until the next call; null where none of its rays is in it.
  ///
  /// b       its form
  /// free    room for another
  const TileRoots* solve(const FrustumPart& part, const double* b, double* free, FrustumCounts& counts) {
    const double span = query_.s1 - query_.s0;
    double begin[kTile][kRow], end[kTile][kRow], least = kInfinity<double>, most = -kInfinity<double>;
    for (int y = 0; y < kTile; ++y) {
      clip_row(query_, query_.u0 + part.x * kTile, query_.v0 + part.y * kTile + y + query_.offset_v, begin[y],
               end[y], roots_.length[y]);
      for (int x = 0; x < kRow; ++x)
        if (begin[y][x] < end[y][x]) least = min(begin[y][x], least), most = max(end[y][x], most);
    }
    double s0 = query_.s0 + part.w0 * span, s1 = query_.s0 + part.w1 * span;
    if (!(least < most) || !(least < s1) || !(s0 < most)) return nullptr;

    // the form as numbers of C
    const PatchShape& shape = part.shape;
    const int n = shape.across + 1, d = shape.along;
    C* const form = reinterpret_cast<C*>(free);
    const double size = largest(b, shape), scale = sizeof(T) == 4 ? inverse_power_of_two(size) : 1.0;
    for (int p = 0; p < shape.pairs(); ++p)
      for (int k = 0; k < filled_depths<C>(d); ++k)
        form[p * filled_depths<C>(d) + k] = k <= d ? C(b[p * shape.row() + k] * scale) : C(0);
    margin_ = part.margin * scale + double(kUnitRoundoff<C>) * (2 * n + 6 * d + 24) * size * scale;
    scale_ = scale;
    for (int y = 0; y < kTile; ++y) roots_.hit[y] = 0, roots_.proved[y] = kAllRays;
    __builtin_memset(roots_.steps, 0, sizeof roots_.steps);
    for (int first = 0; first < kTile; first += kRowsAtOnce) {
      bool any_hit = false;
      sum_rows(form, shape, weights_v_, first, sums_);
      for (int y = first; y < first + kRowsAtOnce; ++y) {
        solve_row(part, sums_[y - first], y, begin[y], end[y], s0, s1, counts);
        any_hit = any_hit || roots_.hit[y] != 0;
      }
      if (!query_.normals || !any_hit) continue;
      sum_rows(form, shape, slopes_v_, first, slopes_);
      for (int y = first; y < first + kRowsAtOnce; ++y) {
        const double v = query_.v0 + part.y * kTile + y + query_.offset_v;
        if (roots_.hit[y] != 0)
          find_normals({shape.across, d, sums_[y - first], slopes_[y - first]},
                       {query_.u0 + part.x * kTile, v, s0, s1}, y);
      }
    }
    return &roots_;
  }

 private:
  static constexpr int kTile = 16, kRowsAtOnce = 4;
  static constexpr unsigned kAllRays = (1u << kTile) - 1;
  static constexpr int kMostSums = (kMostFormDegree + 1) * filled_depths<C>(kMostFormDegree);

  using Weights = C[kMostFormDegree + 1][kTile];

  // The form along rows of pixels from y on, or its slopes across: row by row of u's degrees.
  static void sum_rows(const C* form, const PatchShape& shape, const Weights& weights, int y,
                       C (*sums)[kMostSums]) {
    using R = Native<C>;
    const int n = shape.across + 1, row = filled_depths<C>(shape.along);
    for (int i = 0; i < n; ++i)
      for (int x = 0; x < row; x += kWidth<R>) {
        const C* at = form + i * row + x;
        R c = load<R>(at), sum[kRowsAtOnce];
        for (int r = 0; r < kRowsAtOnce; ++r) sum[r] = R(weights[0][y + r]) * c;
        for (int j = 1; j < n - i; ++j) {
          at += (n - j + 1) * row;
          c = load<R>(at);
          for (int r = 0; r < kRowsAtOnce; ++r) sum[r] = sum[r] + R(weights[j][y + r]) * c;
        }
        for (int r = 0; r < kRowsAtOnce; ++r) store(sums[r] + i * row + x, sum[r]);
      }
  }

  void find_normals(const RowForm<C>& form, const RowPlace& place, int y) {
    double s[kRow];
    for (int x = 0; x < kRow; ++x) s[x] = roots_.hit[y] >> x & 1 ? roots_.s[y][x] : place.s0;
    find_form_normals(query_, form, weights_u_, slopes_u_, place, s, roots_.normal[0][y],
                      roots_.normal[1][y]);
  }

  // What the rays of a row have of a part: bit by ray `active`, those that are in it, and whether their own
  // depths begin or end in it; from, length: of its depths, as shares.
  struct RowShare {
    unsigned active = 0, begins = 0, ends = 0;
    double s0, s1, from[kRow], length[kRow], eps[kRow];
  };

  // The polynomials of a row of rays over the depths that they have in the domain, and their roots.
  void solve_row(const FrustumPart& part, const C* sums, int y, const double* begin, const double* end,
                 double s0, double s1, FrustumCounts& counts) {
    using R = Native<C>;
    const int n = part.shape.across + 1, d = part.shape.along, row = filled_depths<C>(d);
    RowShare share;
    share.s0 = s0, share.s1 = s1;
    double firsts[kRow], lasts[kRow];
    C head[kRow], tail[kRow];
    const Wide per_depth = Wide(1 / (s1 - s0)), zero = Wide(0.0), one = Wide(1.0);
    const double eps_depth = query_.finder.eps * (query_.s1 - query_.s0) / (s1 - s0);
    unsigned cut_left = 0, cut_right = 0;
    for (int x = 0; x < kRow; x += kWidth<Wide>) {
      const Wide b = load<Wide>(begin + x), e = load<Wide>(end + x);
      const Wide w0 = (b - Wide(s0)) * per_depth, w1 = (e - Wide(s0)) * per_depth;
      const Mask<Wide> there = (b < e) & (w0 < one) & (w1 > zero);
      // first the end is cut off, then the beginning of what is left
      const Wide last = select(there, min(w1, one), one), first = select(there, max(w0, zero) / last, zero);
      store(firsts + x, first), store(lasts + x, last);
      share.active |= bits_of(there) << x;
      share.begins |= bits_of(w0 > zero) << x, share.ends |= bits_of(w1 < one) << x;
      cut_left |= bits_of(first > zero), cut_right |= bits_of(last < one);
    }
    if (share.active == 0) return;
    for (int x = 0; x < kRow; ++x) {
      head[x] = C(firsts[x]), tail[x] = C(lasts[x]);
      share.from[x] = double(head[x]) * double(tail[x]);
      share.length[x] = (1 - double(head[x])) * double(tail[x]);
      share.eps[x] = min(eps_depth / share.length[x], 0.5);
      share.active &= ~(unsigned(!(share.length[x] > 0)) << x);
    }
    C c[kMostFormDegree + 1][kRow];
    constexpr int kPacks = kRow / kWidth<R>;
    // two depths at once, so that no sum waits for itself
    for (int k = 0; k <= d; k += 2) {
      const int other = k < d ? k + 1 : k;
      R sum[kPacks], next[kPacks];
      for (int p = 0; p < kPacks; ++p) {
        const R weight = load<R>(weights_u_[0] + p * kWidth<R>);
        sum[p] = weight * R(sums[k]), next[p] = weight * R(sums[other]);
      }
      for (int i = 1; i < n; ++i) {
        const R here = R(sums[i * row + k]), there = R(sums[i * row + other]);
        for (int p = 0; p < kPacks; ++p) {
          const R weight = load<R>(weights_u_[i] + p * kWidth<R>);
          sum[p] = sum[p] + weight * here, next[p] = next[p] + weight * there;
        }
      }
      for (int p = 0; p < kPacks; ++p)
        store(c[k] + p * kWidth<R>, sum[p]), store(c[other] + p * kWidth<R>, next[p]);
    }
    for (int first = 0; first < kRow && (cut_left | cut_right) != 0; first += kWidth<R>) {
      Bezier<R> p;
      p.degree = d;
      for (int k = 0; k <= d; ++k) p.c[k] = load<R>(c[k] + first);
      if (cut_right != 0) p.keep_left(load<R>(tail + first));
      if (cut_left != 0) p.keep_right(load<R>(head + first));
      for (int k = 0; k <= d; ++k) store(c[k] + first, p.c[k]);
    }
    for (int iso = 0; iso < query_.iso_count; ++iso) solve_iso(part, iso, c, share, y, counts);
  }

  template <class S>
  void fill(RowPolynomials<S>& row, const FrustumPart& part, int iso, const C (&c)[kMostFormDegree + 1][kRow],
            const RowShare& share) const {
    row.degree = part.shape.along;
    const S margin = S((margin_ + double(kUnitRoundoff<C>) * 2 * abs(query_.iso[iso] * scale_)) * 1.0001);
    row.proves = query_.proves;
    const C level = C(query_.iso[iso] * scale_);
    for (int k = 0; k <= row.degree; ++k)
      for (int x = 0; x < kRow; ++x) row.c[k][x] = S(c[k][x] - level);
    for (int x = 0; x < kRow; ++x) row.margin[x] = margin, row.eps[x] = S(share.eps[x]);
    const auto sides = [iso](const FrustumPart::Sides& of_part, unsigned elsewhere) -> RowSides {
      return {of_part.known >> iso & 1 ? ~elsewhere : 0, of_part.negative >> iso & 1 ? kAllRays : 0};
    };
    row.before = sides(part.before, share.begins);
    row.behind = sides(part.behind, share.ends);
  }

  void solve_iso(const FrustumPart& part, int iso, const C (&c)[kMostFormDegree + 1][kRow],
                 const RowShare& share, int y, FrustumCounts& counts) {
    RowPolynomials<T> row;
    fill(row, part, iso, c, share);
    RowRoots found;
    find_row<Native<T>>(row, query_.finder, share.active, found);
    if constexpr (sizeof(T) < sizeof(C)) {
      const unsigned open = share.active & ~found.proved;
      if (query_.redo && open != 0) {
        RowPolynomials<C> precise;
        fill(precise, part, iso, c, share);
        precise.guessed = true;
        find_row<Native<C>>(precise, query_.finder, open, found);
      }
    }
    counts.solves += __builtin_popcount(share.active);
    take(iso, share, found, y);
  }

  // The nearer of these roots and of those of other iso-values.
  void take(int iso, const RowShare& share, const RowRoots& found, int y) {
    const double s0 = share.s0, s1 = share.s1;
    const unsigned hits = share.active & found.hit;
    unsigned nearer = 0, apart = 0;
    for (int x = 0; x < kRow; x += kWidth<Wide>) {
      const auto depth = [&](const double* s) {
        return Wide(s0) + Wide(s1 - s0) *
                              (load<Wide>(share.from + x) + load<Wide>(s + x) * load<Wide>(share.length + x));
      };
      double *const s = roots_.s[y] + x, *const lo = roots_.lo[y] + x, *const hi = roots_.hi[y] + x;
      const Mask<Wide> held = lanes_of<Wide>(roots_.hit[y] >> x);
      const Wide at = depth(found.s), from = depth(found.lo), to = depth(found.hi),
                 slack = Wide(0x1p-49 * (abs(s0) + abs(s1)));
      const Mask<Wide> first = lanes_of<Wide>(hits >> x) & ((!held) | (at < load<Wide>(s)));
      nearer |= bits_of(first) << x;
      // brackets of two iso-values that touch prove nothing of the first
      apart |= bits_of((!held) | (to < load<Wide>(lo)) | (from > load<Wide>(hi))) << x;
      store(s, select(first, at, load<Wide>(s)));
      store(lo, select(first, from - slack, load<Wide>(lo)));
      store(hi, select(first, to + slack, load<Wide>(hi)));
    }
    roots_.hit[y] |= nearer;
    roots_.proved[y] &= ~share.active | (found.proved & (~hits | apart));
    std::uint32_t lower = 0;
    for (int other = 0; other < query_.iso_count; ++other)
      lower |= std::uint32_t(query_.iso[iso] < query_.iso[other]) << other;
    for (int x = 0; x < kRow; ++x) {
      const bool first = nearer >> x & 1;
      roots_.steps[y][x] += found.steps[x];
      roots_.iso[y][x] = first ? std::uint8_t(iso) : roots_.iso[y][x];
      roots_.sides[y][x] = first ? lower | (found.negative >> x & 1) << iso : roots_.sides[y][x];
    }
  }

  const FrustumQuery& query_;
  double margin_ = 0, scale_ = 1;  // of the coefficients of rays
  Weights weights_u_, weights_v_, slopes_u_, slopes_v_;
  TileRoots roots_;
  alignas(64) C sums_[kRowsAtOnce][kMostSums], slopes_[kRowsAtOnce][kMostSums];
};

}  // namespace isocast::inline ISO_ISA
