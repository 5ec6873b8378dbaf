// How far the masks let rays leap.
#pragma once

#include <isocast/volume/stream/lane_bits.h>
#include <isocast/volume/stream/march_field.h>

namespace isocast::inline ISO_ISA {

/// Edges in cells of what the masks know to be empty: a node of a sparse grid, a brick, a block.
inline constexpr double kNode = 128, kBrick = kBrickSize, kBlock = 4;

/// The places of several cells: of their bricks in the field's map, of their blocks there, of the cells in
/// these (brick_mask.h).
template <Real R> struct CellPlaces { R brick[3], block, bit; };

/// The edge of the largest cube around a cell that holds no active cell; 0 if the cell is one.
inline double empty_cube(const MarchField& field, const std::int32_t (&at)[3], int block, int bit) {
  const FoundBrick brick = find_brick(field.bricks, at);
  if (brick.number == kNoBrick) return brick.node ? kNode : kBrick;
  const BrickMask& mask = mask_of_all(field, brick.number, at);
  if (!(mask.blocks >> block & 1)) return mask.blocks ? kBlock : kBrick;
  return mask.cells[block] >> bit & 1 ? 0 : 1;
}

/// The same for the lanes of `asked`, one at a time; 1 in the others.
template <Real R>
R empty_cubes_by_lanes(const MarchField& field, const CellPlaces<R>& places, unsigned asked) {
  double brick[3][kWidth<R>], block[kWidth<R>], bit[kWidth<R>], size[kWidth<R>];
  for (int a = 0; a < 3; ++a) store(brick[a], places.brick[a]);
  store(block, places.block);
  store(bit, places.bit);
  for (int l = 0; l < kWidth<R>; ++l) {
    const std::int32_t at[3] = {std::int32_t(brick[0][l]), std::int32_t(brick[1][l]),
                                std::int32_t(brick[2][l])};
    size[l] = asked >> l & 1 ? empty_cube(field, at, int(block[l]), int(bit[l])) : 1;
  }
  return load<R>(size);
}

template <Real R> R empty_cubes(const MarchField& field, const CellPlaces<R>& places, unsigned asked) {
  return empty_cubes_by_lanes(field, places, asked);
}

#ifdef __AVX512DQ__
/// The words at `from` + kScale * at, in bytes; 0 in the other lanes.
template <int kScale> inline __m512i gather_words(__mmask8 lanes, __m512i at, const void* from = nullptr) {
  return _mm512_mask_i64gather_epi64(_mm512_setzero_si512(), lanes, at, from, kScale);
}

/// All lanes together, where all bricks are there and their masks are made. (Eight aligned bytes are read at
/// once, and what they point to is not older.)
template <>
inline Pack<double, 8> empty_cubes(const MarchField& field, const CellPlaces<Pack<double, 8>>& places,
                                   unsigned asked) {
  using R = Pack<double, 8>;
  const auto whole = [](R v) { return _mm512_maskz_cvttpd_epi64(0xff, v.v); };
  if (field.bricks.nodes) return empty_cubes_by_lanes(field, places, asked);
  const std::int32_t(&dims)[3] = field.bricks.dims;
  const __m512i brick = whole((places.brick[2] * R(double(dims[1])) + places.brick[1]) * R(double(dims[0])) +
                              places.brick[0]),
                block = whole(places.block), bit = whole(places.bit), one = _mm512_set1_epi64(1);
  const auto lanes = __mmask8(asked);
  const __m512i mask = gather_words<8>(lanes, brick, field.all);
  if (_mm512_mask_testn_epi64_mask(lanes, mask, mask)) return empty_cubes_by_lanes(field, places, asked);
  const __m512i blocks = gather_words<1>(lanes, mask);
  const __mmask8 any = _mm512_mask_test_epi64_mask(lanes, blocks, blocks),
                 in_block =
                     _mm512_mask_test_epi64_mask(lanes, _mm512_maskz_srlv_epi64(0xff, blocks, block), one);
  const __m512i word = _mm512_maskz_add_epi64(0xff, _mm512_maskz_slli_epi64(0xff, block, 3),
                                              _mm512_set1_epi64(offsetof(BrickMask, cells))),
                cells = gather_words<1>(in_block, _mm512_maskz_add_epi64(0xff, mask, word));
  const __mmask8 active =
      _mm512_mask_test_epi64_mask(in_block, _mm512_maskz_srlv_epi64(0xff, cells, bit), one);
  R edge = select(PackMask<double, 8>(any), R(kBlock), R(kBrick));
  edge = select(PackMask<double, 8>(in_block), R(1), edge);
  return select(PackMask<double, 8>(active), R(0), edge);
}
#endif

}  // namespace isocast::inline ISO_ISA
