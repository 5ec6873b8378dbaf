// Pictures in the bench: what counts as right, which settings are run, and one case from end to end.
#include <isocast/apps/bench/condition.h>
#include <isocast/apps/bench/pareto.h>
#include <isocast/apps/bench/picture_run.h>
#include <isocast/apps/bench/suites.h>
#include <isocast/base/error.h>
#include <isocast/implicit/expression/parse.h>
#include <temporary_folder.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace isocast;
using namespace isocast::bench;
using reference::RayRoot, reference::RayTruth;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

RayRoot root_at(double t, bool crossing = true, double condition = 1) {
  return {t, t, crossing, condition, kInfinity};
}

// A plane that every ray meets at right angles, whatever it is asked.
class Wall final : public Surface {
 public:
  [[nodiscard]] Box bounds() const override { return {}; }
  void first_hit(const RayStream&, HitStream&, TraceCounts&) const override {}
  void next_hit(const RayStream&, HitStream&, TraceCounts&) const override {}
  void dress(const RayStream& rays, const HitStream& hits, const DressWishes&,
             DressedHits& dressed) const override {
    for (int i = 0; i < rays.size; ++i) {
      if (!std::isfinite(hits.t[i])) continue;
      dressed.normal[0][i] = dressed.normal[1][i] = 0;
      dressed.normal[2][i] = 1;
    }
  }
};

// Pixels side by side, one ray along z each, with what is true of them and what a method says.
struct Pixels {
  PictureTruth truth;
  std::vector<RayStream> rays;
  std::vector<HitStream> hits;

  Pixels() : rays(1), hits(1) {
    rays[0].size = 0;
    clear(hits);
  }
  void add(RayTruth ray, double t, Certificate certificate = Certificate::no_proof) {
    const int i = rays[0].size++;
    rays[0].dx[i] = rays[0].dy[i] = 0;
    rays[0].dz[i] = 2;  // lengths are twice the t
    rays[0].t_min[i] = 0;
    rays[0].t_max[i] = 10;
    rays[0].id[i] = static_cast<std::uint32_t>(i);
    hits[0].t[i] = t;
    hits[0].certificate[i] = certificate;
    truth.rays.push_back(std::move(ray));
    truth.normals.push_back({0, 0.6, 0.8});
  }
  std::vector<PixelAnswer> judge() const { return judge_picture(truth, Wall(), rays, hits); }
};

PictureCase ball(int size) {
  PictureCase picture{"input", "ball", {}, size, size};
  picture.scene.objects.front().source = FormulaSource{parse_expression("x^2+y^2+z^2-0.5"), {}};
  return picture;
}

}  // namespace

TEST_CASE("the first crossing is the truth of a ray, whatever it touches before") {
  const RayTruth truth{{root_at(1, false), root_at(2), root_at(3)}, {}, 0};
  CHECK(judge(truth, true, 2.1).verdict == Verdict::hit);
  CHECK(judge(truth, true, 2.1).error == Approx(0.1));
  CHECK(judge(truth, true, 1.1).verdict == Verdict::wrong_root);
  CHECK(judge(truth, true, 2.9).verdict == Verdict::wrong_root);
  CHECK(judge(truth, false, 0).verdict == Verdict::false_miss);
  CHECK(judge({{root_at(1, false)}, {}, 0}, false, 0).verdict == Verdict::miss);
  CHECK(judge({{root_at(1, false)}, {}, 0}, true, 1).verdict == Verdict::false_hit);
}

TEST_CASE("every column of errors counts its own pixels") {
  Pixels pixels;
  pixels.truth.unit = 4;
  const RayTruth doubtful{{root_at(1)}, {{2, 3, reference::Doubt::touch}}, 0};
  pixels.add({{root_at(1)}, {}, 0}, 1.25);                       // right, off by 0.5 in the world
  pixels.add({{root_at(1)}, {}, 0}, 1);                          // right
  pixels.add({{root_at(1)}, {}, 0}, kInfinity);                  // false miss
  pixels.add({}, 1);                                             // false hit
  pixels.add({}, kInfinity);                                     // rightly nothing
  pixels.add({{root_at(1), root_at(5)}, {}, 0}, 4);              // wrong root
  pixels.add({{root_at(1)}, {}, 0}, 1, Certificate::undecided);  // never right
  pixels.add({}, kInfinity, Certificate::undecided);             // nor here
  pixels.add(doubtful, 1);                                       // no one knows
  pixels.add(doubtful, 1, Certificate::undecided);               // no one knows
  Row row;
  summarize(pixels.judge(), row);
  CHECK(row.rays == 10);
  CHECK(row.false_misses == 1);
  CHECK(row.false_hits == 1);
  CHECK(row.wrong_root == 1);
  CHECK(row.undecided == 2);
  CHECK(row.undecided_reference == 2);
  CHECK(undecided_rays(pixels.truth) == 2);
  CHECK(row.failures() == 5);
  CHECK(row.t_error_max == 0.125);
  CHECK(row.t_error_mean == 0.0625);
  CHECK(row.t_error_p50 == 0);
  CHECK(row.normal_error_deg_max == Approx(std::acos(0.8) * 180 / M_PI));
  CHECK(pareto_error(row) == Approx(0.0625 + 0.5));
}

TEST_CASE("normals that no one knows are in no error") {
  Pixels pixels;
  pixels.add({{root_at(1)}, {}, 0}, 1);
  pixels.truth.normals[0] = {0, 0, 0};
  Row row;
  summarize(pixels.judge(), row);
  CHECK(row.failures() == 0);
  CHECK(row.normal_error_deg_max == 0);
  add_normals(pixels.truth, Wall(), pixels.rays, pixels.hits);
  CHECK(pixels.truth.normals[0] == Double3{0, 0, 1});
}

