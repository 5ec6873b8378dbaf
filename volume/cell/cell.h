// One trilinear cell and one chord of it over any Real: the field, and the cubic along the ray.
#pragma once

#include <isocast/math/cubic.h>
#include <isocast/math/refine.h>
#include <isocast/math/vec.h>
#include <isocast/volume/cell/options.h>

namespace isocast::inline ISO_ISA {

/// The lanes of a CellPacket (packet.h describes the members).
template <Real R> struct Cell {
  R f[8];
  Vec3<R> entry, exit;
  R begin, carry, slack;
};

/// The lanes of a RootPacket. `sign_behind` true: f is negative behind the root.
template <Real R> struct Root {
  R s, s_lo, s_hi;
  Mask<R> hit, undecided, sign_behind, proved = Mask<R>(false);
};

/// Steps end where they fall below this fraction of the chord: 2^-20 in float, 2^-46 in double.
template <class T> inline constexpr T kTolerance = T(0);
template <> inline constexpr float kTolerance<float> = 0x1p-20f;
template <> inline constexpr double kTolerance<double> = 0x1p-46;

/// The trilinear interpolant at p in [0,1]^3: along x, then y, then z, always in this order, so that the
/// value at a point of a face has the same bits in both cells that share it, and the sign of the corners if
/// they agree.
template <Real R> ISO_HD inline R trilinear(const R (&f)[8], const Vec3<R>& p) {
  const R y0 = lerp(lerp(f[0], f[1], p.x), lerp(f[2], f[3], p.x), p.y);
  const R y1 = lerp(lerp(f[4], f[5], p.x), lerp(f[6], f[7], p.x), p.y);
  return lerp(y0, y1, p.z);
}

/// The same at a point of a face, from the four corners of that face only; trilinear where p lies on none.
template <Real R> ISO_HD inline R bilinear_on_face(const R (&f)[8], const Vec3<R>& p) {
  const Mask<R> on_x = (p.x == R(0)) | (p.x == R(1)), on_y = (p.y == R(0)) | (p.y == R(1)),
                on_z = (p.z == R(0)) | (p.z == R(1));
  if (any(!(on_x | on_y | on_z))) return trilinear(f, p);
  const Mask<R> x1 = p.x == R(1), y1 = p.y == R(1), z1 = p.z == R(1);
  // corners a, b, c, d of the face, the lower free axis first
  const R a =
      select(on_x, select(x1, f[1], f[0]), select(on_y, select(y1, f[2], f[0]), select(z1, f[4], f[0])));
  const R b =
      select(on_x, select(x1, f[3], f[2]), select(on_y, select(y1, f[3], f[1]), select(z1, f[5], f[1])));
  const R c =
      select(on_x, select(x1, f[5], f[4]), select(on_y, select(y1, f[6], f[4]), select(z1, f[6], f[2])));
  const R d =
      select(on_x, select(x1, f[7], f[6]), select(on_y, select(y1, f[7], f[5]), select(z1, f[7], f[3])));
  const R u = select(on_x, p.y, p.x), v = select(on_x | on_y, p.z, p.y);
  return lerp(lerp(a, b, u), lerp(c, d, u), v);
}

/// f along the chord in Bernstein form, by blossoming: every coefficient is an average of corner values, so
/// nothing cancels. c0 and c3 have the bits of trilinear() at entry and exit.
template <Real R> ISO_HD inline BernsteinCubic<R> cubic_along(const Cell<R>& cell) {
  const Vec3<R>& p = cell.entry;
  const Vec3<R>& q = cell.exit;
  // f at x of P and Q on the four edges, then the y combinations PP, PQ + QP, QQ on both z faces
  R pp[2], mixed[2], qq[2];
  for (int z = 0; z < 2; ++z) {
    const R p0 = lerp(cell.f[4 * z], cell.f[4 * z + 1], p.x),
            p1 = lerp(cell.f[4 * z + 2], cell.f[4 * z + 3], p.x);
    const R q0 = lerp(cell.f[4 * z], cell.f[4 * z + 1], q.x),
            q1 = lerp(cell.f[4 * z + 2], cell.f[4 * z + 3], q.x);
    pp[z] = lerp(p0, p1, p.y);
    mixed[z] = lerp(p0, p1, q.y) + lerp(q0, q1, p.y);
    qq[z] = lerp(q0, q1, q.y);
  }
  const R third = R(1) / R(3);
  return {lerp(pp[0], pp[1], p.z), third * (lerp(mixed[0], mixed[1], p.z) + lerp(pp[0], pp[1], q.z)),
          third * (lerp(mixed[0], mixed[1], q.z) + lerp(qq[0], qq[1], p.z)), lerp(qq[0], qq[1], q.z)};
}

/// f along the chord in powers, from differences of corner values as textbooks have it (algorithms: form
/// (b)).
template <Real R> ISO_HD inline PowerCubic<R> textbook_cubic_along(const Cell<R>& cell) {
  const R(&f)[8] = cell.f;
  const R ax = cell.entry.x, ay = cell.entry.y, az = cell.entry.z;
  const R bx = cell.exit.x - ax, by = cell.exit.y - ay, bz = cell.exit.z - az;
  const R k1 = f[1] - f[0], k2 = f[2] - f[0], k3 = f[4] - f[0];
  const R k4 = f[3] - f[1] - f[2] + f[0], k5 = f[5] - f[1] - f[4] + f[0], k6 = f[6] - f[2] - f[4] + f[0];
  const R k7 = f[7] - f[3] - f[5] - f[6] + f[1] + f[2] + f[4] - f[0];
  return {
      k7 * bx * by * bz,
      k7 * (ax * by * bz + bx * ay * bz + bx * by * az) + k4 * bx * by + k5 * bx * bz + k6 * by * bz,
      k7 * (ax * ay * bz + ax * by * az + bx * ay * az) + k4 * (ax * by + bx * ay) +
          k5 * (ax * bz + bx * az) + k6 * (ay * bz + by * az) + k1 * bx + k2 * by + k3 * bz,
      f[0] + k1 * ax + k2 * ay + k3 * az + k4 * ax * ay + k5 * ax * az + k6 * ay * az + k7 * ax * ay * az};
}

/// f at `begin`, unless its sign is known: then a zero of that sign.
template <Real R> ISO_HD inline R with_carried_sign(const Cell<R>& cell, R f_begin) {
  return select(cell.carry == cell.carry, cell.carry, f_begin);
}

/// A point of the chord.
template <Real R> ISO_HD inline Vec3<R> point_at(const Cell<R>& cell, R s) {
  return lerp(cell.entry, cell.exit, s);
}

}  // namespace isocast::inline ISO_ISA
