// Normals at the roots of a row of pixels, from the form of f instead of f.
#pragma once

#include <isocast/implicit/frustum/bezier.h>
#include <isocast/implicit/frustum/block_query.h>
#include <isocast/implicit/frustum/patch.h>
#include <isocast/math/rounding.h>

namespace isocast::inline ISO_ISA {

/// Numbers of C that a row of depths is filled up to.
template <class C> constexpr int filled_depths(int along) {
  constexpr int kRegister = 64 / int(sizeof(C));
  return (along + kRegister) / kRegister * kRegister;
}

/// g(u, v, w) = f(L(u, v, w)), the form along one row of pixels: series of degree `across` in u, whose terms
/// are polynomials of degree `along` in w by Bernstein coefficients [u][w], filled_depths apart. `sums` are
/// those of g, `slopes` of dg/dv, v in pixels.
template <class C> struct RowForm {
  int across, along;
  const C *sums, *slopes;
};

/// The pixels x0 to x0 + 15 of row v of a tile; depth s0 <= s <= s1 is w = (s - s0) / (s1 - s0).
struct RowPlace {
  double x0, v, s0, s1;
};

/// x and y of the unit normals with z >= 0 at depths s of the row's rays, in world space: with the map's
/// Jacobian J, whose columns are dL/du, dL/dv and dL/ds, the solution of J^T n = grad g, which has the
/// direction of  g_u (L_v x L_s) + g_v (L_s x L_u) + g_s (L_u x L_v).
///
/// weights  query.weights_u and slopes_u as C
/// NaN      where the gradient vanishes or is not finite
/// source   Reimers, Seland: Ray casting algebraic surfaces using the frustum form, Computer Graphics Forum
///          27(2), 2008
template <class C>
inline void find_form_normals(const FrustumQuery& query, const RowForm<C>& form,
                              const C (&weights)[kMostFormDegree + 1][16],
                              const C (&slopes)[kMostFormDegree + 1][16], const RowPlace& place,
                              const double* s, double* normal_x, double* normal_y) {
  using R = Native<C>;
  const int n = form.across + 1, row = filled_depths<C>(form.along);
  C w[16], slope_w[16], gu[16], gv[16];
  for (int x = 0; x < 16; ++x) w[x] = C((s[x] - place.s0) / (place.s1 - place.s0));
  for (int x = 0; x < 16; x += kWidth<R>) {
    Bezier<R> g, g_u, g_v;
    g.degree = g_u.degree = g_v.degree = form.along;
    for (int k = 0; k <= form.along; ++k) {
      g.c[k] = g_u.c[k] = g_v.c[k] = R(0);
      for (int i = 0; i < n; ++i) {
        const R weight = load<R>(weights[i] + x), sum = R(form.sums[i * row + k]);
        g.c[k] = g.c[k] + weight * sum;
        g_u.c[k] = g_u.c[k] + load<R>(slopes[i] + x) * sum;
        g_v.c[k] = g_v.c[k] + weight * R(form.slopes[i * row + k]);
      }
    }
    const R at = load<R>(w + x);
    store(slope_w + x, g.slope_at(at)), store(gu + x, g_u.at(at)), store(gv + x, g_v.at(at));
  }

  const PixelLines& l = query.lines;
  double columns[16], along[3][16];
  for (int x = 0; x < 16; ++x) {
    columns[x] = place.x0 + x + query.offset_u;
    along[0][x] = double(gu[x]), along[1][x] = double(gv[x]);
    along[2][x] = double(slope_w[x]) / (place.s1 - place.s0);
  }
  for (int x = 0; x < 16; x += kWidth<Wide>) {
    const Wide u = load<Wide>(columns + x), depth = load<Wide>(s + x);
    Wide l_u[3], l_v[3], l_s[3], normal[3];
    for (int a = 0; a < 3; ++a) {
      l_u[a] = Wide(l.o_u[a]) + depth * Wide(l.d_u[a]), l_v[a] = Wide(l.o_v[a]) + depth * Wide(l.d_v[a]);
      l_s[a] = Wide(l.d[a] + place.v * l.d_v[a]) + u * Wide(l.d_u[a]);
    }
    const Wide g_u = load<Wide>(along[0] + x), g_v = load<Wide>(along[1] + x), g_s = load<Wide>(along[2] + x);
    Wide squared = Wide(0);
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      normal[a] = g_u * (l_v[b] * l_s[c] - l_v[c] * l_s[b]) + g_v * (l_s[b] * l_u[c] - l_s[c] * l_u[b]) +
                  g_s * (l_u[b] * l_v[c] - l_u[c] * l_v[b]);
      squared = squared + normal[a] * normal[a];
    }
    const Mask<Wide> known = (squared > Wide(1e-290)) & (squared < Wide(kInfinity<double>));
    const Wide scale = select(known, copysign(Wide(1) / sqrt(squared), normal[2]), Wide(__builtin_nan("")));
    store(normal_x + x, scale * normal[0]), store(normal_y + x, scale * normal[1]);
  }
}

}  // namespace isocast::inline ISO_ISA
