#include <isocast/volume/dense_grid.h>
#include <isocast/volume/primary/kernels.h>

namespace isocast {
namespace {

template <class T, class S>
void fetch(const VolumeQuery& query, int iso, const std::int32_t (*cells)[3], int count, T (*f)[8],
           FetchedCell* states) {
  const DenseGrid<S> grid(query);
  for (int i = 0; i < count; ++i) {
    S raw[8];
    grid.load_corners(cells[i], {}, raw);
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
    for (const S& sample : raw) exists += double(number(sample)) * 0.0;
    if (exists == 0) states[i] = FetchedCell::doubtful;
  }
}

}  // namespace

void fetch_cells(const VolumeQuery& query, int iso, const std::int32_t (*cells)[3], int count, float (*f)[8],
                 FetchedCell* states) {
  visit_sample_type(query.grid.type,
                    [&]<class S>(SampleTag<S>) { fetch<float, S>(query, iso, cells, count, f, states); });
}
void fetch_cells(const VolumeQuery& query, int iso, const std::int32_t (*cells)[3], int count, double (*f)[8],
                 FetchedCell* states) {
  visit_sample_type(query.grid.type,
                    [&]<class S>(SampleTag<S>) { fetch<double, S>(query, iso, cells, count, f, states); });
}

}  // namespace isocast
