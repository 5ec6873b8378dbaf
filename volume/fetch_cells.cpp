#include <isocast/volume/fetch_cells.h>
#include <isocast/volume/visit_grid.h>

#include <bit>

namespace isocast {
namespace {

template <class T, class Grid>
FetchedLanes fetch(const VolumeQuery& query, int iso, const std::int32_t* const (&cells)[3],
                   std::uint32_t lanes, T (*f)[kPacketSize]) {
  const Grid grid(query);
  const auto value = query.iso[iso];
  const bool proves = query.proves;
  typename Grid::Place place;
  FetchedLanes fetched;
  for (; lanes; lanes &= lanes - 1) {
    const int l = std::countr_zero(lanes);
    const std::int32_t cell[3] = {cells[0][l], cells[1][l], cells[2][l]};
    typename Grid::Sample raw[8];
    grid.enter(cell, place);
    grid.load_corners(cell, place, raw);
    T finite = 0;
    for (int k = 0; k < 8; ++k) {
      // as fetch_one (trace.h)
      const T corner = proves ? T(corner_value<double>(raw[k], value)) : corner_value<T>(raw[k], value);
      f[k][l] = corner;
      finite += corner * T(0);
    }
    if (finite == T(0)) {
      fetched.exists |= 1u << l;
      continue;
    }
    if (!proves) continue;
    double exists = 0;
    for (const auto& sample : raw) exists += double(number(sample)) * 0.0;
    if (exists == 0) fetched.doubtful |= 1u << l;
  }
  return fetched;
}

template <class T>
FetchedLanes fetch_any(const VolumeQuery& query, int iso, const std::int32_t* const (&cells)[3],
                       std::uint32_t lanes, T (*f)[kPacketSize]) {
  return visit_grid(query,
                    [&]<class Grid>(GridTag<Grid>) { return fetch<T, Grid>(query, iso, cells, lanes, f); });
}

}  // namespace

void prefetch_block(const VolumeQuery& query, const std::int32_t (&first)[3]) {
  if (query.sparse) return;
  constexpr int kSamples = 5;
  const GridView& grid = query.grid;
  const std::size_t bytes = size_of(grid.type), row = bytes * std::size_t(grid.dims[0]),
                    slice = row * std::size_t(grid.dims[1]);
  const auto* corner = static_cast<const std::byte*>(grid.samples) + std::size_t(first[2]) * slice +
                       std::size_t(first[1]) * row + bytes * std::size_t(first[0]);
  for (int z = 0; z < kSamples && first[2] + z < grid.dims[2]; ++z)
    for (int y = 0; y < kSamples && first[1] + y < grid.dims[1]; ++y)
      __builtin_prefetch(corner + std::size_t(z) * slice + std::size_t(y) * row);
}

FetchedLanes fetch_cells(const VolumeQuery& query, int iso, const std::int32_t* const (&cells)[3],
                         std::uint32_t lanes, float (*f)[kPacketSize]) {
  return fetch_any(query, iso, cells, lanes, f);
}
FetchedLanes fetch_cells(const VolumeQuery& query, int iso, const std::int32_t* const (&cells)[3],
                         std::uint32_t lanes, double (*f)[kPacketSize]) {
  return fetch_any(query, iso, cells, lanes, f);
}

}  // namespace isocast