TEST_CASE("roots by the decade of their condition") {
  Pixels pixels;
  pixels.truth.unit = 2;
  for (const double error : {0.0, 0.01, 0.04}) pixels.add({{root_at(1, true, 50)}, {}, 0}, 1 + error);
  pixels.add({{root_at(1, true, 5000)}, {}, 0}, kInfinity);
  pixels.add({{root_at(1, true, kInfinity)}, {}, 0}, 1);
  pixels.add({{root_at(1, true, 0)}, {}, 0}, 1);
  pixels.add({}, kInfinity);
  const std::vector<ConditionBin> bins = condition_bins(pixels.truth, pixels.judge());
  REQUIRE(bins.size() == 4);
  CHECK(bins[0].decade == kFirstDecade);
  CHECK(bins[1].decade == 1);
  CHECK(bins[1].rays == 3);
  CHECK(bins[1].failures == 0);
  CHECK(bins[1].p50 == Approx(0.01));
  CHECK(bins[1].max == Approx(0.04));
  CHECK(bins[2].decade == 3);
  CHECK(bins[2].failures == 1);
  CHECK(bins[3].decade == kLastDecade);
}

TEST_CASE("each method is run as it is, and swept along its own knob") {
  const PictureCase formula = ball(16);
  const std::vector<MethodSetting> all = method_settings(formula.scene.objects.front(), {}, 8);
  const auto texts = [&](std::string_view method) {
    std::vector<std::string> found;
    for (const MethodSetting& setting : all)
      if (setting.method == method) {
        CHECK(setting.swept == !setting.text.empty());
        found.push_back(setting.text);
      }
    return found;
  };
  CHECK(texts("affine").size() == 11);
  CHECK(texts("affine").front().empty());
  CHECK(texts("affine")[1] == "eps-rel=0.015625");
  CHECK(texts("amp-sign")[1] == "step=0.25");
  CHECK(texts("frustum-lr").size() == 11);
  CHECK(texts("frustum-lr")[1] == "eps=0.015625");
  CHECK(texts("frustum-lr").back() == "certify=0");
  PictureCase wave = formula;
  wave.scene.objects.front().source = FormulaSource{parse_expression("sin(x)+y"), {}};
  for (const MethodSetting& setting : method_settings(wave.scene.objects.front(), {}, 2))
    CHECK_THAT(setting.method, !Catch::StartsWith("frustum"));  // sin is no polynomial
  PictureCase volume;
  volume.scene.objects.front().source = VolumeSource{};
  const auto marmitt = method_settings(volume.scene.objects.front(), {.wanted = {"marmitt"}, .set = {}}, 1);
  CHECK(marmitt.size() == 9);
  CHECK(marmitt.back().text == "iterations=10");

  const SettingWishes wishes{.wanted = {"affine"}, .set = {{"eps-rel", "0.01"}}};
  const auto one = method_settings(formula.scene.objects.front(), wishes, 8);
  REQUIRE(one.size() == 1);
  CHECK(one[0].text == "eps-rel=0.01");
  CHECK_FALSE(one[0].swept);
  CHECK_THROWS_AS(method_settings(formula.scene.objects.front(), {.wanted = {"marmitt"}, .set = {}}, 8),
                  InputError);
}

TEST_CASE("a ball through two methods: rows, errors, fronts") {
  PictureOptions options;
  options.settings = {.wanted = {"affine", "amp-sign"}, .set = {}, .quick = true};
  options.isas = {Isa::scalar, widest_isa()};
  options.repetitions = 1;
  const PictureResult result = run_picture(ball(24), options);
  // both methods on two sets in two precisions, and 4 + 3 swept settings
  CHECK(result.rows.size() == 8 + 7);
  CHECK(result.answers.size() == 4);
  CHECK(result.unit_name == "domain widths");
  CHECK(result.harness_seconds < 1);
  CHECK(std::ranges::any_of(result.truth.rays, [](const RayTruth& ray) { return ray.roots.size() == 2; }));
  std::size_t front = 0;
  for (const Row& row : result.rows) {
    front += row.pareto;
    CHECK(row.rays == 24 * 24);
    CHECK(row.seconds > 0);
    CHECK(row.undecided_reference == 0);
    CHECK(row.wrong_root == 0);
    CHECK(row.proves == (row.method == "affine" ? "both" : "nothing"));
    if (row.method != "affine" || !row.setting.empty()) continue;
    CHECK(row.failures() == 0);
    CHECK(row.t_error_max < (row.precision == "double" ? 1e-11 : 1e-4));
    CHECK(row.normal_error_deg_max < (row.precision == "double" ? 1e-6 : 0.1));
  }
  CHECK(front >= 4);
  for (const Row& row : result.rows)
    for (const Row& other : result.rows)
      if (row.pareto && other.isa == row.isa && other.precision == row.precision)
        CHECK_FALSE((other.seconds < row.seconds && pareto_error(other) <= pareto_error(row)));
}

TEST_CASE("suites: six named cases when quick, volumes written where they can be rendered again") {
  const test::TemporaryFolder folder;
  const auto names = [](const std::vector<PictureCase>& cases) {
    std::vector<std::string> found;
    for (const PictureCase& picture : cases) found.push_back(picture.name);
    return found;
  };
  CHECK(names(find_suite("surfaces")->cases({true, folder.path})) ==
        std::vector<std::string>{"tangle", "klein_bottle", "blinn_blob4"});
  CHECK(names(find_suite("volumes")->cases({true, folder.path})) ==
        std::vector<std::string>{"sphere", "gyroid", "noise"});
  CHECK(std::filesystem::exists(folder / "volumes/gyroid.nrrd"));
  CHECK(surface_cases({false, folder.path}).size() >= 12);
  CHECK(find_suite("cells") == nullptr);
}
