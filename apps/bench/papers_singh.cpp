// Singh and Narayanan: Real-time ray tracing of implicit surfaces on the GPU, 2010: tables 1 to 3, Figure 9,
// and the claims.
#include <fmt/format.h>
#include <isocast/apps/bench/claims.h>
#include <isocast/apps/bench/log_axis.h>
#include <isocast/apps/bench/papers_singh_run.h>
#include <isocast/implicit/expression/catalogue.h>

#include <algorithm>
#include <cmath>

namespace isocast::bench {
namespace {

std::string text_of(double value) { return fmt::format("{}", value); }

PaperTable surface_table(const SinghRun& run) {
  PaperTable table{"T-SIN-1",
                   "Frames of 512 × 512 a second, without shadows; here " + std::string(name_of(run.wide())),
                   {"surface [order]", "step", "paper: sign", "Taylor", "sign over Taylor", "here: sign",
                    "Taylor", "sign over Taylor", "rays that fail: sign", "Taylor"},
                   {}};
  for (const SurfaceOfSingh& s : kSinghSurfaces) {
    const Row *const signs = run.row(s.id, sign_test(s.step)), *const taylors =
                                                                   run.row(s.id, taylor_test(s.step));
    if (!signs && !s.id.empty()) continue;
    const double ours[] = {run.frames(s.id, sign_test(s.step), run.wide()),
                           run.frames(s.id, taylor_test(s.step), run.wide())};
    std::vector<std::string> line = {std::string(s.name), text_of(s.step)};
    for (const double x : {s.sign, s.taylor, s.sign / s.taylor, ours[0], ours[1], ours[0] / ours[1]})
      line.push_back(table_number(x));
    for (const Row* const found : {signs, taylors}) line.push_back(found ? grouped(found->failures()) : "–");
    table.rows.push_back(line);
  }
  return table;
}

PaperTable pair_table(const SinghRun& run) {
  PaperTable table{"T-SIN-2",
                   "Frames of 1024 × 1024 a second; here " + std::string(name_of(run.wide())),
                   {"surface", "paper: KNO", "AMP sign", "ratio", "here: KNO, RAA", "AMP sign", "ratio",
                    "rays that fail: KNO", "AMP"},
                   {}};
  for (const PairOfSingh& s : kSinghPairs) {
    const Row *const theirs = run.row(s.id, knoll_test()), *const signs = run.row(s.id, sign_test(s.step));
    if (!theirs || !signs) continue;
    const double ours[] = {run.frames(s.id, knoll_test(), run.wide(), 1024),
                           run.frames(s.id, sign_test(s.step), run.wide(), 1024)};
    std::vector<std::string> line = {std::string(s.name)};
    for (const double x : {s.knoll, s.sign, s.sign / s.knoll, ours[0], ours[1], ours[1] / ours[0]})
      line.push_back(table_number(x));
    for (const Row* const found : {theirs, signs}) line.push_back(grouped(found->failures()));
    table.rows.push_back(line);
  }
  return table;
}

PaperTable frame_table(const SinghRun& run) {
  PaperTable table{"T-SIN-3",
                   "Milliseconds a frame of 512 × 512, sign test",
                   {"surface [order]", "paper: CPU", "280 GTX", "here: scalar",
                    std::string(name_of(run.wide())), "scalar over " + std::string(name_of(run.wide()))},
                   {}};
  for (const FrameOfSingh& f : kSinghFrames) {
    const auto found = std::ranges::find(kSinghSurfaces, f.id, &SurfaceOfSingh::id);
    const double scalar = 1e3 / run.frames(f.id, sign_test(found->step), Isa::scalar),
                 wide = 1e3 / run.frames(f.id, sign_test(found->step), run.wide());
    if (std::isnan(wide)) continue;
    std::vector<std::string> line = {std::string(f.name)};
    for (const double x : {f.cpu, f.gpu, scalar, wide, scalar / wide}) line.push_back(table_number(x));
    table.rows.push_back(line);
  }
  return table;
}

PaperTable figure_table(const SinghRun& run) {
  PaperTable table{
      "T-SIN-4",
      "Figure 9: frames of 512 × 512 a second, and rays that fail; here " + std::string(name_of(run.wide())),
      {"setting", "paper", "over the first", "here", "over the first", "rays that fail"},
      {}};
  const auto add = [&](std::string_view id, const std::string& name, const PointOfSingh& p,
                       const PointOfSingh& first, const MethodSetting& s, const MethodSetting& at_first) {
    if (!run.row(id, s)) return;
    const double ours = run.frames(id, s, run.wide());
    table.rows.push_back({name, table_number(p.frames), table_number(p.frames / first.frames),
                          table_number(ours), table_number(ours / run.frames(id, at_first, run.wide())),
                          grouped(run.row(id, s)->failures())});
  };
  for (const PointOfSingh& p : kDecicSteps)
    add("barth_decic", fmt::format("decic, step {}", p.value), p, kDecicSteps[0], sign_test(p.value),
        sign_test(kDecicSteps[0].value));
  for (const PointOfSingh& p : kOcticTaus)
    add("chmutov_8", fmt::format("octic, tau1 {}", p.value), p, kOcticTaus[0], octic_test(p.value),
        octic_test(kOcticTaus[0].value));
  return table;
}
std::vector<Claim> claims(const SinghRun& run) {
  std::vector<Claim> all;
  const auto add = [&all](Claim claim) { all.push_back(std::move(claim)); };
  const auto by_sign = [](double step) { return sign_test(step); };
  const auto by_taylor = [](double step) { return taylor_test(step); };
  const auto fat = [](double) { return fattened_test(); };
  std::vector<std::string_view> ids;
  for (const SurfaceOfSingh& s : kSinghSurfaces)
    if (!s.id.empty()) ids.push_back(s.id);
  const double misses = run.sum(&Row::false_misses, kTouchingSurfaces, by_sign);

  add(measured("R-SIN-1", "The sign test never reports a false root",
               "share of false hits of each surface, float", {0, 1e-3},
               run.everywhere([](const SurfaceOfSingh&, const Row& r) {
                 return double(r.false_hits) / double(r.rays);
               })));
  add(measured("R-SIN-2", "The sign test misses pairs of roots: holes",
               "false misses: Steiner, cross-cap, miter, kiss, high silhouette", {1}, {misses}));
  add(measured("R-SIN-3", "The Taylor test finds most of them",
               "its false misses over those of the sign test", {0, 0.5},
               {run.sum(&Row::false_misses, kTouchingSurfaces, by_taylor) / misses}));
  constexpr std::string_view kFat[] = {"steiner_singh"};
  add(measured("R-SIN-4", "An offset of 0.01 closes holes", "false misses with over without: Steiner",
               {0, 0.5},
               {run.sum(&Row::false_misses, kFat, fat) / run.sum(&Row::false_misses, kFat, by_sign)}));
  add(measured("R-SIN-4", "But it fattens the surface", "false hits: Steiner", {1},
               {run.sum(&Row::false_hits, kFat, fat)}));
  add(measured("R-SIN-5", "The Taylor test can report false roots", "false hits, all surfaces", {1},
               {run.sum(&Row::false_hits, ids, by_taylor)}));
  add(measured("R-SIN-6", "Taylor costs 1.1 to 2.3 times the sign test", "its time over the sign test's",
               {1.1, 2.3}, run.everywhere([&run](const SurfaceOfSingh& s, const Row& r) {
                 return run.seconds(s.id, taylor_test(s.step)) / r.seconds;
               })));
  add(later("R-SIN-7", "Shorter steps at silhouettes reduce aliasing",
            "needs a map of steps and of silhouettes"));
  add(later("R-SIN-8", "Rays that miss cost most", "needs times of rays rather than of pictures"));
  const auto decic = [&run](double step) { return run.row("barth_decic", sign_test(step)); };
  const auto tau = [&run](double tau1) { return run.row("chmutov_8", octic_test(tau1)); };
  if (decic(0.015)) {
    add(measured("R-SIN-9", "Larger steps are faster (1.41 times)", "decic: time at 0.015 over 0.085", {1.2},
                 {decic(0.015)->seconds / decic(0.085)->seconds}));
    add(measured("R-SIN-9", "And miss hits", "decic: failing rays at 0.085 less those at 0.015", {1},
                 {double(decic(0.085)->failures() - decic(0.015)->failures())}));
  }
  if (tau(0.01)) {
    add(measured("R-SIN-10", "A smaller tau1 is faster (1.48 times)", "octic: time at 0.01 over 0.006", {1.1},
                 {tau(0.01)->seconds / tau(0.006)->seconds}));
    add(measured("R-SIN-10", "And misses hits", "octic: failing rays at 0.006 less those at 0.01", {1},
                 {double(tau(0.006)->failures() - tau(0.01)->failures())}));
  }
  add(untested("R-SIN-11", "Chmutov above order 18 in power form shows false roots",
               "isocast runs every form by the recurrence; a unit test shows it of the powers"));
  add(untested("R-SIN-12", "The power form is fastest up to order 18", "as R-SIN-11"));
  add(untested("R-SIN-13", "Double precision shows the same breakdown", "as R-SIN-11"));
  std::vector<double> more;
  for (const std::string_view id : kSmallStepSurfaces)
    if (const Row* const wide = run.row(id, sign_test(kWideStep)))
      more.push_back(double(wide->failures()) / double(run.row(id, sign_test(0.01))->failures()));
  add(measured("R-SIN-14", "Endrass and Hunt need very small steps", "failing rays at step 0.03 over 0.01",
               {1.5}, more));
  std::vector<double> faster;
  for (const PairOfSingh& s : kSinghPairs)
    if (run.row(s.id, knoll_test()))
      faster.push_back(run.seconds(s.id, knoll_test()) / run.seconds(s.id, sign_test(s.step)));
  add(measured("R-SIN-15", "AMP is 1.5 to 6.4 times faster than KNO on the same processor",
               "RAA's time over the sign test's", {1.5}, faster));
  add(later("R-SIN-16", "Evaluating S(p(t)) beats expanding it in t for high degrees",
            "needs the coefficients of the frustum methods"));
  add(measured("R-SIN-17", "Ten bisections give the root within a step / 1024",
               "99 % of the errors, in the longest step (2 b) / 1024", {0, 1},
               run.everywhere([](const SurfaceOfSingh& s, const Row& r) {
                 const Domain& domain = require_surface(s.id).domain;
                 double edge = 0;
                 for (int a = 0; a < 3; ++a) edge = std::max(edge, domain.hi[a] - domain.lo[a]);
                 return r.t_error_p99 * edge / (2 * s.step / 1024);
               })));
  add(untested("R-SIN-18", "Superquadrics keep some aliasing at silhouettes",
               "true of any method with one ray a pixel"));
  std::vector<double> minimal;
  for (const SurfaceOfSingh& s : kSinghSurfaces)
    if (s.id == "scherk" || s.id == "diamond")
      if (const Row* const found = run.row(s.id, sign_test(s.step))) minimal.push_back(failing_share(*found));
  add(measured("R-SIN-19", "Extremal minimal surfaces give trouble",
               "share of rays that fail: Scherk, diamond", {1e-3}, minimal));
  add(later("R-SIN-20", "Dynamic surfaces cost nothing extra", "the bench times single frames"));
  add(untested("R-SIN-21", "Their Mitchell method was robust up to order 5 only",
               "a remark on their program"));
  return all;
}

}  // namespace

Paper singh_paper(const PaperWishes& wishes) {
  SinghRun run(wishes);
  Paper paper{kSinghSource,
              {std::begin(kSinghNotes), std::end(kSinghNotes)},
              {surface_table(run), pair_table(run), frame_table(run), figure_table(run)},
              claims(run),
              {}};
  paper.rows = run.take_rows();
  return paper;
}

}  // namespace isocast::bench
