// A thread traces one ray of a volume: the walk and the intersectors of volume/, with packets of one.
#pragma once

#include <isocast/cuda/place.h>
#include <isocast/volume/dense_grid.h>
#include <isocast/volume/solve_one.h>
#include <isocast/volume/sparse_grid.h>
#include <isocast/volume/trace_stream.h>

namespace isocast::inline ISO_ISA {

/// What a kernel is given: trace_slots (volume/trace_stream.h) for every ray of `streams` streams. Pointers
/// are those of the memory that the kernel sees.
///
/// grid    of `query`, made on the host: a kernel's arguments can be indexed without a copy
/// counts  of all rays, added to
template <class T, class Grid> struct TraceVolume {
  VolumeQuery query;
  Grid grid;
  const RayStream* rays;
  HitStream* hits;
  TraceCounts* counts;
  std::int32_t streams;
  bool next;

  ISO_HD void operator()(const Place& place) const {
    const std::int64_t stream = place.number() / kStreamSize;
    const int slot = int(place.number() % kStreamSize);
    if (stream >= streams || slot >= rays[stream].size) return;
    TraceCounts mine;
    trace_slots<1, T>(query, grid, next, rays[stream], hits[stream], slot, mine);
    add_shared(counts->cells, mine.cells);
    add_shared(counts->macrocells, mine.macrocells);
    add_shared(counts->solves, mine.solves);
  }
};

}  // namespace isocast::inline ISO_ISA

// call(T, name, grid) for each kernel of a volume: its precision, and the type of its samples with the grid
// over it.
#define ISO_EACH_DENSE_GRID(call, T)                                                   \
  call(T, u8, DenseGrid<std::uint8_t>) call(T, i8, DenseGrid<std::int8_t>)             \
      call(T, u16, DenseGrid<std::uint16_t>) call(T, i16, DenseGrid<std::int16_t>)     \
          call(T, u32, DenseGrid<std::uint32_t>) call(T, i32, DenseGrid<std::int32_t>) \
              call(T, f16, DenseGrid<Half>) call(T, f32, DenseGrid<float>) call(T, f64, DenseGrid<double>)
#define ISO_EACH_SPARSE_GRID(call, T)                                                           \
  call(T, tree_f32, SparseGrid<float>) call(T, tree_f64, SparseGrid<double>)                    \
      call(T, tree_i16, SparseGrid<std::int16_t>) call(T, tree_i32, SparseGrid<std::int32_t>)   \
          call(T, tree_i64, SparseGrid<std::int64_t>) call(T, tree_fp4, SparseGrid<Coded<4>>)   \
              call(T, tree_fp8, SparseGrid<Coded<8>>) call(T, tree_fp16, SparseGrid<Coded<16>>) \
                  call(T, tree_fpn, SparseGrid<Coded<0>>)
