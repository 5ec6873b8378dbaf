#include <fmt/format.h>
#include <isocast/implicit/automatic.h>
#include <isocast/implicit/expression/simplify.h>
#include <isocast/implicit/tape_cost.h>
#include <isocast/ray/primary_pass.h>
#include <isocast/render/camera.h>

#include <memory>

namespace isocast {
namespace {

// Rays from points around the box to points inside it, low-discrepancy in both.
void fill_probe(const Domain& domain, RayStream& rays) {
  rays.size = kStreamSize;
  rays.kind = RayKind::reflection;
  const auto place = [](int n, double ratio) { return n * ratio - std::floor(n * ratio); };
  for (int i = 0; i < kStreamSize; ++i) {
    double o[3], d[3];
    for (int a = 0; a < 3; ++a) {
      constexpr double kRatios[6] = {0.8191725134, 0.6710436067, 0.5497004779, 0.4502995221, 0.3689, 0.3022};
      const double edge = domain.hi[a] - domain.lo[a], middle = 0.5 * (domain.lo[a] + domain.hi[a]);
      o[a] = middle + 4 * edge * (place(i + 1, kRatios[a]) - 0.5);
      d[a] = domain.lo[a] + edge * place(i + 1, kRatios[3 + a]) - o[a];
    }
    rays.ox[i] = o[0], rays.oy[i] = o[1], rays.oz[i] = o[2];
    rays.dx[i] = d[0], rays.dy[i] = d[1], rays.dz[i] = d[2];
    rays.t_min[i] = 0;
    rays.t_max[i] = __builtin_inf();
    rays.start_object[i] = kNoObject;
  }
}

// Operations a ray in the middle block of a picture of the domain.
double picture_work(const Surface& surface, double evaluation, double of_form) {
  constexpr int kSide = kBlockTiles * kTileSize, kMiddle = 3;
  const View view(frame(surface.bounds(), {}, 1), 8 * kSide, 8 * kSide);
  TraceCounts counts;
  if (const auto pass = surface.primary(view)) {
    const auto hits = std::make_unique_for_overwrite<BlockHits>();
    hits->reset(surface.proves());
    pass->first_hits(kMiddle, kMiddle, 0.5, 0.5, *hits, counts);
    return kPictureRayCost + (evaluation * static_cast<double>(counts.evaluations) +
                              of_form * static_cast<double>(counts.solves)) /
                                 (kSide * kSide);
  }
  const auto rays = std::make_unique<RayStream>();
  const auto hits = std::make_unique<HitStream>();
  constexpr int kStep = 3;
  int tiles = 0;
  for (int y = 0; y < kBlockTiles; y += kStep)
    for (int x = 0; x < kBlockTiles; x += kStep, ++tiles) {
      view.fill(kMiddle * kBlockTiles + x, kMiddle * kBlockTiles + y, 0.5, 0.5, *rays);
      clear(*hits);
      surface.first_hit(*rays, *hits, counts);
    }
  return kRayCost + evaluation * static_cast<double>(counts.evaluations) / (tiles * kStreamSize);
}

}  // namespace

AutomaticMethod choose_automatically(const Expression& expression, const Domain& domain,
                                     ImplicitSurfaceOptions options) {
  options.device = nullptr;  // the same choice everywhere
  const auto rays = std::make_unique<RayStream>();
  const auto hits = std::make_unique<HitStream>();
  fill_probe(domain, *rays);
  const Tape tape = make_tape(simplify(expression));
  double work[2], evaluations[2];
  for (const FormulaMethod method : {FormulaMethod::interval, FormulaMethod::affine}) {
    options.method.method = method;
    const ImplicitSurface surface(expression, domain, options);
    TraceCounts counts;
    clear(*hits);
    surface.first_hit(*rays, *hits, counts);
    const auto i = static_cast<std::size_t>(method);
    evaluations[i] = static_cast<double>(counts.evaluations) / kStreamSize;
    work[i] = evaluations[i] * evaluation_cost(tape, method == FormulaMethod::affine);
  }
  const FormulaMethod chosen = work[0] < work[1] ? FormulaMethod::interval : FormulaMethod::affine;
  std::string reason = fmt::format(
      "on {} rays through the domain interval takes {:.1f} evaluations a ray and affine {:.1f}, with "
      "the cost of their operations {:.0f} against {:.0f}",
      kStreamSize, evaluations[0], evaluations[1], work[0], work[1]);
  const FormulaMethodChoice wishes = options.method;
  const auto surface_with = [&](FormulaMethod method, FormulaPass pass) {
    options.method.method = method, options.method.pass = pass;
    return ImplicitSurface(expression, domain, options);
  };
  if (wishes.nearest || wishes.options.delta > 0 || wishes.options.packets || !wishes.beams)
    return {chosen, FormulaPass::none, reason};
  const ImplicitSurface certified = surface_with(FormulaMethod::affine, FormulaPass::certified);
  // beams are affine: where that does not pay for rays, or rays are hard, they have been slower by far
  constexpr double kHard = 100, kDearer = 2;
  if (!certified.takes_forms() && (work[1] > kDearer * work[0] || evaluations[1] > kHard))
    return {chosen, FormulaPass::none, reason};
  const double of_form = form_cost(polynomial_degree(tape).degree.value_or(0));
  const double alone = picture_work(surface_with(chosen, FormulaPass::none),
                                    evaluation_cost(tape, chosen == FormulaMethod::affine), of_form);
  const double together = picture_work(certified, evaluation_cost(tape, true), of_form);
  reason +=
      fmt::format("; in the middle of a picture certified takes {:.0f} operations a ray, rays alone {:.0f}",
                  together, alone);
  if (together < alone) return {FormulaMethod::affine, FormulaPass::certified, reason};
  return {chosen, FormulaPass::none, reason};
}

}  // namespace isocast
