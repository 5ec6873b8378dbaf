#include <isocast/volume/fetch_cells.h>
#include <isocast/volume/visit_grid.h>

namespace isocast {
namespace {

template <class T, class Grid>
void fetch(const VolumeQuery& query, int iso, const std::int32_t (*cells)[3], int count, T (*f)[8],
           FetchedCell* states) {
  const Grid grid(query);
  typename Grid::Place place;
  for (int i = 0; i < count; ++i) {
    typename Grid::Sample raw[8];
    grid.enter(cells[i], place);
    grid.load_corners(cells[i], place, raw);
    T finite = 0;
    for (int k = 0; k < 8; ++k) {
      // as fetch_one (trace.h)
      f[i][k] = query.proves ? T(corner_value<double>(raw[k], query.iso[iso]))
                             : corner_value<T>(raw[k], query.iso[iso]);
      finite += f[i][k] * T(0);
    }
    states[i] = FetchedCell::exists;
    if (finite == T(0)) continue;
    states[i] = FetchedCell::none;
    if (!query.proves) continue;
    double exists = 0;
    for (const auto& sample : raw) exists += double(number(sample)) * 0.0;
    if (exists == 0) states[i] = FetchedCell::doubtful;
  }
}

template <class T>
void fetch_any(const VolumeQuery& query, int iso, const std::int32_t (*cells)[3], int count, T (*f)[8],
               FetchedCell* states) {
  visit_grid(query, [&]<class Grid>(GridTag<Grid>) { fetch<T, Grid>(query, iso, cells, count, f, states); });
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

void fetch_cells(const VolumeQuery& query, int iso, const std::int32_t (*cells)[3], int count, float (*f)[8],
                 FetchedCell* states) {
  fetch_any(query, iso, cells, count, f, states);
}
void fetch_cells(const VolumeQuery& query, int iso, const std::int32_t (*cells)[3], int count, double (*f)[8],
                 FetchedCell* states) {
  fetch_any(query, iso, cells, count, f, states);
}

}  // namespace isocast
