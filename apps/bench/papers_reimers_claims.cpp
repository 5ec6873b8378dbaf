// The claims of Reimers and Seland.
#include <isocast/apps/bench/claims.h>
#include <isocast/apps/bench/papers_reimers_form.h>
#include <isocast/apps/bench/papers_reimers_run.h>

#include <algorithm>

namespace isocast::bench {
namespace {

using Surface = SurfaceOfReimers;

// Rays that fail among those that the exact reference was asked for.
double failing_judged(const FinderResult& found) {
  return double(found.row.failures()) / double(found.row.rays - found.row.undecided_reference);
}

class Claims {
 public:
  explicit Claims(const ReimersRun& run) : run_(run) {}

  std::vector<Claim> all() {
    add_accuracy();
    add_finders();
    add_frames();
    add_forms();
    std::ranges::stable_sort(claims_, {}, [](const Claim& c) { return std::stoi(c.id.substr(6)); });
    return std::move(claims_);
  }

 private:
  void add(Claim claim) { claims_.push_back(std::move(claim)); }
  const SearchNumbers& search(const Surface& s, const MethodSetting& setting, bool precise = false) const {
    return run_.result(s.id, setting, precise)->search;
  }
  // How many times as long, or as many knots; of surfaces of these degrees.
  std::vector<double> times(const MethodSetting& slow, const MethodSetting& fast, int least = 0,
                            int most = kMostFormDegree) const {
    return run_.each([&](const Surface& s) { return run_.time_ratio(s, slow, fast); }, least, most);
  }
  std::vector<double> knots(const MethodSetting& slow, const MethodSetting& fast, int least = 0) const {
    return run_.each([&](const Surface& s) { return run_.knots(s, slow) / run_.knots(s, fast); }, least);
  }
  double all_rays() const {
    double sum = 0;
    for (const double rays :
         run_.each([&](const Surface& s) { return double(run_.result(s.id, lr_)->row.rays); }))
      sum += rays;
    return sum;
  }
  // Of all surfaces.
  double other_roots(const MethodSetting& setting) const {
    double sum = 0;
    for (const Surface& s : kReimersSurfaces)
      if (run_.shading(s.id)) sum += double(search(s, setting).other_roots);
    return sum;
  }

  void add_accuracy() {
    add(measured("R-REI-1", "Normalised errors are typically below 1e-6", "mean |f| / K of each surface, LR",
                 {0, 1e-6}, run_.each([&](const Surface& s) { return search(s, lr_).value_mean; })));
    add(measured("R-REI-1", "They are at most 1.9e-5", "largest |f| / K", {0, 1.9e-5},
                 run_.each([&](const Surface& s) { return search(s, lr_).value_max; })));
    add(measured("R-REI-2", "MR converges to the smallest root unconditionally",
                 "rays of every surface that fail in double, eps 1e-8", {0, 0},
                 run_.each([&](const Surface& s) {
                   return double(run_.result(s.id, reference_finder(), true)->row.failures());
                 })));
    const MethodSetting coarse = finder("frustum-mr", {{"eps", "0.0001"}});
    add(measured(
        "R-REI-2", "Quadratically at simple roots",
        "knots more for eps 1e-8 than for 1e-4, over the d - 1 whose density is asked for, of hits away "
        "from edges",
        {0, 1.2}, run_.each([&](const Surface& s) {
          return (search(s, reference_finder(), true).steps_inside - search(s, coarse, true).steps_inside) /
                 (s.degree - 1);
        })));
    add(measured("R-REI-3", "LR and MR are accurate everywhere",
                 "share of rays that end more than 0.01 of the depths from the reference", {0, 1e-3},
                 {other_roots(lr_) / all_rays(), other_roots(mr_) / all_rays()}));
    add(measured("R-REI-3", "The Mult methods return other roots near silhouettes",
                 "the share of LR-Mult less that of LR, and of MR-Mult less that of MR", {1e-4},
                 {(other_roots(lr_mult_) - other_roots(lr_)) / all_rays(),
                  (other_roots(mr_mult_) - other_roots(mr_)) / all_rays()}));
    const auto large = [&](std::string_view id, bool precise) {
      const FinderResult* const found =
          run_.result(large_case(id), finder("frustum-lr", {{"eps", kLargeEps}}), precise);
      return found ? failing_judged(*found) : std::nan("");
    };
    const double heart = large(kLargeSurfaces[0], false), tangle = large(kLargeSurfaces[1], false);
    add(measured("R-REI-15", "A large frustum leads to instability",
                 "share of rays that fail in float in a domain 8 times as long: heart", {0.01}, {heart}));
    add(measured("R-REI-15", "Worst at singular surfaces", "share of the heart less the tangle's", {1e-3},
                 {heart - tangle}));
    add(measured("R-REI-15", "Double precision mostly removes it", "the heart's share in double over float's",
                 {0, 0.1}, {large(kLargeSurfaces[0], true) / heart}));
    add_neck();
  }

