// A first look at the rays of small windows of a patch: which of them may cross a cell.
#pragma once

#include <isocast/volume/int_lanes.h>
#include <isocast/volume/primary/patch.h>

namespace isocast::inline ISO_ISA {

/// A window is as large as a register of floats: kColumns x kRows pixels.
template <Real R> inline constexpr int kColumns = kWidth<R> < 4 ? kWidth<R> : 4;
template <Real R> inline constexpr int kRows = kWidth<R> / kColumns<R>;

/// The lanes of the window at (x, y) that lie in a box of pixels.
template <Real R> inline unsigned window_lanes(const PixelBox& pixels, int x, int y) {
  constexpr unsigned kEveryRow = ((1ull << kWidth<R>)-1) / ((1u << kColumns<R>)-1);
  const int columns = pixels.x_hi - x + 1, rows = pixels.y_hi - y + 1;
  unsigned lanes = (1ull << kWidth<R>)-1;
  if (columns < kColumns<R>) lanes &= ((1u << columns) - 1) * kEveryRow;
  if (rows < kRows<R>) lanes &= (1u << rows * kColumns<R>)-1;
  return lanes;
}

/// Values of the rays of the window whose first ray is number `at`.
template <Real R> inline R load_window(const float* rays, int at) {
#if defined(__AVX2__)
  const float* from = rays + at;
  const __m256 low =
      _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(from)), _mm_loadu_ps(from + kPatchPitch), 1);
#if defined(__AVX512DQ__)
  const __m256 high = _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(from + 2 * kPatchPitch)),
                                           _mm_loadu_ps(from + 3 * kPatchPitch), 1);
  return R(_mm512_maskz_insertf32x8(0xffff, _mm512_castps256_ps512(low), high, 1));
#else
  return R(low);
#endif
#else
  return load<R>(rays + at);
#endif
}

/// What float may be off by: some roundings of a product, or of a difference of numbers no larger than
/// `reach`.
inline constexpr float kQuickFactor = 1 + 0x1p-20f, kQuickTiny = 0x1p-70f;
inline constexpr double kQuickSlack = 0x1p-20;

/// Cells of a block per axis.
inline constexpr int kBlockCells = 4;

/// The planes before and behind the cells of a block along each axis, as far as rays can see them in float.
/// Perspective: relative to the eye. Orthographic: where the ray of the patch's corner meets them, moved
/// outward; nowhere along axes that a first look cannot use.
struct QuickBlock {
  float low[3][kBlockCells], high[3][kBlockCells];
};
template <bool kOrthographic>
inline QuickBlock quick_block(const PatchLook& look, const std::int32_t (&first)[3]) {
  QuickBlock quick;
  for (int a = 0; a < 3; ++a)
    for (int i = 0; i < kBlockCells; ++i) {
      const double k = double(first[a] + i);
      if constexpr (!kOrthographic) {
        quick.low[a][i] = float(k - look.shared[a]);
        quick.high[a][i] = float(k + 1 - look.shared[a]);
      } else if (look.shared_quick[a] == 0) {
        quick.low[a][i] = -__builtin_inff();
        quick.high[a][i] = __builtin_inff();
      } else {
        const double low = (k - look.corner[a]) * look.shared_quick[a],
                     high = (k + 1 - look.corner[a]) * look.shared_quick[a],
                     slack = kQuickSlack * (abs(low) + abs(high) + look.reach[a]) + double(kQuickTiny);
        quick.low[a][i] = float(min(low, high) - slack);
        quick.high[a][i] = float(max(low, high) + slack);
      }
    }
  return quick;
}

/// The rays of the window whose first ray is number `at` that may cross a cell of a block before their
/// nearest root: all that do, and few others. place: of the cell in the block.
template <bool kOrthographic>
inline unsigned rays_across(const PatchState& patch, const QuickBlock& block, const int (&place)[3], int at) {
  using R = Native<float>;
  R near[3], far[3];
  for (int a = 0; a < 3; ++a) {
    const R ray = load_window<R>(patch.look.quick[a], at);
    const R before = R(block.low[a][place[a]]), behind = R(block.high[a][place[a]]),
            low = kOrthographic ? before - ray : before * ray,
            high = kOrthographic ? behind - ray : behind * ray;
    near[a] = kOrthographic ? low : min(low, high);
    far[a] = kOrthographic ? high : max(low, high);
  }
  const R t_in = max(max(max(near[0], near[1]), near[2]), R(0)),
          t_out = R(kQuickFactor) * min(min(far[0], far[1]), far[2]) + R(kQuickTiny);
  return bits_of((t_in <= t_out) & (t_in <= load_window<R>(patch.limit, at)));
}

/// The numbers of the rays of the window whose first ray is number `at`.
template <Real R> inline Ints<R> rays_from(int at) {
  constexpr std::int32_t p = kPatchPitch;
  alignas(64) static constexpr std::int32_t kOffsets[16] = {
      0,     1,         2,         3,         p,     p + 1,     p + 2,     p + 3,
      2 * p, 2 * p + 1, 2 * p + 2, 2 * p + 3, 3 * p, 3 * p + 1, 3 * p + 2, 3 * p + 3};
  return load_ints<R>(kOffsets) + at;
}

}  // namespace isocast::inline ISO_ISA
