#include <isocast/volume/primary/kernels.h>
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
      // as fetch_cell (trace.h)
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

void fetch_cells(const VolumeQuery& query, int iso, const std::int32_t (*cells)[3], int count, float (*f)[8],
                 FetchedCell* states) {
  fetch_any(query, iso, cells, count, f, states);
}
void fetch_cells(const VolumeQuery& query, int iso, const std::int32_t (*cells)[3], int count, double (*f)[8],
                 FetchedCell* states) {
  fetch_any(query, iso, cells, count, f, states);
}

}  // namespace isocast
