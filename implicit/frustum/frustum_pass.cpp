#include <isocast/implicit/frustum/collocation.h>
#include <isocast/implicit/frustum/depth_range.h>
#include <isocast/implicit/frustum/frustum_pass.h>
#include <isocast/implicit/register_memory.h>
#include <isocast/render/camera.h>

#include <cmath>

namespace isocast {
namespace {

// The degree in u and v that follows f over a block closely enough.
int degree_across(int degree) { return std::min(degree, 12); }

double* scratch_of(std::size_t count) {
  thread_local std::vector<double> memory;
  memory.resize(std::max(memory.size(), count + 8));
  const auto address = reinterpret_cast<std::uintptr_t>(memory.data());
  return memory.data() + (64 - address % 64) % 64 / sizeof(double);
}

// Roots of tiles become hits.
struct Receiver {
  const PixelLines& lines;
  const FrustumOptions& options;
  BlockHits& hits;
  double u0, v0, offset_u, offset_v;

  void take(int x, int y, const TileRoots& roots) const {
    HitStream& tile = hits.tile(x, y);
    for (int i = 0; i < kStreamSize; ++i) {
      tile.cost[i] += static_cast<std::uint32_t>(roots.steps[i]);
      if (!roots.hit[i]) {
        if (!roots.proved[i] && options.proves) tile.certificate[i] = Certificate::undecided;
        continue;
      }
      const int p = i / 16, l = i % 16;
      const double u = u0 + 16 * x + p % 4 * 4 + l % 4 + offset_u,
                   v = v0 + 16 * y + p / 4 * 4 + l / 4 + offset_v;
      double squared = 0;
      for (int a = 0; a < 3; ++a) {
        const double d = lines.d[a] + u * lines.d_u[a] + v * lines.d_v[a];
        squared += d * d;
      }
      const double length = std::sqrt(squared), t = roots.s[i] * length;
      if (!(t < tile.t[i])) continue;
      const double slack = 0x1p-50 * t;
      tile.t[i] = t;
      tile.t_lo[i] = std::max(0.0, roots.lo[i] * length - slack);
      tile.t_hi[i] = roots.hi[i] * length + slack;
      tile.iso[i] = roots.iso[i];
      tile.sides[i] = roots.sides[i];
      tile.object[i] = options.object;
      tile.certificate[i] = !options.proves   ? Certificate::no_proof
                            : roots.proved[i] ? Certificate::proved_hit
                                              : Certificate::undecided;
    }
  }
};

}  // namespace

FrustumPass::FrustumPass(const Tape& tape, const Box& domain, const FrustumOptions& options, double steepest,
                         const View& view)
    : tape_(tape),
      domain_(domain),
      options_(options),
      steepest_(steepest),
      lines_(view.lines()),
      across_(degree_across(options.degree), options.degree),
      along_(options.degree, options.degree) {}

void FrustumPass::first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                             TraceCounts& counts) const {
  FrustumQuery query = {};
  query.u0 = bx * kBlockPixels, query.v0 = by * kBlockPixels;
  const auto depths =
      depth_range(lines_, query.u0, query.u0 + kBlockPixels, query.v0, query.v0 + kBlockPixels, domain_);
  if (!depths) return;
  query.s0 = depths->near, query.s1 = depths->far;
  query.tape = tape_.view();
  query.time = options_.time;
  query.iso_count = static_cast<int>(options_.iso.size());
  std::copy(options_.iso.begin(), options_.iso.end(), query.iso);
  query.degree = options_.degree;
  query.across = across_.view(), query.along = along_.view();
  const Collocation& checks = collocation(options_.degree);
  query.check_points = options_.proves ? checks.points.data() : nullptr;
  query.lebesgue = checks.lebesgue;
  double reach = 0;
  for (int a = 0; a < 3; ++a) {
    query.lo[a] = domain_.lo[a], query.hi[a] = domain_.hi[a];
    reach = std::max(reach, std::abs(lines_.o[a]) + std::max(std::abs(query.lo[a]), std::abs(query.hi[a])));
  }
  query.slack = 0x1p-48 * reach * steepest_;
  query.finder = options_.finder;
  query.redo = options_.precision == FrustumPrecision::mixed;
  query.lines = lines_;
  query.offset_u = offset_u, query.offset_v = offset_v;
  const int n = query.across.degree;
  for (int x = 0; x < 16; ++x) {
    double u[kMostFormDegree + 1], v[kMostFormDegree + 1];
    bernstein_values(n, (x + offset_u) / 16, u);
    bernstein_values(n, (x + offset_v) / 16, v);
    for (int i = 0; i <= n; ++i) query.weights_u[i][x] = u[i], query.weights_v[i][x] = v[i];
  }

  const FrustumKernels& kernels = frustum_kernels(options_.isa);
  const Receiver receiver{lines_, options_, hits, query.u0, query.v0, offset_u, offset_v};
  FrustumCounts work;
  kernels.solve_block[static_cast<int>(options_.precision)](
      query, scratch_of(frustum_scratch(query)), registers_of(tape_.registers * kernels.register_bytes), work,
      const_cast<Receiver*>(&receiver), [](void* context, int x, int y, const TileRoots& roots) {
        static_cast<const Receiver*>(context)->take(x, y, roots);
      });
  counts.evaluations += work.evaluations;
  counts.solves += work.solves;
}

}  // namespace isocast
