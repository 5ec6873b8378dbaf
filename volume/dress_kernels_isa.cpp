// Compiled once per instruction set: dressing over the native register of double.
#include <isocast/math/pack.h>
#include <isocast/render/lighting.h>
#include <isocast/volume/cell/cell.h>
#include <isocast/volume/dress_kernels.h>

namespace isocast::inline ISO_ISA {

extern const DressKernels dress_kernel_table;

namespace {

using R = Native<double>;

Vec3<R> load3(const double (&rows)[3][kPacketSize], int i) {
  return {load<R>(rows[0] + i), load<R>(rows[1] + i), load<R>(rows[2] + i)};
}
void store3(double (&rows)[3][kPacketSize], int i, const Vec3<R>& v) {
  store(rows[0] + i, v.x);
  store(rows[1] + i, v.y);
  store(rows[2] + i, v.z);
}

// Calls work(i, mask) for every register with something to dress.
template <class Work> void for_registers(const HitsToDress& dress, Work work) {
  for (int i = 0; i < kPacketSize; i += kWidth<R>) {
    const Mask<R> mine = load<R>(dress.mine + i) > R(0);
    if (any(mine)) work(i, mine);
  }
}
void store_masked(double* to, Mask<R> mask, R v) { store(to, select(mask, v, load<R>(to))); }

void load_corners(const HitsToDress& dress, int i, R (&f)[8]) {
  for (int k = 0; k < 8; ++k) f[k] = load<R>(dress.corners[k] + i);
}

void locate(const double (&m)[3][4], const RayStream& rays, const HitStream& hits, int first,
            HitsToDress& dress) {
  for_registers(dress, [&](int i, Mask<R>) {
    const int slot = first + i;
    const R t = load<R>(hits.t + slot);
    const Vec3<R> p = {load<R>(rays.ox + slot) + t * load<R>(rays.dx + slot),
                       load<R>(rays.oy + slot) + t * load<R>(rays.dy + slot),
                       load<R>(rays.oz + slot) + t * load<R>(rays.dz + slot)};
    store3(dress.world, i, p);
    for (int a = 0; a < 3; ++a) {
      const R grid = R(m[a][0]) * p.x + R(m[a][1]) * p.y + R(m[a][2]) * p.z + R(m[a][3]);
      double cell[kWidth<R>];
      for (int l = 0; l < kWidth<R>; ++l) cell[l] = double(hits.cell[a][slot + l]);
      store(dress.place[a] + i, clamp01(grid - load<R>(cell)));
    }
  });
}

void differentiate(HitsToDress& dress) {
  const auto plane = [](R a, R b, R c, R d, R u, R v) { return lerp(lerp(a, b, u), lerp(c, d, u), v); };
  for_registers(dress, [&](int i, Mask<R>) {
    R f[8];
    load_corners(dress, i, f);
    const Vec3<R> p = load3(dress.place, i);
    store3(dress.gradient, i,
           {plane(f[1] - f[0], f[3] - f[2], f[5] - f[4], f[7] - f[6], p.y, p.z),
            plane(f[2] - f[0], f[3] - f[1], f[6] - f[4], f[7] - f[5], p.x, p.z),
            plane(f[4] - f[0], f[5] - f[1], f[6] - f[2], f[7] - f[3], p.x, p.y)});
  });
}

void turn(const double (&m)[3][4], const RayStream& rays, int first, const HitsToDress& dress,
          double (&normal)[3][kStreamSize]) {
  for_registers(dress, [&](int i, Mask<R> mine) {
    const int slot = first + i;
    const Vec3<R> g = load3(dress.gradient, i);
    const auto world = [&](int c) { return R(m[0][c]) * g.x + R(m[1][c]) * g.y + R(m[2][c]) * g.z; };
    const Vec3<R> n = unit(Vec3<R>{world(0), world(1), world(2)});
    const R along =
        dot(n, Vec3<R>{load<R>(rays.dx + slot), load<R>(rays.dy + slot), load<R>(rays.dz + slot)});
    const R sign = select(along > R(0), R(-1), R(1));
    store_masked(normal[0] + slot, mine, sign * n.x);
    store_masked(normal[1] + slot, mine, sign * n.y);
    store_masked(normal[2] + slot, mine, sign * n.z);
  });
}

void interpolate(double slope, double intercept, int first, const HitsToDress& dress,
                 double (&value)[kStreamSize]) {
  for_registers(dress, [&](int i, Mask<R> mine) {
    R f[8];
    load_corners(dress, i, f);
    store_masked(value + first + i, mine, R(slope) * trilinear(f, load3(dress.place, i)) + R(intercept));
  });
}

}  // namespace

const DressKernels dress_kernel_table = {locate, differentiate, turn, interpolate};

}  // namespace isocast::inline ISO_ISA
