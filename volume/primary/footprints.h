// Which pixels of a patch a box of cells may meet, and whether what is there already hides it.
#pragma once

#include <isocast/volume/primary/screen_map.h>
#include <isocast/volume/primary/windows.h>

namespace isocast::inline ISO_ISA {

/// Pixels that what is said of a footprint may be off by.
inline constexpr float kMargin = 0x1p-5f;

/// to_pixel seen from a patch: pixel (0, 0) is its first sample. to_eye, and the
/// radius of a cell, are in the unit of t. linear, eye: the linear parts.
struct PatchMap {
  double h[3][4], to_eye[3][4];
  float linear[3][3], eye[3][3], radius;
};
inline PatchMap patch_map(const ScreenMap& map, const PatchState& patch) {
  PatchMap m;
  const double u = patch.x + patch.offset_u, v = patch.y + patch.offset_v;
  for (int c = 0; c < 4; ++c) {
    const double w = map.to_pixel[2][c];
    m.h[0][c] = map.to_pixel[0][c] - u * w;
    m.h[1][c] = map.to_pixel[1][c] - v * w;
    m.h[2][c] = w;
  }
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) {
      m.to_eye[r][c] = map.unit * map.to_eye[r][c];
      if (c == 3) continue;
      m.linear[r][c] = float(m.h[r][c]);
      m.eye[r][c] = float(m.to_eye[r][c]);
    }
  m.radius = float(map.unit * map.cell_radius);
  return m;
}
inline double apply(const double (&row)[4], const double (&p)[3]) {
  return row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
}

/// The sums of a box's extent along a linear form: how far the form may be from its value at the centre.
inline double extent(const double (&form)[4], double size) {
  return 0.5 * size * (abs(form[0]) + abs(form[1]) + abs(form[2]));
}
/// Whether any ray of the patch may meet a box that is not wholly in front of the eye: false where it lies
/// behind one of the planes of the patch's pyramid, or behind the eye.
inline bool may_meet(const PatchMap& map, const PatchState& patch, const double (&center)[3], double size) {
  const auto behind = [&](double x, double y, double w) {
    double form[4];
    for (int c = 0; c < 4; ++c) form[c] = x * map.h[0][c] + y * map.h[1][c] + w * map.h[2][c];
    const double least = extent(form, size);
    return apply(form, center) + least < -1e-6 * least;
  };
  const double m = double(kMargin);
  return !behind(0, 0, 1) && !behind(1, 0, m) && !behind(-1, 0, patch.columns - 1 + m) && !behind(0, 1, m) &&
         !behind(0, -1, patch.rows - 1 + m);
}

/// The first and the last pixel of center +- half among lo...hi, as whole numbers; what is NaN reaches over
/// all.
template <Real R> inline R first_pixel(R center, R half, int lo, int hi) {
  return min(max(ceil(center - half - R(kMargin)), R(float(lo))), R(float(hi + 1)));
}
template <Real R> inline R last_pixel(R center, R half, int lo, int hi) {
  return max(min(floor(center + half + R(kMargin)), R(float(hi))), R(float(lo - 1)));
}

/// No ray meets a box before this t. eye: to_eye of its centre; radius: half its longest diagonal.
template <Real R> inline R nearest_t(bool orthographic, const R (&eye)[3], R radius) {
  const R t = orthographic ? eye[0] : sqrt(eye[0] * eye[0] + eye[1] * eye[1] + eye[2] * eye[2]);
  return t - radius - R(1e-5f) * (abs(eye[0]) + abs(eye[1]) + abs(eye[2]) + radius);
}

/// The largest limit of a part of the patch.
inline float farthest(PatchState& patch, int part) {
  const std::uint64_t bit = std::uint64_t(1) << part;
  if (!(patch.stale & bit)) return patch.far[part];
  using R = Native<float>;
  R far = R(-__builtin_inff());
  const int first = part / kPatchParts * kPartSize * kPatchPitch + part % kPatchParts * kPartSize;
  for (int y = 0; y < kPartSize; y += kRows<R>)
    for (int x = 0; x < kPartSize; x += kColumns<R>)
      far = max(load_window<R>(patch.limit, first + y * kPatchPitch + x), far);
  float lanes[kWidth<R>];
  store(lanes, far);
  float largest = lanes[0];
  for (const float lane : lanes) largest = max(lane, largest);
  patch.stale &= ~bit;
  return patch.far[part] = largest;
}

/// All rays of the pixels have met something before t, in the unit of t.
inline bool hidden(PatchState& patch, const PixelBox& pixels, float t) {
  for (int y = pixels.y_lo / kPartSize; y <= pixels.y_hi / kPartSize; ++y)
    for (int x = pixels.x_lo / kPartSize; x <= pixels.x_hi / kPartSize; ++x)
      if (!(farthest(patch, y * kPatchParts + x) < t)) return false;
  return true;
}

}  // namespace isocast::inline ISO_ISA
