#include <isocast/implicit/methods.h>

#include <algorithm>

namespace isocast {
namespace {

constexpr const char* kKnoll =
    "Knoll, Hijazi, Kensler, Schott, Hansen, Hagen: Fast ray tracing of arbitrary implicit surfaces with "
    "interval and affine arithmetic, Computer Graphics Forum 28(1), 2009";

constexpr MethodOption kEps = {
    "eps", 0, 0, 1e300, false, "world length", "parts of a ray below it are judged; 0: eps-rel decides"};
constexpr MethodOption kEpsRel = {
    "eps-rel", 0x1p-11, 0x1p-40, 1, false, "of the domain's longest edge", "the same as a fraction"};
constexpr MethodOption kDelta = {"delta",
                                 0,
                                 0,
                                 1e300,
                                 false,
                                 "",
                                 "a part over which f varies by no more is taken for a hit, without proof"};
constexpr MethodOption kShadow = {
    "shadow-eps-rel", 0, 0, 1, false, "of the domain's longest edge", "eps-rel of shadow rays, if larger"};
constexpr MethodOption kNormalStep = {
    "normal-step", 1, 0x1p-20, 0x1p20, false, "eps", "stencil of --normals difference"};
constexpr MethodOption kNormalGrows = {
    "normal-grows", 0, 0, 1, true, "", "1: that stencil times the distance over the domain's longest edge"};
constexpr MethodOption kPrune = {
    "prune",
    1,
    0,
    1,
    true,
    "",
    "1: where min, max or if is decided the formula is run without what it does not need"};
constexpr MethodOption kBeams = {
    "beams",
    1,
    0,
    1,
    true,
    "",
    "1: rays of the camera are first cut, tile by tile, to where f may reach an iso-value"};
constexpr MethodOption kTrim = {
    "trim", 1, 0, 1, true, "", "1: what a form proves empty of a part is left out before it is divided"};

constexpr MethodOption kBisection = {
    "bisection",
    0,
    0,
    1,
    true,
    "",
    "t: each ray for itself; k: 16 rays are divided together, along the axis that they follow most",
    "t k"};

constexpr MethodOption kRounding = {
    "rounding",
    0,
    0,
    1,
    true,
    "",
    "outward: bounds hold what rounding adds; nearest: as the papers, a little faster, and nothing is proved",
    "outward nearest"};

constexpr MethodOption kStep = {
    "step", 0, 0, 1e300, false, "world length", "base step; 0: 2^-8 of the domain's longest edge"};
constexpr MethodOption tau(std::string_view name, std::string_view meaning) {
  return {name, 0, 0, 1e300, false, "", meaning};
}
constexpr MethodOption kHalvings = {
    "iterations", 10, 0, 60, true, "", "bisections of the step that holds a root"};
constexpr MethodOption kOffset = {"offset",
                                  0,
                                  -1e300,
                                  1e300,
                                  false,
                                  "",
                                  "added to every iso-value: fattens a surface that is only touched"};

constexpr MethodOption kInterval[] = {kEps,        kEpsRel,      kDelta, kBisection, kShadow,
                                      kNormalStep, kNormalGrows, kBeams, kPrune,     kRounding};
constexpr MethodOption kAffine[] = {kEps,        kEpsRel,      kDelta, kBisection, kTrim,    kShadow,
                                    kNormalStep, kNormalGrows, kBeams, kPrune,     kRounding};
constexpr MethodOption kCertified[] = {kEps, kEpsRel, kShadow, kNormalStep, kNormalGrows, kPrune};
constexpr MethodOption kBeamCast[] = {
    {"eps", 0x1p-10, 0x1p-30, 1, false, "depth from -1 to 1", "parts of a pixel's beam below it are painted"},
    {"depth", 0, 0, 2, true, "levels", "how far below pixels the quadtree goes"},
    {"form", 0, 0, 1, true, "",
     "interval: over the box around a part of a beam; affine: forms that follow the beam's slant",
     "interval affine"},
    kEpsRel,
    kShadow,
    kNormalStep,
    kNormalGrows,
    kPrune};
constexpr MethodOption kDerivative[] = {kEps,         kEpsRel, kDelta, kShadow,  kNormalStep,
                                        kNormalGrows, kBeams,  kPrune, kRounding};
constexpr MethodOption kMarching[] = {
    kStep,
    tau("tau1", "where |f - iso| is at most this, half a step; 0: the median gradient times the base step"),
    tau("tau2", "where it is more than this, two; 0: twice tau1"),
    tau("tau3",
        "where it is at most tau1 and |df/dt| at most this, a quarter; 0: a tenth of the median gradient"),
    kHalvings,
    kOffset,
    kNormalStep,
    kNormalGrows,
    kPrune};

constexpr MethodOption kFormEps = {"eps",
                                   0x1p-11,
                                   0x1p-40,
                                   0.5,
                                   false,
                                   "depth of a block, or of a ray on its own",
                                   "how close a root is sought"};
constexpr MethodOption kStop = {
    "stop",
    0,
    0,
    1,
    true,
    "",
    "knots: where they are dense around the root; value: where |f| is below eps^2 or the interval below eps",
    "knots value"};
constexpr MethodOption kSteps = {
    "iterations", 64, 1, 64, true, "", "subdivisions or inserted knots of a ray"};
constexpr MethodOption kCertify = {
    "certify", 1, 0, 1, true, "", "1: roots are improved, and the signs of the form prove hits and misses"};
constexpr MethodOption kGradient = {
    "gradient",
    0,
    0,
    1,
    true,
    "",
    "what --normals gradient takes: formula: the formula's; form: the frustum form's, through its map's "
    "Jacobian, on rays of the camera",
    "formula form"};
constexpr MethodOption kFrustum[] = {kFormEps, kStop, kSteps, kCertify, kGradient, kNormalStep, kNormalGrows};
constexpr const char* kReimers =
    "Reimers, Seland: Ray casting algebraic surfaces using the frustum form, Computer Graphics Forum 27(2), "
    "2008";

constexpr const char* kMitchell =
    "Mitchell: Robust ray intersection with interval arithmetic, Graphics Interface 1990";
constexpr const char* kGanacim =
    "Ganacim, de Figueiredo, Nehab: Beam casting implicit surfaces on the GPU with interval arithmetic, "
    "SIBGRAPI 2011";
constexpr const char* kMoore =
    "Moore, Kearfott, Cloud: Introduction to interval analysis, SIAM 2009, chapter 8";
constexpr const char* kSingh =
    "Singh, Narayanan: Real-time ray tracing of implicit surfaces on the GPU, IEEE Transactions on "
    "Visualization and Computer Graphics 16(2), 2010";

constexpr Method kMethods[] = {
    {"interval", "formula", "both", "library", "float double", kInterval, kKnoll},
    {"affine", "formula", "both", "library", "float double", kAffine, kKnoll},
    {"mitchell", "formula", "both", "library", "float double", kDerivative, kMitchell},
    {"interval-newton", "formula", "both", "library", "float double", kDerivative, kMoore},
    {"amp-sign", "formula", "nothing", "library", "float double", kMarching, kSingh},
    {"amp-taylor", "formula", "nothing", "library", "float double", kMarching, kSingh},
    {"frustum-lr", "formula", "both", "basic", "float double mixed", kFrustum, kReimers},
    {"frustum-mr", "formula", "both", "basic", "float double mixed", kFrustum, kReimers},
    {"frustum-lr-mult", "formula", "both", "basic", "float double mixed", kFrustum, kReimers},
    {"frustum-mr-mult", "formula", "both", "basic", "float double mixed", kFrustum, kReimers},
    {"frustum-schneider", "formula", "both", "basic", "float double mixed", kFrustum,
     "Schneider: A Bezier curve-based root-finder, Graphics Gems, 1990; on the frustum form of Reimers and "
     "Seland"},
    {"frustum-clip", "formula", "both", "basic", "float double mixed", kFrustum,
     "Nishita, Sederberg, Kakimoto: Ray tracing trimmed rational surface patches, SIGGRAPH 1990, from one "
     "side; on "
     "the frustum form of Reimers and Seland"},
    {"certified", "formula", "both", "library", "float double", kCertified, kGanacim},
    {"beam-uniform", "formula", "misses", "library", "float double", kBeamCast, kGanacim},
    {"beam-adaptive", "formula", "misses", "library", "float double", kBeamCast, kGanacim},
};

// What each row runs: on rays of the camera, and on others.
struct Run {
  FormulaPass pass;
  FormulaMethod method;
  bool operator==(const Run&) const = default;
};
constexpr Run kRuns[std::size(kMethods)] = {
    {FormulaPass::none, FormulaMethod::interval},
    {FormulaPass::none, FormulaMethod::affine},
    {FormulaPass::none, FormulaMethod::mitchell},
    {FormulaPass::none, FormulaMethod::interval_newton},
    {FormulaPass::none, FormulaMethod::amp_sign},
    {FormulaPass::none, FormulaMethod::amp_taylor},
    {FormulaPass::frustum, FormulaMethod::frustum_lr},
    {FormulaPass::frustum, FormulaMethod::frustum_mr},
    {FormulaPass::frustum, FormulaMethod::frustum_lr_mult},
    {FormulaPass::frustum, FormulaMethod::frustum_mr_mult},
    {FormulaPass::frustum, FormulaMethod::frustum_schneider},
    {FormulaPass::frustum, FormulaMethod::frustum_clip},
    {FormulaPass::certified, FormulaMethod::affine},
    {FormulaPass::beam_uniform, FormulaMethod::interval},
    {FormulaPass::beam_adaptive, FormulaMethod::interval},
};

}  // namespace

std::span<const Method> formula_methods() { return kMethods; }

FormulaMethodChoice choose_formula_method(std::string_view name,
                                          const std::map<std::string, std::string>& settings) {
  const Method& method = find_method(kMethods, name);
  const std::map<std::string, double> values = resolve_options(method, settings);
  FormulaMethodChoice choice;
  const Run& run = kRuns[&method - kMethods];
  choice.method = run.method, choice.pass = run.pass;
  const auto value = [&values](const char* option, double otherwise) {
    const auto found = values.find(option);
    return found == values.end() ? otherwise : found->second;
  };
  const bool casts = run.pass == FormulaPass::beam_uniform || run.pass == FormulaPass::beam_adaptive;
  if (casts) choice.depth_eps = value("eps", 0);
  else choice.eps = value("eps", choice.eps);
  choice.finer = static_cast<int>(value("depth", 0));
  choice.affine_beams = value("form", 0) == 1;
  choice.eps_rel = value("eps-rel", choice.eps_rel);
  choice.offset = value("offset", 0);
  choice.shadow_eps_rel = value("shadow-eps-rel", 0);
  choice.normal_step = value("normal-step", 1);
  choice.normal_grows = value("normal-grows", 0) != 0;
  FormulaOptions& options = choice.options;
  choice.prune = value("prune", 1) != 0;
  choice.nearest = value("rounding", 0) == 1;
  choice.beams = value("beams", run.pass != FormulaPass::none) != 0;
  options.delta = value("delta", 0);
  options.trim = value("trim", 1) != 0;
  options.packets = value("bisection", 0) == 1;
  options.step = value("step", 0);
  options.tau[0] = value("tau1", 0), options.tau[1] = value("tau2", 0), options.tau[2] = value("tau3", 0);
  options.halvings = static_cast<int>(value("iterations", 0));
  if (choice.has_form()) {
    choice.finder = {static_cast<RootFinder>(static_cast<int>(choice.method) -
                                             static_cast<int>(FormulaMethod::frustum_lr)),
                     value("eps", 0), value("stop", 0) == 1, static_cast<int>(value("iterations", 64))};
    choice.certify = value("certify", 1) != 0;
    choice.form_normals = value("gradient", 0) == 1;
    choice.eps = 0;
  }
  if (choice.method == FormulaMethod::mitchell) options.derivative = Derivative::of_all;
  if (choice.method == FormulaMethod::interval_newton) options.derivative = Derivative::newton;
  return choice;
}

std::string_view name_of(const FormulaMethodChoice& choice) {
  return kMethods[std::ranges::find(kRuns, Run{choice.pass, choice.method}) - kRuns].name;
}

}  // namespace isocast
