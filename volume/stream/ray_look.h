// A first look at the 4^3 boxes of a cube: which of them a ray may cross.
#pragma once

#include <isocast/math/lanes.h>
#include <isocast/math/pack.h>
#include <isocast/volume/stream/walking_rays.h>

namespace isocast::inline ISO_ISA {

/// What float may be off by: some roundings of a difference and of its product.
inline constexpr float kLookSlack = 0x1p-20f, kLookTiny = 0x1p-70f;

/// Bits of the boxes that a ray may cross, numbered as those of a cube (cube_bits.h): all that it crosses
/// behind its first cell's entry, and few others. corner: of the cube, in cells from the bricks' origin on;
/// size: of a box.
///
/// Planes lie where the ray's own rounding puts them too low or too high; float's is in the slack. Along an
/// axis that the ray is parallel to, `low` and `high` are the middle of its cell, and `inverse` is so large
/// that boxes around it are entered long before and left long after everything else.
template <Real R>
inline std::uint64_t look_at_boxes(const RayLook& look, const std::int32_t (&corner)[3], std::int32_t size) {
  constexpr int kWidth = isocast::kWidth<R>;
  float near[3][4], far[3][4];
  for (int a = 0; a < 3; ++a)
    for (int i = 0; i < 4; ++i) {
      const float low = float(double(corner[a] + i * size) - look.low[a]) * look.inverse[a],
                  high = float(double(corner[a] + (i + 1) * size) - look.high[a]) * look.inverse[a];
      near[a][i] = min(low, high);
      const float behind = max(low, high);
      far[a][i] = behind + abs(behind) * kLookSlack + kLookTiny;
    }
  alignas(64) float enters[16], leaves[16];
  for (int l = 0; l < 16; ++l) {
    enters[l] = max(max(near[0][l & 3], near[1][l >> 2]), 0.0f);
    leaves[l] = min(min(far[0][l & 3], far[1][l >> 2]), look.end);
  }
  std::uint64_t bits = 0;
  for (int z = 0; z < 4; ++z)
    for (int l = 0; l < 16; l += kWidth) {
      const R enter = max(load<R>(enters + l), R(near[2][z])), leave = min(load<R>(leaves + l), R(far[2][z]));
      bits |= std::uint64_t(bits_of(enter <= leave)) << (16 * z + l);
    }
  return bits;
}

#ifdef __AVX512DQ__
template <>
inline std::uint64_t look_at_boxes<Pack<float, 16>>(const RayLook& look, const std::int32_t (&corner)[3],
                                                    std::int32_t size) {
  using R = Pack<float, 16>;
  const __m512d row = _mm512_load_pd(look.low);
  const double step = size;
  const __m512d steps = _mm512_mul_pd(_mm512_set_pd(3, 2, 1, 0, 3, 2, 1, 0), _mm512_set1_pd(step)),
                xy = _mm512_maskz_insertf64x4(0xff, _mm512_set1_pd(corner[0]), _mm256_set1_pd(corner[1]), 1),
                first = _mm512_add_pd(xy, steps), last = _mm512_add_pd(_mm512_set1_pd(corner[2]), steps),
                edge = _mm512_set1_pd(step);
  // four lanes an axis; those of z twice
  const auto of = [&](long long x, long long y) {
    return _mm512_maskz_permutexvar_pd(0xff, _mm512_set_epi64(y, y, y, y, x, x, x, x), row);
  };
  const auto floats = [](__m512d a, __m512d b) {
    return R(_mm512_maskz_insertf32x8(0xffff, _mm512_castps256_ps512(_mm512_maskz_cvtpd_ps(0xff, a)),
                                      _mm512_maskz_cvtpd_ps(0xff, b), 1));
  };
  const auto pick = [](R v, __m512i lanes) { return R(_mm512_maskz_permutexvar_ps(0xffff, lanes, v.v)); };
  const R inverse = pick(R(_mm512_castpd_ps(row)),
                         _mm512_set_epi32(14, 14, 14, 14, 14, 14, 14, 14, 13, 13, 13, 13, 12, 12, 12, 12)),
          end = pick(R(_mm512_castpd_ps(row)), _mm512_set1_epi32(15)),
          low = floats(first - of(0, 1), last - of(2, 2)) * inverse,
          high = floats(first + edge - of(3, 4), last + edge - of(5, 5)) * inverse, near = min(low, high),
          behind = max(low, high), far = behind + abs(behind) * R(kLookSlack) + R(kLookTiny);
  // the four numbers of an axis to every row of four; then one of them to all lanes of its row
  const auto spread = [](R v, auto axis) {
    return R(_mm512_maskz_shuffle_f32x4(0xffff, v.v, v.v, axis * 0x55));
  };
  const auto repeat = [](R v, auto i) { return R(_mm512_maskz_permute_ps(0xffff, v.v, i * 0x55)); };
  const __m512i by_y = _mm512_set_epi32(7, 7, 7, 7, 6, 6, 6, 6, 5, 5, 5, 5, 4, 4, 4, 4);
  const R enters = max(max(spread(near, Index<0>{}), pick(near, by_y)), R(0)),
          leaves = min(min(spread(far, Index<0>{}), pick(far, by_y)), end), near_z = spread(near, Index<2>{}),
          far_z = spread(far, Index<2>{});
  std::uint64_t bits = 0;
  each_index<4>([&](auto i) {
    bits |= std::uint64_t(bits_of(max(enters, repeat(near_z, i)) <= min(leaves, repeat(far_z, i)))) << 16 * i;
  });
  return bits;
}
#endif

}  // namespace isocast::inline ISO_ISA
