// What probe says of answers, on made-up truths and on one scene.
#include <isocast/apps/isocast/probe_ray.h>
#include <isocast/implicit/expression/parse.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace isocast;
using reference::Doubt;
using reference::RayTruth;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr auto kNone = Certificate::no_proof, kHit = Certificate::proved_hit,
               kMiss = Certificate::proved_miss;

// A touch at 1, crossings at 2 and 4.
RayTruth truth() {
  RayTruth made;
  made.roots = {{1, 1, false, kInf, 1}, {2, 2.5, true, 1, 1}, {4, 4, true, 1, 1.5}};
  return made;
}
bool contradicts(const RayTruth& made, Certificate certificate, double t_lo = kInf, double t_hi = kInf) {
  return !contradiction_of(made, certificate, t_lo, t_hi).empty();
}

}  // namespace

TEST_CASE("an answer is judged by the first crossing") {
  CHECK(verdict_of(truth(), kNone, 2.3) == "right");
  CHECK(verdict_of(truth(), kNone, 3.9) == "wrong root");
  CHECK(verdict_of(truth(), kNone, 0.9) == "wrong root");  // the touch
  CHECK(verdict_of(truth(), kNone, kInf) == "false miss");
  CHECK(verdict_of({}, kNone, kInf) == "right");
  CHECK(verdict_of({}, kNone, 1) == "false hit");
  CHECK(verdict_of(truth(), Certificate::undecided, kInf) == "undecided");
}

TEST_CASE("where the reference does not know the first crossing it says so") {
  RayTruth doubtful = truth();
  doubtful.doubts = {{3, 3.5, Doubt::touch}};
  CHECK(verdict_of(doubtful, kNone, kInf) == "false miss");
  doubtful.doubts = {{1.5, 1.6, Doubt::touch}};
  CHECK(verdict_of(doubtful, kNone, kInf) == "unknown");
  doubtful.roots.clear();
  CHECK(verdict_of(doubtful, kNone, kInf) == "unknown");
}

TEST_CASE("proofs that cannot be") {
  RayTruth made = truth();
  CHECK_FALSE(contradicts(made, kNone, 3, 3.5));
  CHECK_FALSE(contradicts(made, Certificate::undecided, 3, 3.5));
  CHECK(contradicts(made, kMiss));
  CHECK_FALSE(contradicts({}, kMiss));
  CHECK_FALSE(contradicts(made, kHit, 0.5, 1));
  CHECK(contradicts(made, kHit, 2, 2.5));  // the touch lies before it
  CHECK(contradicts(made, kHit, 0.25, 0.5));
  made.roots.erase(made.roots.begin());
  CHECK_FALSE(contradicts(made, kHit, 1.5, 2.25));
  CHECK(contradicts({}, kHit, 1, 2));
  RayTruth doubtful;
  doubtful.doubts = {{1.5, 1.6, Doubt::work}};
  CHECK_FALSE(contradicts(doubtful, kHit, 1, 2));
  CHECK_FALSE(contradicts(doubtful, kMiss));
}

TEST_CASE("one pixel of a sphere by two methods") {
  SceneDescription description;
  description.objects.front().source =
      FormulaSource{parse_expression("x^2 + y^2 + z^2 - 1"), {{-2, -2, -2}, {2, 2, 2}}};
  const BuiltScene built = build_scene(description, {});
  const View view({{-5, 0, 0}, {0, 0, 0}, {0, 0, 1}, 45, {}}, 33, 21);
  // the picture's centre; and a pixel of another tile beside the sphere
  const Probe probe =
      probe_ray(description, built, view, 16, 10, {{"affine", {}}, {"amp-sign", {}}}, widest_isa());
  CHECK(probe.unit == 4);
  REQUIRE(probe.truth.roots.size() == 2);
  CHECK(probe.truth.roots[0].lo == Approx(4));
  REQUIRE(probe.answers.size() == 4);
  for (const ProbeAnswer& answer : probe.answers) {
    CHECK(answer.t == Approx(4).epsilon(1e-4));
    CHECK(answer.error == std::abs(answer.t - 0.5 * (probe.truth.roots[0].lo + probe.truth.roots[0].hi)) / 4);
    CHECK(answer.verdict == "right");
    CHECK(answer.contradiction.empty());
    CHECK(answer.work > 0);
    CHECK(answer.seconds > 0);
    CHECK((answer.certificate == kHit) == (answer.method == "affine"));
  }
  CHECK(probe.answers[0].precision == "float");
  CHECK(probe.answers[1].precision == "double");
  const Probe beside = probe_ray(description, built, view, 32, 20, {{"affine", {}}}, widest_isa());
  CHECK(beside.truth.roots.empty());
  CHECK(beside.answers[0].certificate == kMiss);
  CHECK(beside.answers[0].verdict == "right");
  CHECK(std::isnan(beside.answers[0].error));
}
