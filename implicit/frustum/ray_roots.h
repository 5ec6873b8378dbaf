// The polynomial of a ray from d + 1 values along it, and its first root.
#pragma once

#include <isocast/implicit/frustum/ray_query.h>
#include <isocast/implicit/frustum/row_roots.h>
#include <isocast/implicit/solve/inclusion.h>

namespace isocast::inline ISO_ISA {

/// kRow rays, kept while their iso-values are asked for one by one.
template <class T> class RayForms {
 public:
  RayForms(const RayFormQuery& query, const RayFormStream& rays, RayFormRoots& roots, void* registers)
      : query_(query), rays_(rays), roots_(roots), registers_(static_cast<Interval<Wide>*>(registers)) {}

  void solve(int first) {
    first_ = first;
    bool any_active = false;
    for (int x = 0; x < kRow; ++x) {
      active_[x] = first + x < rays_.size && rays_.active[first + x];
      any_active = any_active || active_[x];
    }
    if (!any_active) return;
    find_coefficients();
    for (int x = 0; x < kRow; ++x) {
      if (!active_[x]) continue;
      const int i = first + x;
      roots_.hit[i] = false;
      roots_.proved[i] = query_.exact;
      roots_.steps[i] = 0;
      roots_.sides_at_far[i] = 0;
    }
    for (int iso = 0; iso < query_.iso_count; ++iso) solve_iso(iso);
  }

 private:
  static constexpr int kPoints = kMostFormDegree + 1;
  static constexpr int kPacks = 4;

  // Bernstein coefficients of the rays, and how far f may be from them.
  void find_coefficients() {
    const int n = query_.table.degree + 1;
    for (int lane = 0; lane < kRow; lane += kWidth<Wide>) {
      const int at = first_ + lane;
      Wide values[kPoints], radius[kPoints];
      const Wide near = load<Wide>(rays_.near + at), length = load<Wide>(rays_.far + at) - near;
      Interval<Wide> inputs[4 * kPacks];
      for (int from = 0; from < n; from += kPacks) {
        const int count = n - from < kPacks ? n - from : kPacks;
        for (int i = 0; i < count; ++i) {
          const Wide t = near + Wide(query_.table.points[from + i]) * length;
          for (int a = 0; a < 3; ++a) {
            const Wide o = load<Wide>(rays_.o[a] + at), d = load<Wide>(rays_.d[a] + at), p = o + t * d;
            const Wide slack = Wide(query_.slack) * (abs(o) + abs(t * d));
            inputs[a * kPacks + i] = Interval<Wide>(p - slack, p + slack);
          }
          inputs[3 * kPacks + i] = constant_as({query_.time, true}, Interval<Wide>{});
        }
        const Interval<Wide>* const f =
            evaluate_some<kPacks>(query_.tape, static_cast<const Interval<Wide>*>(inputs), registers_, count);
        for (int i = 0; i < count; ++i) {
          values[from + i] = Wide(0.5) * (f[i].lo + f[i].hi);
          radius[from + i] = f[i].hi - f[i].lo;
        }
      }
      Wide c[kPoints], size = Wide(0);
      for (int k = 0; k < n; ++k) {
        Wide sum = Wide(query_.table.from_values[k * n]) * values[0];
        for (int i = 1; i < n; ++i) sum = sum + Wide(query_.table.from_values[k * n + i]) * values[i];
        c[k] = sum;
        size = max(size, abs(sum));
        store(c_[k] + lane, sum);
      }
      // what the polynomial misses of f at the points, times what that can mean between them
      Wide off = Wide(0);
      for (int i = 0; i < n; ++i) {
        Wide sum = Wide(query_.table.at_points[i * n]) * c[0];
        for (int k = 1; k < n; ++k) sum = sum + Wide(query_.table.at_points[i * n + k]) * c[k];
        const Wide here = abs(sum - values[i]) + radius[i];
        off = select(here < Wide(kInfinity<double>), max(here, off), Wide(kInfinity<double>));
      }
      off = (off + Wide(0x1p-52 * (n + 4)) * size) * Wide(1.001 * query_.table.lebesgue);
      store(off_ + lane, off);
      store(size_ + lane, size);
    }
  }

  void solve_iso(int iso) {
    RowPolynomials<T> row;
    row.degree = query_.table.degree;
    row.proves = query_.exact;
    double scale[kRow];
    unsigned active = 0;
    for (int x = 0; x < kRow; ++x) {
      scale[x] = sizeof(T) == 4 ? inverse_power_of_two(size_[x] + abs(query_.iso[iso])) : 1.0;
      if (!active_[x]) scale[x] = 0;
      const int i = first_ + x;
      row.margin[x] = active_[x] ? T(1.0001 * scale[x] * off_[x]) : T(0);
      row.eps[x] = T(query_.finder.eps);
      if (!active_[x]) continue;
      active |= 1u << x;
      row.before.known |= unsigned(rays_.carried[i]) << x;
      row.before.negative |= (rays_.sides[i] >> iso & 1) << x;
    }
    for (int k = 0; k <= row.degree; ++k)
      for (int x = 0; x < kRow; ++x)
        row.c[k][x] = active_[x] ? T((c_[k][x] - query_.iso[iso]) * scale[x]) : T(1);
    RowRoots found;
    find_row<Native<T>>(row, query_.finder, active, found);
    for (int x = 0; x < kRow; ++x) {
      if (!active_[x]) continue;
      const int i = first_ + x;
      const double near = rays_.near[i], length = rays_.far[i] - near;
      const bool proved = found.proved >> x & 1;
      const auto t_at = [&](double s) { return near + s * length; };
      roots_.steps[i] += found.steps[x];
      roots_.sides_at_far[i] |= std::uint32_t(negative(row.c[row.degree][x])) << iso;
      if ((found.hit >> x & 1) == 0) {
        roots_.proved[i] = roots_.proved[i] && proved;
        continue;
      }
      const double t = t_at(found.s[x]);
      const bool apart =
          !roots_.hit[i] || t_at(found.hi[x]) < roots_.lo[i] || t_at(found.lo[x]) > roots_.hi[i];
      roots_.proved[i] = roots_.proved[i] && proved && apart;
      if (roots_.hit[i] && !(t < roots_.t[i])) continue;
      const double slack = 0x1p-50 * (abs(near) + abs(rays_.far[i]));
      roots_.hit[i] = true;
      roots_.t[i] = t;
      roots_.lo[i] = t_at(found.lo[x]) - slack;
      roots_.hi[i] = t_at(found.hi[x]) + slack;
      roots_.iso[i] = std::uint8_t(iso);
      std::uint32_t sides = (found.negative >> x & 1) << iso;
      for (int other = 0; other < query_.iso_count; ++other)
        if (other != iso) sides |= std::uint32_t(query_.iso[iso] < query_.iso[other]) << other;
      roots_.sides[i] = sides;
    }
  }

  const RayFormQuery& query_;
  const RayFormStream& rays_;
  RayFormRoots& roots_;
  Interval<Wide>* const registers_;
  int first_ = 0;
  bool active_[kRow];
  double c_[kPoints][kRow], off_[kRow], size_[kRow];
};

/// Rays first ... first + kRow - 1 of a stream; `registers` has room for four of Interval<Wide> a register.
/// source  the polynomial of a ray from its values: design.md's fallback for rays that have no frustum
inline void solve_row_of_forms(const RayFormQuery& query, const RayFormStream& rays, RayFormRoots& roots,
                               int first, void* registers) {
  if (query.single) RayForms<float>(query, rays, roots, registers).solve(first);
  else RayForms<double>(query, rays, roots, registers).solve(first);
}
inline void solve_ray_forms(const RayFormQuery& query, const RayFormStream& rays, RayFormRoots& roots,
                            void* registers) {
  for (int first = 0; first < rays.size; first += kRow)
    solve_row_of_forms(query, rays, roots, first, registers);
}

}  // namespace isocast::inline ISO_ISA
