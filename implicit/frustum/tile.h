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
struct FrustumPart {
  struct Sides {
    std::uint32_t known, negative;
  };
  int x, y, size;
  double w0, w1;
  Sides before, behind;
};

/// T: precision of the roots; C: of the rays' polynomials.
template <class T, class C> class FrustumTile {
 public:
  explicit FrustumTile(const FrustumQuery& query)
      : query_(query), shape_{query.across.degree, query.along.degree} {
    for (int i = 0; i <= shape_.across; ++i)
      for (int x = 0; x < kTile; ++x)
        weights_u_[i][x] = C(query.weights_u[i][x]), weights_v_[i][x] = C(query.weights_v[i][x]);
    if (!query.normals) return;
    for (int i = 0; i <= shape_.across; ++i)
      for (int x = 0; x < kTile; ++x)
        slopes_u_[i][x] = C(query.slopes_u[i][x]), slopes_v_[i][x] = C(query.slopes_v[i][x]);
  }

  /// The roots of a part that is one tile, valid until the next call; null where none of its rays is in it.
  ///
  /// b       its form, each coefficient off by at most `margin`
  /// free    room for a form and a row's sums
  const TileRoots* solve(const FrustumPart& part, const double* b, double margin, double* free,
                         FrustumCounts& counts) {
    const double span = query_.s1 - query_.s0;
    double begin[kTile][kRow], end[kTile][kRow], lengths[kTile][kRow], least = kInfinity<double>,
                                                                       most = -kInfinity<double>;
    for (int y = 0; y < kTile; ++y) {
      clip_row(query_, query_.u0 + part.x * kTile, query_.v0 + part.y * kTile + y + query_.offset_v, begin[y],
               end[y], lengths[y]);
      for (int x = 0; x < kRow; ++x)
        if (begin[y][x] < end[y][x]) least = min(begin[y][x], least), most = max(end[y][x], most);
    }
    double s0 = query_.s0 + part.w0 * span, s1 = query_.s0 + part.w1 * span;
    if (!(least < most) || !(least < s1) || !(s0 < most)) return nullptr;

    // the form as numbers of C, the rows of i side by side
    const int n = shape_.across + 1, d = shape_.along, sheet = (d + 1) * n, row = shape_.row();
    constexpr int kPad = 32;
    const int filled = (sheet + kPad - 1) / kPad * kPad;
    C* const form = reinterpret_cast<C*>(free);
    const double size = largest(b, shape_.size()), scale = sizeof(T) == 4 ? inverse_power_of_two(size) : 1.0;
    for (int j = 0; j < n; ++j) {
      C* at = form + j * filled;
      for (int k = 0; k <= d; ++k)
        for (int i = 0; i < n; ++i) *at++ = C(b[j * shape_.sheet() + k * row + i] * scale);
      for (; at < form + (j + 1) * filled; ++at) *at = C(0);
    }
    margin_ = margin * scale + double(kUnitRoundoff<C>) * (2 * n + 6 * d + 24) * size * scale;
    scale_ = scale;
    for (int i = 0; i < kStreamSize; ++i) roots_.hit[i] = false, roots_.proved[i] = true, roots_.steps[i] = 0;
    for (int y = 0; y < kTile; ++y) {
      C *const sums = form + n * filled, *const slopes = sums + filled;
      sum_rows(form, weights_v_, n, filled, y, sums);
      solve_row(part, sums, n, y, begin[y], end[y], s0, s1, counts);
      for (int x = 0; x < kRow; ++x) roots_.length[slot_of(x, y)] = lengths[y][x];
      if (!query_.normals || !is_hit_in_row(y)) continue;
      sum_rows(form, slopes_v_, n, filled, y, slopes);
      const double v = query_.v0 + part.y * kTile + y + query_.offset_v;
      find_normals({shape_.across, d, sums, slopes}, {query_.u0 + part.x * kTile, v, s0, s1}, y);
    }
    return &roots_;
  }

 private:
  static constexpr int kTile = 16;

  using Weights = C[kMostFormDegree + 1][kTile];

  // The form along one row of pixels, or its slope across.
  static void sum_rows(const C* form, const Weights& weights, int n, int filled, int y, C* sums) {
    using R = Native<C>;
    // side by side, so that no sum waits for itself
    constexpr int kPacks = 32 / kWidth<R>;
    for (int x = 0; x < filled; x += 32) {
      R sum[kPacks];
      for (int p = 0; p < kPacks; ++p) sum[p] = R(weights[0][y]) * load<R>(form + x + p * kWidth<R>);
      for (int j = 1; j < n; ++j) {
        const R weight = R(weights[j][y]);
        for (int p = 0; p < kPacks; ++p)
          sum[p] = sum[p] + weight * load<R>(form + j * filled + x + p * kWidth<R>);
      }
      for (int p = 0; p < kPacks; ++p) store(sums + x + p * kWidth<R>, sum[p]);
    }
  }

  static int slot_of(int x, int y) { return (y / 4 * 4 + x / 4) * 16 + y % 4 * 4 + x % 4; }

  bool is_hit_in_row(int y) const {
    for (int x = 0; x < kRow; ++x)
      if (roots_.hit[slot_of(x, y)]) return true;
    return false;
  }
  void find_normals(const RowForm<C>& form, const RowPlace& place, int y) {
    double s[kRow], normal[2][kRow];
    for (int x = 0; x < kRow; ++x) s[x] = roots_.hit[slot_of(x, y)] ? roots_.s[slot_of(x, y)] : place.s0;
    find_form_normals(query_, form, weights_u_, slopes_u_, place, s, normal[0], normal[1]);
    for (int x = 0; x < kRow; ++x)
      for (int a = 0; a < 2; ++a) roots_.normal[a][slot_of(x, y)] = normal[a][x];
  }

  // The polynomials of a row of rays over the depths that they have in the domain, and their roots.
  void solve_row(const FrustumPart& part, const C* sums, int n, int y, const double* begin, const double* end,
                 double s0, double s1, FrustumCounts& counts) {
    using R = Native<C>;
    const int d = shape_.along;
    bool active[kRow];
    double firsts[kRow], lasts[kRow], from[kRow], length[kRow], eps[kRow];
    C head[kRow], tail[kRow];
    bool any_active = false;
    const Wide per_depth = Wide(1 / (s1 - s0)), zero = Wide(0.0), one = Wide(1.0);
    const double eps_depth = query_.finder.eps * (query_.s1 - query_.s0) / (s1 - s0);
    for (int x = 0; x < kRow; x += kWidth<Wide>) {
      const Wide b = load<Wide>(begin + x), e = load<Wide>(end + x);
      const Wide w0 = (b - Wide(s0)) * per_depth, w1 = (e - Wide(s0)) * per_depth;
      const Mask<Wide> there = (b < e) & (w0 < one) & (w1 > zero);
      // first the end is cut off, then the beginning of what is left
      const Wide last = select(there, min(w1, one), one), first = select(there, max(w0, zero) / last, zero);
      store(firsts + x, first), store(lasts + x, last);
      put_where<Wide>(there, active + x);
      put_where<Wide>(w0 > zero, begins_ + x);
      put_where<Wide>(w1 < one, ends_ + x);
      any_active = any_active || any(there);
    }
    if (!any_active) return;
    bool whole = true;
    for (int x = 0; x < kRow; ++x) {
      head[x] = C(firsts[x]), tail[x] = C(lasts[x]);
      whole = whole && head[x] == C(0) && tail[x] == C(1);
      from[x] = double(head[x]) * double(tail[x]);
      length[x] = (1 - double(head[x])) * double(tail[x]);
      eps[x] = min(eps_depth / length[x], 0.5);
      active[x] = active[x] && length[x] > 0;
    }
    C c[kMostFormDegree + 1][kRow];
    constexpr int kPacks = kRow / kWidth<R>;
    // two depths at once, so that no sum waits for itself
    for (int k = 0; k <= d; k += 2) {
      const int other = k < d ? k + 1 : k;
      R sum[kPacks], next[kPacks];
      for (int p = 0; p < kPacks; ++p) {
        const R weight = load<R>(weights_u_[0] + p * kWidth<R>);
        sum[p] = weight * R(sums[k * n]), next[p] = weight * R(sums[other * n]);
      }
      for (int i = 1; i < n; ++i) {
        const R here = R(sums[k * n + i]), there = R(sums[other * n + i]);
        for (int p = 0; p < kPacks; ++p) {
          const R weight = load<R>(weights_u_[i] + p * kWidth<R>);
          sum[p] = sum[p] + weight * here, next[p] = next[p] + weight * there;
        }
      }
      for (int p = 0; p < kPacks; ++p)
        store(c[k] + p * kWidth<R>, sum[p]), store(c[other] + p * kWidth<R>, next[p]);
    }
    for (int first = 0; first < kRow && !whole; first += kWidth<R>) {
      Bezier<R> p;
      p.degree = d;
      for (int k = 0; k <= d; ++k) p.c[k] = load<R>(c[k] + first);
      p.keep_left(load<R>(tail + first));
      p.keep_right(load<R>(head + first));
      for (int k = 0; k <= d; ++k) store(c[k] + first, p.c[k]);
    }
    for (int iso = 0; iso < query_.iso_count; ++iso)
      solve_iso(part, iso, c, active, eps, y, from, length, s0, s1, counts);
  }

  template <class S>
  void fill(RowPolynomials<S>& row, const FrustumPart& part, int iso, const C (&c)[kMostFormDegree + 1][kRow],
            const bool* active, const double* eps) const {
    row.degree = shape_.along;
    const S margin = S((margin_ + double(kUnitRoundoff<C>) * 2 * abs(query_.iso[iso] * scale_)) * 1.0001);
    row.proves = query_.check_points != nullptr;
    const C level = C(query_.iso[iso] * scale_);
    for (int k = 0; k <= row.degree; ++k)
      for (int x = 0; x < kRow; ++x) row.c[k][x] = S(c[k][x] - level);
    const auto sign = [iso](const FrustumPart::Sides& sides, bool applies) -> signed char {
      if (!applies || !(sides.known >> iso & 1)) return 0;
      return sides.negative >> iso & 1 ? -1 : 1;
    };
    for (int x = 0; x < kRow; ++x) {
      row.active[x] = active[x];
      row.margin[x] = margin;
      row.eps[x] = S(eps[x]);
      row.before[x] = sign(part.before, !begins_[x]);
      row.behind[x] = sign(part.behind, !ends_[x]);
    }
  }

  void solve_iso(const FrustumPart& part, int iso, const C (&c)[kMostFormDegree + 1][kRow],
                 const bool* active, const double* eps, int y, const double* from, const double* length,
                 double s0, double s1, FrustumCounts& counts) {
    TileRoots& roots = roots_;
    RowPolynomials<T> row;
    fill(row, part, iso, c, active, eps);
    RowRoots found;
    find_row<Native<T>>(row, query_.finder, active, found);
    if constexpr (sizeof(T) < sizeof(C)) {
      bool open[kRow], any_open = false;
      for (int x = 0; x < kRow; ++x) any_open = (open[x] = active[x] && !found.proved[x]) || any_open;
      if (query_.redo && any_open) {
        RowPolynomials<C> precise;
        fill(precise, part, iso, c, active, eps);
        precise.guessed = true;
        find_row<Native<C>>(precise, query_.finder, open, found);
      }
    }
    for (int x = 0; x < kRow; ++x) {
      if (!active[x]) continue;
      const int slot = slot_of(x, y);
      ++counts.solves;
      roots.steps[slot] += found.steps[x];
      const auto depth = [&](double s) { return s0 + (s1 - s0) * (from[x] + s * length[x]); };
      if (!found.hit[x]) {
        roots.proved[slot] = roots.proved[slot] && found.proved[x];
        continue;
      }
      const double s = depth(found.s[x]);
      const bool nearer = !roots.hit[slot] || s < roots.s[slot];
      // brackets of two iso-values that touch prove nothing of the first
      const bool apart =
          !roots.hit[slot] || depth(found.hi[x]) < roots.lo[slot] || depth(found.lo[x]) > roots.hi[slot];
      roots.proved[slot] = roots.proved[slot] && found.proved[x] && apart;
      if (!nearer) continue;
      roots.hit[slot] = true;
      roots.s[slot] = s;
      const double slack = 0x1p-49 * (abs(s0) + abs(s1));
      roots.lo[slot] = depth(found.lo[x]) - slack;
      roots.hi[slot] = depth(found.hi[x]) + slack;
      roots.iso[slot] = std::uint8_t(iso);
      std::uint32_t sides = std::uint32_t(found.negative[x]) << iso;
      for (int other = 0; other < query_.iso_count; ++other)
        if (other != iso) sides |= std::uint32_t(query_.iso[iso] < query_.iso[other]) << other;
      roots.sides[slot] = sides;
    }
  }

  const FrustumQuery& query_;
  const PatchShape shape_;
  double margin_ = 0, scale_ = 1;  // of the coefficients of rays
  Weights weights_u_, weights_v_, slopes_u_, slopes_v_;
  bool begins_[kRow], ends_[kRow];
  TileRoots roots_;
};

}  // namespace isocast::inline ISO_ISA
