// Ganacim, Figueiredo and Nehab: Beam casting implicit surfaces on the GPU with interval arithmetic, 2011:
// tables 1 and 2, and the claims.
#include <fmt/format.h>
#include <isocast/apps/bench/claims.h>
#include <isocast/apps/bench/paper_rows.h>
#include <isocast/apps/bench/papers_ganacim_tables.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/implicit_surface.h>
#include <isocast/render/camera.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace isocast::bench {
namespace {

// One picture by a method. `early`: the share of pixels whose beams were thrown away before the last level.
struct Cast {
  double seconds = 0, evaluations = 0, painted = 0, early = 0;
};
struct WayToCast {
  const char *method, *form;
  int finer;
};
// Uniform and adaptive, with one sample and with four; adaptive by affine forms.
constexpr WayToCast kWays[] = {{"beam-uniform", "interval", 0},
                               {"beam-adaptive", "interval", 0},
                               {"beam-uniform", "interval", 1},
                               {"beam-adaptive", "interval", 1},
                               {"beam-adaptive", "affine", 0}};
using Casts = std::array<Cast, std::size(kWays)>;

Cast cast_picture(const Surface& surface, const View& view, BlockHits& hits) {
  constexpr int kSide = kBlockTiles * kTileSize;
  constexpr std::uint32_t kLast = 7;
  const auto pass = surface.primary(view);
  TraceCounts counts;
  Cast cast;
  for (int by = 0; by * kSide < view.height(); ++by)
    for (int bx = 0; bx * kSide < view.width(); ++bx) {
      hits.reset(true);
      pass->first_hits(bx, by, 0.5, 0.5, hits, counts);
      for (int tile = 0; tile < kBlockStreams; ++tile) {
        if (!hits.is_open(tile % kBlockTiles, tile / kBlockTiles)) continue;
        const HitStream& found = hits.tile(tile % kBlockTiles, tile / kBlockTiles);
        for (int i = 0; i < kStreamSize; ++i) {
          cast.painted += is_hit(found, i);
          cast.early += !is_hit(found, i) && found.cost[i] < kLast;
        }
      }
    }
  cast.evaluations = static_cast<double>(counts.evaluations);
  return cast;
}

Casts cast_surface(std::string_view id, int size, const Repetitions& repetitions) {
  const CatalogueSurface& found = require_surface(id);
  std::vector<std::unique_ptr<ImplicitSurface>> surfaces;
  for (const WayToCast& way : kWays) {
    ImplicitSurfaceOptions options;
    options.method =
        choose_formula_method(way.method, {{"form", way.form}, {"depth", std::to_string(way.finer)}});
    surfaces.push_back(std::make_unique<ImplicitSurface>(surface_expression(found), found.domain, options));
  }
  const View view(frame(surfaces[0]->bounds(), {}, 1), size, size);
  const auto hits = std::make_unique<BlockHits>();
  Casts casts;
  std::vector<std::function<void()>> runs;
  for (std::size_t i = 0; i < casts.size(); ++i)
    runs.push_back([&, i] { casts[i] = cast_picture(*surfaces[i], view, *hits); });
  const std::vector<Timing> timings = time_interleaved(runs, repetitions, Clock::thread);
  for (std::size_t i = 0; i < casts.size(); ++i) casts[i].seconds = timings[i].seconds;
  return casts;
}

// A surface of the tables at both sizes.
struct SurfaceRun {
  const SurfaceOfGanacim& surface;
  Casts at_512, at_1024;
};

double time_gain(const Casts& c, int sample) { return c[sample].seconds / c[sample + 1].seconds; }
double work_gain(const Casts& c, int sample) { return c[sample].evaluations / c[sample + 1].evaluations; }

PaperTable table_of(const std::vector<SurfaceRun>& runs, const char* id, int size, bool large) {
  PaperTable table{id,
                   fmt::format("Adaptive over uniform, {} x {}", size, size),
                   {"surface", "paper: 1 sample", "4 samples", "here, time: 1 sample", "4 samples",
                    "here, evaluations: 1 sample", "4 samples"},
                   {}};
  for (const SurfaceRun& run : runs) {
    const FramesOfGanacim& paper = large ? run.surface.at_1024 : run.surface.at_512;
    const Casts& casts = large ? run.at_1024 : run.at_512;
    std::vector<std::string> line = {std::string(run.surface.name)};
    for (const double x :
         {paper.adaptive / paper.uniform, paper.adaptive_of_four / paper.uniform_of_four, time_gain(casts, 0),
          time_gain(casts, 2), work_gain(casts, 0), work_gain(casts, 2)})
      line.push_back(table_number(x));
    table.rows.push_back(line);
  }
  return table;
}

std::vector<Claim> claims_of(const std::vector<SurfaceRun>& runs) {
  std::vector<double> times, against_paper, growth, agree, complex, early, affine;
  double sphere = 0, blob = 0;
  for (const SurfaceRun& run : runs)
    if (run.surface.id == "sphere") sphere = run.at_1024[1].evaluations;
  for (const SurfaceRun& run : runs) {
    for (const auto& [casts, paper] :
         {std::pair{&run.at_512, &run.surface.at_512}, std::pair{&run.at_1024, &run.surface.at_1024}}) {
      times.push_back(time_gain(*casts, 0)), times.push_back(time_gain(*casts, 2));
      against_paper.push_back(work_gain(*casts, 0) / (paper->adaptive / paper->uniform));
      against_paper.push_back(work_gain(*casts, 2) / (paper->adaptive_of_four / paper->uniform_of_four));
      growth.push_back(work_gain(*casts, 2) / work_gain(*casts, 0));
      agree.push_back(std::abs((*casts)[1].painted / (*casts)[0].painted - 1));
    }
    growth.push_back(work_gain(run.at_1024, 0) / work_gain(run.at_512, 0));
    early.push_back(run.at_1024[1].early / (run.at_1024[1].early + run.at_1024[1].painted));
    const std::string_view id = run.surface.id;
    if (id == "klein_bottle" || id == "mitchell" || id == "tangle")
      complex.push_back(run.at_1024[1].evaluations / sphere);
    if (id == "klein_bottle" || id == "mitchell" || id == "barth_sextic")
      affine.push_back(run.at_1024[1].seconds / run.at_1024[4].seconds);
    if (id == "blinn_blob4") blob = run.at_1024[1].painted;
  }
  return {
      measured("R-GAN-1", "Adaptive is faster than uniform on every surface",
               "uniform's time over adaptive's", {1}, times),
      measured("R-GAN-1", "By 1.16 to 2.85 times", "our ratio of evaluations over the paper's of times",
               {0.9}, against_paper),
      measured("R-GAN-2", "The gain grows with resolution and with samples",
               "gain over that of half the resolution, of one sample", {0.97}, growth),
      untested("R-GAN-3", "A cell painted as background holds no surface point",
               "the unit test beam_cast samples them densely"),
      measured("R-GAN-4", "Adaptive and uniform paint the same", "their share of pixels that differs",
               {0, 0.01}, agree),
      later("R-GAN-5", "Four samples by one more level refine edges and depth",
            "needs colours of parts of pixels"),
      measured("R-GAN-6", "Complex expressions are slower",
               "evaluations over the sphere's: Klein, Mitchell, tangle", {1.5}, complex),
      measured("R-GAN-7", "Boxes far from the surface are thrown away at coarse levels",
               "share of pixels that are, of those and the painted ones", {0.1}, early),
      measured("R-GAN-8", "Works for functions that are not algebraic", "pixels of the blob", {1}, {blob}),
      measured("R-GAN-9", "Affine forms should reduce the overestimation of slanted beams",
               "time by intervals over that by affine forms: Klein, Mitchell, Barth", {1.5}, affine)};
}

}  // namespace

Paper ganacim_paper(const PaperWishes& wishes) {
  // a quarter of the sizes where few pictures are wanted
  const int small = wishes.quick ? 128 : 512;
  const Repetitions repetitions = wishes.quick ? Repetitions(1) : Repetitions(2, 9, 2);
  std::vector<SurfaceRun> runs;
  for (const SurfaceOfGanacim& surface : kGanacimSurfaces)
    if (surface.quick || !wishes.quick)
      runs.push_back({surface, cast_surface(surface.id, small, repetitions),
                      cast_surface(surface.id, 2 * small, repetitions)});
  return {kGanacimSource,
          {std::begin(kGanacimNotes), std::end(kGanacimNotes)},
          {table_of(runs, "T-GAN-1", small, false), table_of(runs, "T-GAN-2", 2 * small, true)},
          claims_of(runs),
          {}};
}

}  // namespace isocast::bench
