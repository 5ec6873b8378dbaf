// A block of the picture as beam kernels see it: the rays through its pixels, and what was found on them.
#pragma once

#include <isocast/isa/std.h>

namespace isocast {

/// Pixels per side of a block, and the block's in all.
inline constexpr int kBlockSide = 128, kBlockPixels = kBlockSide * kBlockSide;
/// Packets of 4x4 pixels.
inline constexpr int kPacketSide = 4;

/// Place of pixel (x, y) of a block among its pixels: tile by tile, in each packet by packet, so that a tile
/// is a stream and a packet sixteen slots in a row.
constexpr int pixel_slot(unsigned x, unsigned y) {
  return static_cast<int>((y / 16 * (kBlockSide / 16) + x / 16) * 256 + (y % 16 / 4 * 4 + x % 16 / 4) * 16 +
                          y % 4 * 4 + x % 4);
}

constexpr int slot_x(int slot) {
  return slot / 256 % (kBlockSide / 16) * 16 + slot % 256 / 16 % 4 * 4 + slot % 4;
}
constexpr int slot_y(int slot) {
  return slot / 256 / (kBlockSide / 16) * 16 + slot % 256 / 64 * 4 + slot % 16 / 4;
}

/// The points start + u start_u + v start_v + t (span + u span_u + v span_v) of the rays through the pixels:
/// u and v are pixels from the block's middle, -63.5 to 63.5; t is the depth along the camera's axis, from
/// the plane where the domain begins. Every true point lies within slack + |t| spread of it, axis by axis.
///
/// box_lo, box_hi  the domain, and how far it may be off
/// most_depth      the domain ends before it
/// before          -t where rays begin
/// pixel           a pixel's width at t = 0 in units of t, and what it gains with t, nearly
/// eps             brackets of roots this long, in t, are short enough
/// least           parts of a ray this short cannot be divided
/// columns, rows   pixels that are in the picture, from the upper left
/// exact           the span in double, for distances along rays: |span| is the distance for a depth of one
/// depth           t = 0 in depth from the camera
template <class T> struct BlockRays {
  T start[3], start_u[3], start_v[3], span[3], span_u[3], span_v[3], slack[3], spread[3];
  T box_lo[3], box_hi[3], box_slack[3];
  T most_depth, before, eps, least, pixel, pixel_spread;
  int columns, rows;
  double exact[3], exact_u[3], exact_v[3], depth;
};

/// A part of the depths of a beam.
template <class T> struct DepthRange {
  T from, to;
  [[nodiscard]] constexpr T length() const { return to - from; }
};

/// Pixels [x, x + size) x [y, y + size) and a part of their depth that may hold roots.
///
/// now      that part, counted from the plane at + u along_u + v along_v, where u and v are pixels from the
///          beam's middle
/// window   the roots that are sought lie in this part of the depth, counted from 0
/// slanted  the plane is where a crossing was found, and `now` holds what is in the window of it on every
///          ray; else the plane is 0, and `now` the window
/// inside   the window lies in the domain
/// whole    to be looked at as it is, before it is quartered
template <class T> struct BeamNode {
  int x, y, size;
  bool slanted, inside, whole;
  T at, along_u, along_v;
  DepthRange<T> now, window;
};

/// A part of one ray that is to be searched for its first root; `inside`: it lies in the domain.
template <class T> struct RayPiece {
  std::int16_t x, y;
  bool inside;
  T from, to;
};
inline constexpr int kMostPieces = 2048;

/// Nodes that wait at once: sixty-four for each of the levels of halving and of quartering that there can be.
inline constexpr int kMostNodes = 4096;

/// What beams found, in slots of pixels; depths as t of BlockRays.
///
/// lo, hi    a root lies between, and no root of which all is known lies before lo; lo = +inf: none was
///           found, -inf: the pixel is not in the picture
/// t, slope  the best guess at it, and df/dt there
/// side      i + 1 where f rises through iso-value i, -i - 1 where it falls
/// unclear   nothing is known of roots from this depth on; +inf: there is no such depth
template <class T> struct alignas(64) PixelRoots {
  T lo[kBlockPixels], hi[kBlockPixels], t[kBlockPixels], slope[kBlockPixels], side[kBlockPixels],
      unclear[kBlockPixels];
};
/// With what it took to find them, and room for the search.
///
/// unwanted  becomes true, atomically, when nobody wants the block any more: a search may then leave the
///           rest as it is; null: it never does
template <class T> struct alignas(64) BlockRoots : PixelRoots<T> {
  std::int64_t evaluations;
  const bool* unwanted = nullptr;
  BeamNode<T> stack[kMostNodes];
  RayPiece<T> pieces[kMostPieces];

  [[nodiscard]] bool is_unwanted() const { return unwanted && __atomic_load_n(unwanted, __ATOMIC_RELAXED); }
};

/// Levels below pixels that beams may be cast to, and how many cells these make of a pixel.
inline constexpr int kMostFiner = 2, kFinestCells = 1 << 2 * kMostFiner;

/// A level of a quadtree over a block: cells of `size` by `size` of the finest ones, which lie `finer` levels
/// below pixels.
struct CastLevel {
  int level, size, finer;

  /// The one that casting begins with: adaptive, one cell; else all of the finest.
  [[nodiscard]] static constexpr CastLevel first(bool adaptive, int finer) {
    return {0, adaptive ? kBlockSide << finer : 1, finer};
  }
  [[nodiscard]] constexpr CastLevel next() const { return {level + 1, size / 2, finer}; }
  /// Cells side by side over so many pixels.
  [[nodiscard]] constexpr int across(int pixels) const { return ((pixels << finer) + size - 1) / size; }
};
/// A cell: its upper left corner in cells of the finest level, and the depth that it begins at.
template <class T> struct BeamCell {
  std::int16_t x, y;
  T from;
};

/// Cells of one level, in structure of arrays.
template <class T> struct BeamCells {
  static constexpr int kMost = kBlockPixels << 2 * kMostFiner;
  int count = 0;
  std::int16_t x[kMost], y[kMost];
  T from[kMost];
};
/// What casting left of the finest cells, `finer` levels below pixels: between `from` and `to` roots may be;
/// from is +inf where nothing is left.
template <class T> struct FinestCells {
  const BeamCells<T>* cells;
  const T* to;
  int finer;
};
/// A level and the next one, and of each pixel:
///
/// level    that at which the last of its beams was thrown away
/// covered  the finest cells of which something is left
/// proved   those of them that hold a crossing on every ray for sure, or all where all are covered
/// (prove_cells)
///
/// last, finer  the level that casting ended with, and how many it lies below pixels
/// evaluations  that proving took
template <class T> struct alignas(64) BlockCells {
  BeamCells<T> buffer[2];
  std::uint8_t level[kBlockPixels], covered[kBlockPixels], proved[kBlockPixels];
  int last = 0, finer = 0;
  std::int64_t evaluations = 0;

  [[nodiscard]] FinestCells<T> finest() const {
    return {&buffer[last % 2], buffer[1 - last % 2].from, finer};
  }
};

}  // namespace isocast
