// Cameras around a domain of [-2, 2], and hits that must be the same.
#pragma once

#include <isocast/render/camera.h>

#include <catch2/catch.hpp>
#include <random>

namespace isocast::test {

/// Perspective from outside, from inside and from far away, wide angles, and parallel rays.
inline Camera random_camera(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto point = [&](double size) {
    return Double3{size * unit(random), size * unit(random), size * unit(random)};
  };
  const double sizes[] = {1.5, 4, 8, 1e4};
  Camera camera;
  camera.position = point(sizes[random() % 4]);
  camera.target = point(1);
  camera.up = point(1);
  camera.fov = random() % 2 ? 40 : 120;
  if (random() % 3 == 0) camera.ortho_height = 4;
  return camera;
}

/// The same bits in every slot.
inline void require_same_bits(const HitStream& a, const HitStream& b, int size) {
  for (int i = 0; i < size; ++i) {
    REQUIRE(a.t[i] == b.t[i]);
    REQUIRE(a.certificate[i] == b.certificate[i]);
    if (!is_hit(a, i)) continue;
    REQUIRE(a.t_lo[i] == b.t_lo[i]);
    REQUIRE(a.t_hi[i] == b.t_hi[i]);
  }
}

}  // namespace isocast::test
