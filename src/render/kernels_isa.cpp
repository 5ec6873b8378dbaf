// Compiled once per instruction set: rays and light over the native register of double.
#include <isocast/math/pack.h>
#include <isocast/render/kernels.h>
#include <isocast/render/lighting.h>

namespace isocast::inline ISO_ISA {

extern const RenderKernels render_kernel_table;

namespace {

using R = Native<double>;

// Pixels per side of a tile and of a packet.
constexpr int kTile = 16, kPacket = 4, kColumns = kTile / kPacket;

// Places of a packet's lanes in it.
constexpr double kAcross[kPacketSize] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3},
                 kDown[kPacketSize] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

// Origins and directions of the packet at pixel (x, y), from slot i on.
void fill_packet(const RayFrame& frame, int x, int y, double offset_u, double offset_v, int i,
                 RayStream& rays) {
  for (int l = 0; l < kPacketSize; l += kWidth<R>, i += kWidth<R>) {
    const R u = (R(x) + load<R>(kAcross + l)) + R(offset_u), v = (R(y) + load<R>(kDown + l)) + R(offset_v);
    const auto [o, d] = primary_ray(frame, u, v);
    store(rays.ox + i, o.x);
    store(rays.oy + i, o.y);
    store(rays.oz + i, o.z);
    store(rays.dx + i, d.x);
    store(rays.dy + i, d.y);
    store(rays.dz + i, d.z);
  }
}

void fill_rays(const RayFrame& frame, int tx, int ty, double offset_u, double offset_v, RayStream& rays) {
  rays.size = kStreamSize;
  rays.kind = RayKind::primary;
  for (int p = 0; p < kStreamSize / kPacketSize; ++p) {
    const int x0 = tx * kTile + p % kColumns * kPacket, y0 = ty * kTile + p / kColumns * kPacket;
    fill_packet(frame, x0, y0, offset_u, offset_v, p * kPacketSize, rays);
    for (int l = 0; l < kPacketSize; ++l) {
      const int i = p * kPacketSize + l, x = x0 + l % kPacket, y = y0 + l / kPacket;
      const bool inside = x < frame.width && y < frame.height;
      rays.u[i] = static_cast<float>(x + offset_u);
      rays.v[i] = static_cast<float>(y + offset_v);
      rays.t_min[i] = inside ? 0 : 1;
      rays.t_max[i] = inside ? __builtin_inf() : 0;
      rays.id[i] = inside ? static_cast<std::uint32_t>(x + y * frame.width) : 0;
      rays.start_object[i] = kNoObject;
      rays.start_sides[i] = 0;
    }
  }
}

void store_as_float(float* to, R v) {
  double lanes[kWidth<R>];
  store(lanes, v);
  for (int l = 0; l < kWidth<R>; ++l) to[l] = float(lanes[l]);
}

void light(const RayStream& rays, const HitStream& hits, const double (&normal)[3][kStreamSize],
           const double* to_light, FallingLight& light) {
  for (int i = 0; i < rays.size; i += kWidth<R>) {
    if (!any(load<R>(hits.t + i) < R(__builtin_inf()))) continue;
    const Vec3<R> d = unit(Vec3<R>{load<R>(rays.dx + i), load<R>(rays.dy + i), load<R>(rays.dz + i)}),
                  to_eye = {R(-1) * d.x, R(-1) * d.y, R(-1) * d.z},
                  n = {load<R>(normal[0] + i), load<R>(normal[1] + i), load<R>(normal[2] + i)};
    const Incidence<R> on =
        to_light ? incidence(n, Vec3<R>{R(to_light[0]), R(to_light[1]), R(to_light[2])}, to_eye)
                 : headlight(n, to_eye);
    store_as_float(light.facing + i, on.facing);
    store_as_float(light.highlight + i, on.highlight);
  }
}

void add_light(const LitSurfaces& surfaces, const FallingLight& light, float strength,
               const float (&visible)[kStreamSize], int size, float (&colors)[3][kStreamSize]) {
  using F = Native<float>;
  for (int i = 0; i < size; i += kWidth<F>) {
    const F share = F(strength) * load<F>(visible + i), facing = load<F>(light.facing + i),
            highlight = load<F>(light.highlight + i), specular = load<F>(surfaces.specular + i);
    for (int c = 0; c < 3; ++c)
      store(colors[c] + i, load<F>(colors[c] + i) +
                               share * lit(load<F>(surfaces.color[c] + i), specular, facing, highlight));
  }
}

}  // namespace

const RenderKernels render_kernel_table = {fill_rays, light, add_light};

}  // namespace isocast::inline ISO_ISA