  void add_neck() {
    const auto wrong = [&](const char* eps) {
      const FinderResult* const found = run_.result("kiss", finder("frustum-lr", {{"eps", eps}}));
      return found ? double(found->search.part_wrong) / double(found->search.part_hits) : std::nan("");
    };
    add(measured("R-REI-16", "The thin neck of Kiss is well resolved",
                 "rays at the neck whose hit is lost or invented, over its hits, eps 5e-4", {0, 0.02},
                 {wrong("0.0005")}));
    std::vector<double> coarse, strict;
    for (const char* eps : kNeckEps) (std::stod(eps) > 5e-4 ? coarse : strict).push_back(wrong(eps));
    add(measured("R-REI-16", "Provided the criterion is not too coarse", "the same at 5e-2 and 5e-3", {0.02},
                 coarse));
    add(measured("R-REI-16", "Provided the criterion is not too fine", "the same at 5e-5 to 5e-7", {0.02},
                 strict));
  }

  void add_finders() {
    const MethodSetting clip = finder("frustum-clip"), halves = finder("frustum-schneider");
    add(measured("R-REI-4", "MR needs 2 to 3 times fewer insertions than LR (table: 1.95 to 2.33)",
                 "LR's knots over MR's", {1.9, 3}, knots(lr_, mr_)));
    add(measured("R-REI-5", "LR is faster for high degrees (2.2 to 2.4 times)",
                 "MR's time over LR's, degree 10 and more", {1.5}, times(mr_, lr_, 10)));
    add(measured("R-REI-5", "They are equal for cubics", "MR's time over LR's", {0.8, 1.25},
                 times(mr_, lr_, 3, 3)));
    add(measured("R-REI-6", "LR-Mult is slightly faster than LR on most surfaces of degree 5 and more",
                 "median of LR's time over LR-Mult's", {1}, {quantile(times(lr_, lr_mult_, 5), 0.5)}));
    std::vector<double> slower;
    for (const Surface& s : kReimersSurfaces)
      if (run_.shading(s.id) && s.id != "kiss") slower.push_back(run_.time_ratio(s, mr_mult_, mr_));
    add(measured("R-REI-6", "MR-Mult is slower than MR except on Kiss", "MR-Mult's time over MR's", {1},
                 slower));
    for (const char* name : {"frustum-lr", "frustum-mr"})
      add(measured("R-REI-7",
                   std::string("Stopping where knots are dense is cheaper than at |f| < eps²: ") + name,
                   "knots by |f| over knots by density, at one eps", {1},
                   knots(finder(name, {{"stop", "value"}}), finder(name))));
    add(measured("R-REI-7", "It is cheaper at equal accuracy",
                 "LR's knots by |f| over those by density, for one median error, in double", {1},
                 run_.each([&](const Surface& s) { return run_.cost_of_value_rule(s); })));
    add(measured("R-REI-8", "One-sided clipping is clearly slower than LR and MR for degrees above 4",
                 "its time over LR's and MR's", {1.5}, joined(times(clip, lr_, 5), times(clip, mr_, 5))));
    add(measured(
        "R-REI-8", "Worst at silhouettes",
        "its steps at edges, misses with them, over those of hits away from them", {1.5},
        run_.each(
            [&](const Surface& s) { return search(s, clip).steps_edges / search(s, clip).steps_inside; },
            5)));
    std::vector<double> slowest;
    for (const char* name : kFinders)
      if (halves.method != name) slowest = joined(slowest, times(halves, finder(name)));
    add(measured("R-REI-9", "Schneider's halving is slower than all others",
                 "its time over each of the others'", {1}, slowest));
  }
  static std::vector<double> joined(std::vector<double> a, const std::vector<double>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  void add_frames() {
    const auto share_of_roots = [&](const Surface& s) {
      return run_.root_seconds(s) / run_.result(s.id, lr_)->row.seconds;
    };
    add(measured("R-REI-11", "Roots dominate at moderate degrees",
                 "share of searches in the pass, degrees to 10", {0.5}, run_.each(share_of_roots, 0, 10)));
    add(measured("R-REI-11", "The form dominates at degree 16 (64 %)", "the same, degree 16", {0, 0.5},
                 run_.each(share_of_roots, 16)));
    add(measured("R-REI-12", "Neighbours' normals cannot be told from gradients", "median angle, degrees",
                 {0, 2}, run_.each([&](const Surface& s) { return run_.shading(s.id)->angle; })));
    add(measured("R-REI-12", "At a fraction of their cost", "their time over that of gradients", {0, 1.0 / 3},
                 run_.each([&](const Surface& s) {
                   return run_.shading(s.id)->neighbours / run_.shading(s.id)->gradients;
                 })));
    add(measured("R-REI-12", "Gradients through the form's Jacobian are the formula's",
                 "median angle, degrees", {0, 0.1},
                 run_.each([&](const Surface& s) { return run_.shading(s.id)->form_angle; })));
    const auto per_hit = [&](int least, int most) {
      return quantile(run_.each(
                          [&](const Surface& s) {
                            return run_.shading(s.id)->neighbours / double(run_.shading(s.id)->hits);
                          },
                          least, most),
                      0.5);
    };
    add(measured("R-REI-12", "Their cost does not depend on the degree",
                 "median time a hit, degrees from 8 over degrees to 4", {2.0 / 3, 1.5},
                 {per_hit(8, kMostFormDegree) / per_hit(0, 4)}));
    const auto loss = [&](double ShadingNumbers::*frame) {
      return run_.each([&, frame](const Surface& s) {
        return 1 - run_.shading(s.id)->frame / run_.shading(s.id)->*frame;
      });
    };
    add(measured("R-REI-13", "Anti-aliasing costs 25 % to 50 % of the frame rate", "share of frames lost",
                 {0.25, 0.5}, loss(&ShadingNumbers::silhouettes)));
    add(measured("R-REI-13", "Supersampling, 2 by 2, would cost about 75 %", "share of frames lost",
                 {0.65, 0.8}, loss(&ShadingNumbers::four_samples)));
    add(untested("R-REI-14", "Frame coherence gains 10 % to 100 %, pixel coherence little",
                 "the bench times single frames, and searches of pictures take no seeds"));
  }

  void add_forms() {
    add(measured("R-REI-10", "A ray's coefficients cost less than one value of a general f",
                 "multiply-adds, with a row's sums shared by 16 rays, over (d+1)(d+2)(d+3)/6", {0, 1},
                 run_.each([](const Surface& s) {
                   const double n = s.degree + 1;
                   return (n * n + n * n * n / 16) / (n * (n + 1) * (n + 2) / 6);
                 })));
    add(untested("R-REI-17", "An optimised power form of the super-sphere triples its frame rate",
                 "the power form is the only one that isocast evaluates"));
    add(untested("R-REI-18", "Analytic quartics are 10 times faster, intervals on the CPU 10 times slower",
                 "estimates of other programs, on other hardware"));
    std::vector<double> worse;
    for (const Surface& s : kReimersSurfaces)
      for (const Nodes nodes : {Nodes::even, Nodes::even_inside})
        worse.push_back(collocation_condition(s.degree, nodes) /
                        collocation_condition(s.degree, Nodes::chebyshev));
    add(measured("R-REI-19", "Chebyshev's nodes have the least condition number",
                 "that of even nodes, with and without the ends, over theirs", {1}, worse));
    add(measured("R-REI-20", "Signs of coefficients bound the number of roots",
                 "rays with a proof of hit or miss by signs that the reference contradicts", {0, 0},
                 run_.each([&](const Surface& s) {
                   const Row& row = run_.result(s.id, finder("frustum-lr", {{"certify", "1"}}))->row;
                   return double(row.false_hits + row.false_misses + row.wrong_root);
                 })));
  }

  const ReimersRun& run_;
  const MethodSetting lr_ = finder("frustum-lr"), mr_ = finder("frustum-mr"),
                      lr_mult_ = finder("frustum-lr-mult"), mr_mult_ = finder("frustum-mr-mult");
  std::vector<Claim> claims_;
};

}  // namespace

std::vector<Claim> reimers_claims(const ReimersRun& run) { return Claims(run).all(); }

}  // namespace isocast::bench
