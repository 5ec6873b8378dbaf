// What a frame does for many rays at once has the same bits on every instruction set.
#include <isocast/isa/cpu.h>
#include <isocast/render/kernels.h>
#include <isocast/render/lighting.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <memory>
#include <random>

using namespace isocast;

namespace {

RayFrame frame_of(bool orthographic) {
  return {{-0.31, 0.27, 0.9}, {0.0031, 0.0002, -0.0011}, {0.0003, -0.0029, 0.0004}, {4, -3.3, 0.7}, 50, 37,
          orthographic};
}

template <class T> bool same(const T& a, const T& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace

TEST_CASE("rays of a tile: every instruction set gives the same bits, border tiles hold empty slots") {
  const auto expected = std::make_unique<RayStream>(), rays = std::make_unique<RayStream>();
  for (const bool orthographic : {false, true})
    for (const int tile : {0, 1, 3}) {
      const RayFrame frame = frame_of(orthographic);
      render_kernels(Isa::scalar).fill_rays(frame, tile, tile / 2, 0.5, 0.25, *expected);
      int inside = 0;
      for (int i = 0; i < kStreamSize; ++i) inside += expected->t_min[i] <= expected->t_max[i];
      CHECK(inside == (tile == 3 ? 2 * 16 : 256));
      for (const Isa isa : available_isas()) {
        INFO(name_of(isa));
        render_kernels(isa).fill_rays(frame, tile, tile / 2, 0.5, 0.25, *rays);
        CHECK(same(expected->ox, rays->ox));
        CHECK(same(expected->oy, rays->oy));
        CHECK(same(expected->oz, rays->oz));
        CHECK(same(expected->dx, rays->dx));
        CHECK(same(expected->dy, rays->dy));
        CHECK(same(expected->dz, rays->dz));
        CHECK(same(expected->t_max, rays->t_max));
        CHECK(same(expected->id, rays->id));
        CHECK(same(expected->u, rays->u));
      }
    }
}

TEST_CASE(
    "light on hits: every instruction set gives the bits of incidence(), also for NaN and zero normals") {
  const auto rays = std::make_unique<RayStream>();
  const auto hits = std::make_unique<HitStream>();
  render_kernels(Isa::scalar).fill_rays(frame_of(false), 0, 0, 0.5, 0.5, *rays);
  clear(*hits);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-1, 1);
  double normal[3][kStreamSize];
  const auto falling = std::make_unique<FallingLight>();
  for (int i = 0; i < kStreamSize; ++i) {
    if (random() % 3) hits->t[i] = 1;
    for (auto& component : normal)
      component[i] = i % 50 == 7 ? std::nan("") : i % 50 == 8 ? 0 : number(random);
  }
  const double light[3] = {0.6, 0, 0.8};
  for (const double* to_light : {light, static_cast<const double*>(nullptr)})
    for (const Isa isa : available_isas()) {
      INFO(name_of(isa));
      render_kernels(isa).light(*rays, *hits, normal, to_light, *falling);
      for (int i = 0; i < kStreamSize; ++i) {
        if (!is_hit(*hits, i)) continue;
        const Vec3<double> d = unit(Vec3<double>{rays->dx[i], rays->dy[i], rays->dz[i]}),
                           eye = {-1 * d.x, -1 * d.y, -1 * d.z}, towards = {light[0], light[1], light[2]},
                           n = {normal[0][i], normal[1][i], normal[2][i]};
        const auto expected = to_light ? incidence(n, towards, eye) : headlight(n, eye);
        if (std::isnan(expected.facing)) {
          CHECK(std::isnan(falling->facing[i]));
          continue;
        }
        CHECK(same(static_cast<float>(expected.facing), falling->facing[i]));
        CHECK(same(static_cast<float>(expected.highlight), falling->highlight[i]));
      }
    }
}
