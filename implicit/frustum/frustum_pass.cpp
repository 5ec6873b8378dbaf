#include <isocast/implicit/frustum/collocation.h>
#include <isocast/implicit/frustum/depth_range.h>
#include <isocast/implicit/frustum/frustum_pass.h>
#include <isocast/implicit/frustum/padua.h>
#include <isocast/implicit/frustum/rounding_bound.h>
#include <isocast/implicit/open_rays.h>
#include <isocast/implicit/register_memory.h>
#include <isocast/ray/tile_slot.h>
#include <isocast/render/camera.h>

#include <bit>
#include <cmath>

namespace isocast {
namespace {

// Pixels that the domain is across, about.
double pixels_across(const PixelLines& lines, const Box& domain) {
  Double3 middle = domain.center(), o, d;
  double square_o = 0, square_d = 0;
  for (int a = 0; a < 3; ++a) {
    o[a] = lines.o_u[a], d[a] = lines.d_u[a];
    square_o += lines.o_u[a] * lines.o_u[a], square_d += lines.d_u[a] * lines.d_u[a];
    middle[a] -= lines.o[a];
  }
  const double pixel = std::sqrt(square_o) + std::sqrt(square_d) * length(middle);
  return domain.diagonal() / pixel;
}

double* scratch_of(std::size_t count) {
  thread_local std::vector<double> memory;
  memory.resize(std::max(memory.size(), count + 8));
  const auto address = reinterpret_cast<std::uintptr_t>(memory.data());
  return memory.data() + (64 - address % 64) % 64 / sizeof(double);
}

// Chebyshev's polynomials at the pixels of a tile, and their slopes per pixel.
using Weights = double[kMostFormDegree + 1][16];
void fill_weights(int degree, double offset, Weights& weights, Weights& slopes) {
  for (int x = 0; x < 16; ++x) {
    double values[kMostFormDegree + 1], slope[kMostFormDegree + 1];
    chebyshev_values(degree, (x + offset) / 8 - 1, values, slope);
    for (int i = 0; i <= degree; ++i) weights[i][x] = values[i], slopes[i][x] = slope[i] / 8;
  }
}

// A box that holds all points of a block.
Box box_of(const FrustumQuery& query) {
  const double pixels = 16 * query.tiles;
  Box box;
  for (int corner = 0; corner < 8; ++corner) {
    const double u = query.u0 + (corner & 1 ? pixels : 0), v = query.v0 + (corner & 2 ? pixels : 0),
                 s = corner & 4 ? query.s1 : query.s0;
    Double3 p;
    for (int a = 0; a < 3; ++a) {
      const PixelLines& l = query.lines;
      p[a] = l.o[a] + u * l.o_u[a] + v * l.o_v[a] + s * (l.d[a] + u * l.d_u[a] + v * l.d_v[a]);
    }
    box.add(p);
  }
  const double room = 1e-9 * box.diagonal();
  for (int a = 0; a < 3; ++a) box.lo[a] -= room, box.hi[a] += room;
  return box;
}

// Roots of tiles become hits; rays that are doubtful are gathered, where somebody solves them.
struct Receiver {
  const View& view;
  const FrustumOptions& options;
  int bx, by;            // the block
  int first_x, first_y;  // tile of it that the form begins with
  double offset_u, offset_v;
  double longest;
  OpenRays* open;
  BlockHits& hits;
  TraceCounts& counts;

  // Those of a tile, counted in the form.
  void take(int column, int row, const TileRoots& roots) const {
    HitStream& tile = hits.tile(first_x + column, first_y + row);
    const int tx = bx * kBlockTiles + first_x + column, ty = by * kBlockTiles + first_y + row;
    const int columns = std::min(kTileSize, view.width() - tx * kTileSize),
              rows = std::min(kTileSize, view.height() - ty * kTileSize);
    if (columns <= 0 || rows <= 0) return;
    if (open) open->begin(view, tx, ty, offset_u, offset_v, tile);
    const std::uint32_t inside = (1u << columns) - 1;
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < 16; ++x)
        tile.cost[tile_slot(x, y)] += static_cast<std::uint32_t>(roots.steps[y][x]);
      for (std::uint32_t left_over = (roots.hit[y] | ~roots.proved[y]) & inside; left_over != 0;
           left_over &= left_over - 1)
        take_ray(std::countr_zero(left_over), y, roots, tile);
    }
  }

 private:
  void take_ray(int x, int y, const TileRoots& roots, HitStream& tile) const {
    const int i = tile_slot(x, y);
    const bool proved = roots.proved[y] >> x & 1, hit = roots.hit[y] >> x & 1;
    if (open && !proved) return open->add(i, 0, counts);
    if (!hit) {
      if (options.proves) tile.certificate[i] = Certificate::undecided;
      return;
    }
    const double length = roots.length[y][x], t = roots.s[y][x] * length;
    if (!(t < tile.t[i])) return;
    if (open && (roots.hi[y][x] - roots.lo[y][x]) * length > longest) return open->add(i, 0, counts);
    const double slack = 0x1p-50 * t;
    tile.t[i] = t;
    tile.t_lo[i] = std::max(0.0, roots.lo[y][x] * length - slack);
    tile.t_hi[i] = roots.hi[y][x] * length + slack;
    if (options.normals) tile.s[i] = roots.normal[0][y][x], tile.s_hi[i] = roots.normal[1][y][x];
    tile.iso[i] = roots.iso[y][x];
    tile.sides[i] = roots.sides[y][x];
    tile.object[i] = options.object;
    tile.certificate[i] = !options.proves ? Certificate::no_proof
                          : proved        ? Certificate::proved_hit
                                          : Certificate::undecided;
  }
};

}  // namespace

int FrustumPass::tiles_of_form(const PixelLines& lines, const Box& domain, int degree) {
  // high powers grow fast outside the domain: the less of that a form holds, the more digits are left
  const double most = pixels_across(lines, domain) / (degree <= 6 ? 7 : 14);
  int tiles = kBlockTiles;
  while (tiles > 0 && 16 * tiles > most) tiles /= 2;
  return tiles;
}

FrustumPass::FrustumPass(const Tape& tape, const Box& domain, const FrustumOptions& options, const View& view,
                         const DoubtfulRays& doubtful)
    : tape_(tape),
      domain_(domain),
      options_(options),
      view_(view),
      doubtful_(doubtful),
      lines_(view.lines()),
      tiles_(tiles_of_form(lines_, domain, options.degree)) {
  double reach = 0;
  for (int a = 0; a < 3; ++a)
    reach = std::max(reach, std::abs(lines_.o[a]) + std::max(std::abs(domain.lo[a]), std::abs(domain.hi[a])));
  position_slack_ = 0x1p-48 * reach;
  slack_ = rounding_bound(tape, domain, options.time, position_slack_);
}

FrustumQuery FrustumPass::make_query(double offset_u, double offset_v) const {
  FrustumQuery query = {};
  query.tape = tape_.view();
  query.time = options_.time;
  query.iso_count = static_cast<int>(options_.iso.size());
  std::copy(options_.iso.begin(), options_.iso.end(), query.iso);
  query.tiles = tiles_;
  const Padua& across = padua(options_.degree);
  query.across = {across.columns.data(),
                  across.rows.data(),
                  across.from_columns.data(),
                  across.from_rows.data(),
                  {chebyshev_half(0).data(), chebyshev_half(1).data()},
                  across.lebesgue};
  query.along = collocation(options_.degree).view();
  for (int a = 0; a < 3; ++a) query.lo[a] = domain_.lo[a], query.hi[a] = domain_.hi[a];
  query.proves = options_.proves;
  if (options_.proves) query.slack = slack_;
  query.finder = options_.finder;
  query.redo = options_.precision == FrustumPrecision::mixed;
  query.lines = lines_;
  query.offset_u = offset_u, query.offset_v = offset_v;
  query.normals = options_.normals;
  fill_weights(options_.degree, offset_u, query.weights_u, query.slopes_u);
  fill_weights(options_.degree, offset_v, query.weights_v, query.slopes_v);
  return query;
}

void FrustumPass::first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                             TraceCounts& counts) const {
  FrustumQuery query = make_query(offset_u, offset_v);
  const FrustumKernels& kernels = frustum_kernels(options_.isa);
  FrustumCounts work;
  OpenRays* const open = doubtful_.surface ? &OpenRays::of_thread(*doubtful_.surface) : nullptr;
  for (int y = 0; y < kBlockTiles; y += tiles_)
    for (int x = 0; x < kBlockTiles; x += tiles_) {
      if (hits.unwanted()) return;
      const double pixels = 16 * tiles_;
      query.u0 = 16 * (bx * kBlockTiles + x), query.v0 = 16 * (by * kBlockTiles + y);
      const auto depths =
          depth_range(lines_, query.u0, query.u0 + pixels, query.v0, query.v0 + pixels, domain_);
      if (!depths) continue;
      query.s0 = depths->near, query.s1 = depths->far;
      if (options_.proves)
        query.rounding = rounding_bound(tape_, box_of(query), options_.time, position_slack_);
      Receiver receiver{view_,    options_,          bx,   by,   x,     y, offset_u,
                        offset_v, doubtful_.longest, open, hits, counts};
      kernels.solve_block[static_cast<int>(options_.precision)](
          query, scratch_of(frustum_scratch(query)), registers_of(tape_.registers * kernels.register_bytes),
          work, &receiver, [](void* context, int tx, int ty, const TileRoots& roots) {
            static_cast<const Receiver*>(context)->take(tx, ty, roots);
          });
    }
  if (open) open->solve(counts);
  counts.evaluations += work.evaluations;
  counts.solves += work.solves;
}

}  // namespace isocast
