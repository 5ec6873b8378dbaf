// The papers' tables: verdicts from made-up numbers, one small paper from end to end, what is written.
#include <apps/well_formed.h>
#include <isocast/apps/bench/claims.h>
#include <isocast/apps/bench/paper_rows.h>
#include <isocast/apps/bench/papers.h>
#include <isocast/apps/bench/papers_reimers_form.h>
#include <isocast/apps/bench/papers_reimers_picture.h>
#include <isocast/apps/bench/picture_reference.h>
#include <isocast/apps/bench/report.h>
#include <isocast/apps/bench/volume_chords.h>
#include <isocast/base/error.h>
#include <isocast/data_gen/write.h>
#include <isocast/implicit/expression/parse.h>
#include <isocast/implicit/methods.h>
#include <isocast/volume/methods.h>
#include <temporary_folder.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

using namespace isocast;
using namespace isocast::bench;

TEST_CASE("a claim is reproduced if every number lies within the bounds") {
  const auto outcome = [](Bounds bounds, const std::vector<double>& found) {
    return measured("R-1", "a claim", "a ratio", bounds, found).outcome;
  };
  CHECK(outcome({1.5, 2}, {1.5, 1.7, 2}) == Outcome::reproduced);
  CHECK(outcome({1.5, 2}, {1.49, 1.7}) == Outcome::refuted);
  CHECK(outcome({1.5}, {1e9}) == Outcome::reproduced);
  CHECK(outcome({0, 0}, {0}) == Outcome::reproduced);
  CHECK(outcome({0, 0}, {1e-9}) == Outcome::refuted);
  CHECK(outcome({1.5}, {}) == Outcome::not_testable);
  CHECK(outcome({1.5}, {2, std::nan("")}) == Outcome::not_testable);
  CHECK(untested("R-1", "a claim", "why").outcome == Outcome::not_testable);
  CHECK(later("R-1", "a claim", "what").outcome == Outcome::later);
}

TEST_CASE("the threshold is written beside a claim, and what was found") {
  const Claim claim = measured("R-1", "a claim", "a ratio", {1.5, 2}, {1.25, 1.75});
  CHECK(claim.expected == "a ratio: 1.5 to 2");
  CHECK(claim.found == "1.25 to 1.75, 1 of 2 within");
  CHECK(measured("R-1", "", "a ratio", {1.5}, {3}).expected == "a ratio: at least 1.5");
  CHECK(measured("R-1", "", "a ratio", {.most = 3}, {3}).expected == "a ratio: at most 3");
  CHECK(measured("R-1", "", "a count", {0, 0}, {0}).expected == "a count: 0");
  CHECK(measured("R-1", "", "a count", {0, 0}, {0}).found == "0");
  CHECK(tally_of({claim, later("R-2", "", ""), claim}) == "2 refuted, 1 later");
}

TEST_CASE("methods run as in their papers: what is ours is off, what is asked for stays") {
  const MethodSetting affine = paper_setting(formula_methods(), "affine", {{"eps-rel", "0.01"}});
  CHECK(affine.set.at("trim") == "0");
  CHECK(affine.set.at("rounding") == "nearest");
  CHECK(affine.set.at("eps-rel") == "0.01");
  CHECK_THAT(affine.text, Catch::Contains("eps-rel=0.01 ") && Catch::Contains("rounding=nearest trim=0"));
  CHECK_FALSE(paper_setting(formula_methods(), "interval").set.contains("trim"));
  CHECK(paper_setting(volume_methods(), "marmitt").text.empty());
  CHECK(paper_setting(formula_methods(), "interval", {{"rounding", "outward"}}).set.at("rounding") ==
        "outward");
  CHECK_THROWS_AS(paper_setting(formula_methods(), "affine", {{"iterations", "3"}}), InputError);
}

TEST_CASE("rows are found by all that names them") {
  Row row;
  row.case_name = "ball", row.method = "affine", row.setting = "trim=0", row.isa = "scalar";
  row.precision = "float", row.seconds = 2;
  PaperRows rows;
  rows.add({row});
  CHECK(rows.seconds("ball", "affine", "trim=0", Isa::scalar) == 2);
  CHECK(std::isnan(rows.seconds("ball", "affine", "", Isa::scalar)));
  CHECK(rows.find("ball", "affine", "trim=0", Isa::scalar, "double") == nullptr);
  CHECK(rows.find("ball", "affine", "trim=0", Isa::avx2) == nullptr);
  CHECK(table_number(std::nan("")) == "–");
}

TEST_CASE("the papers, from end to end") {
  const test::TemporaryFolder folder;
  Report report;
  report.papers = run_papers({.quick = true, .folder = folder.path, .data = {}, .cache = {}});
  REQUIRE(report.papers.size() == 5);
  std::set<std::string> tables, claims;
  for (const Paper& paper : report.papers) {
    for (const PaperTable& table : paper.tables) {
      INFO(table.id);
      tables.insert(table.id);
      CHECK_FALSE(table.rows.empty());
      for (const auto& row : table.rows) CHECK(row.size() == table.columns.size());
    }
    for (const Claim& claim : paper.claims) {
      INFO(claim.id << " " << claim.sentence);
      claims.insert(claim.id);
      CHECK_FALSE(claim.found.empty());
      if (claim.outcome == Outcome::reproduced || claim.outcome == Outcome::refuted)
        CHECK_FALSE(claim.expected.empty());
    }
    for (const Row& row : paper.rows) {
      CHECK(row.suite == "papers");
      CHECK(row.rays > 0);
      CHECK(row.seconds > 0);
    }
  }
  CHECK(tables == std::set<std::string>{"Figure 1", "Normals", "T-GAN-1", "T-GAN-2", "T-KNO-1", "T-KNO-2",
                                        "T-MAR-1", "T-MAR-2", "T-MAR-3", "T-MAR-4", "T-REI-1", "T-REI-2",
                                        "T-REI-3", "T-SIN-1", "T-SIN-2", "T-SIN-3", "T-SIN-4"});
  CHECK(claims.size() == 14 + 23 + 21 + 20 + 9);

  // what does not depend on times
  const auto outcome = [&](std::size_t paper, const char* id) {
    return std::ranges::find(report.papers[paper].claims, id, &Claim::id)->outcome;
  };
  for (const char* id : {"R-MAR-1", "R-MAR-2", "R-MAR-3", "R-MAR-4", "R-MAR-5", "R-MAR-6", "R-MAR-7"})
    CHECK(outcome(0, id) == Outcome::reproduced);
  for (const char* id : {"R-KNO-1", "R-KNO-9", "R-KNO-22"}) CHECK(outcome(1, id) == Outcome::reproduced);
  for (const char* id : {"R-SIN-1", "R-SIN-3", "R-SIN-5", "R-SIN-17"})
    CHECK(outcome(2, id) == Outcome::reproduced);
  for (const char* id : {"R-GAN-4", "R-GAN-7", "R-GAN-8"}) CHECK(outcome(4, id) == Outcome::reproduced);

  for (const char* id : {"R-REI-1", "R-REI-2", "R-REI-10", "R-REI-15", "R-REI-16", "R-REI-20"})
    CHECK(outcome(3, id) == Outcome::reproduced);

  CHECK_THAT(papers_summary(report.papers), Catch::Contains("R-MAR-2       reproduced"));
  const std::string html = html_of(report);
  CHECK(test::is_well_formed(html));
  CHECK_THAT(html, Catch::Contains("5 papers") && Catch::Contains("T-KNO-1: Frames"));
}

TEST_CASE("coefficients of the whole form: those of a plane are its values at the corners") {
  const FormulaSource plane{parse_expression("x+2*y-3*z+0.5"), {}};
  const Box box{{-1, -1, -1}, {1, 1, 1}};
  const View view(frame(box, {}, 2), 64, 32);
  const DepthRange depths = depths_of(view, box);
  CHECK(depths.near > 0);
  const PixelLines lines = view.lines();
  double largest = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const double u = corner & 1 ? 64 : 0, v = corner & 2 ? 32 : 0, s = corner & 4 ? depths.near : depths.far;
    Double3 p;
    for (int a = 0; a < 3; ++a)
      p[a] = lines.o[a] + u * lines.o_u[a] + v * lines.o_v[a] +
             s * (lines.d[a] + u * lines.d_u[a] + v * lines.d_v[a]);
    largest = std::max(largest, std::abs(p[0] + 2 * p[1] - 3 * p[2] + 0.5));
  }
  for (const int degree : {1, 3, 10})
    CHECK(largest_coefficient(plane, degree, view, depths) == Approx(largest));
}

TEST_CASE("nodes of collocation: condition numbers that are known") {
  CHECK(collocation_condition(1, Nodes::even) == Approx(1));
  CHECK(collocation_condition(1, Nodes::chebyshev) == Approx(std::sqrt(2)));
  CHECK(collocation_condition(1, Nodes::even_inside) == Approx(2));
  CHECK(collocation_condition(12, Nodes::even) > 1.5 * collocation_condition(12, Nodes::chebyshev));
}

TEST_CASE("a ball through root finders: steps, errors, edges, times") {
  PictureCase picture = paper_surface("sphere", 256);
  picture.scene.objects.front().source = FormulaSource{parse_expression("x^2+y^2+z^2-0.5"), {}};
  ReimersWishes wishes{{{finder("frustum-lr")}, {finder("frustum-schneider"), true}}, {}, 1, {}};
  wishes.part = {{-2, -2, 0}, {2, 2, 2}};
  const ReimersFindings found = run_finders(picture, wishes);
  REQUIRE(found.results.size() == 3);
  CHECK(found.results[0].row.method == "frustum-mr");
  CHECK(found.results[0].search.depth_max == 0);
  for (const FinderResult& one : found.results) {
    INFO(one.row.method << " " << one.row.precision);
    CHECK(one.row.rays == 256 * 256);
    CHECK(one.row.undecided_reference == 256 * 256 - (256 * 256 + 60) / 61);
    CHECK(one.row.failures() == 0);
    CHECK(one.row.t_error_max < 1e-3);
    CHECK(one.row.seconds > 0);
    CHECK(one.search.steps > 0.5);
    CHECK(one.search.depth_max < 2e-3);
    CHECK(one.search.value_mean < 1e-3);
    CHECK(one.search.other_roots == 0);
    CHECK(one.search.part_wrong <= 2);
    CHECK(one.search.part_hits > 5000);
    CHECK(one.search.part_hits < found.shading.hits);
  }
  CHECK(found.results[1].search.depth_mean > 0);
  CHECK(found.results[2].search.steps > found.results[1].search.steps);
  const ShadingNumbers& shading = found.shading;
  CHECK(shading.angle > 0);
  CHECK(shading.angle < 2);
  CHECK(shading.form_angle > 0);
  CHECK(shading.form_angle < 0.01);
  for (const double seconds : {shading.gradients, shading.neighbours, shading.frame, shading.silhouettes})
    CHECK(seconds > 0);
}

TEST_CASE("what the text of a paper holds is escaped") {
  Report report;
  report.papers = {{"a <b> & c",
                    {"1 < 2"},
                    {{"T-1", "a <table>", {"<name>", "x"}, {{"<row>", "&"}}}},
                    {measured("R-<1>", "a < b", "<what>", {1}, {1})},
                    {}}};
  const std::string html = html_of(report);
  CHECK(test::is_well_formed(html));
  CHECK_THAT(html, Catch::Contains("R-&lt;1&gt;") && Catch::Contains("1 paper ·"));
}

TEST_CASE("chords of a volume end at the first crossing and hold both sides") {
  const test::TemporaryFolder folder;
  PictureCase picture{"papers", "ball", {}, 32, 32};
  const std::filesystem::path file = folder / "ball.nrrd";
  write_field(formula_field(parse_expression("x^2+y^2+z^2")), {{12, 12, 12}, {}}, file, {});
  picture.scene.objects.front().source = VolumeSource{file, {}};
  picture.scene.objects.front().iso = {0.5};
  const BuiltScene built = build_scene(picture.scene, {});
  const std::vector<RayStream> rays = primary_rays(picture, built.scene.bounds());
  const CellCase cells = volume_chords(built, rays, 1000000);
  REQUIRE(cells.chords.size() == cells.truth.size());
  const PictureTruth truth = solve_picture(picture.scene, built, rays, {});
  const auto hits =
      std::ranges::count_if(truth.rays, [](const auto& ray) { return first_crossing(ray) != nullptr; });
  const auto crossings = std::ranges::count_if(
      cells.truth, [](const auto& cell) { return reference::first_crossing(cell).has_value(); });
  CHECK(hits > 100);
  CHECK(std::abs(crossings - hits) <= hits / 100);  // chords are rounded to float
  for (const reference::CellChord& chord : cells.chords) {
    CHECK(std::ranges::min(chord.f) < 0);
    CHECK(std::ranges::max(chord.f) >= 0);
  }
  const std::size_t few = volume_chords(built, rays, 10).chords.size();
  CHECK(few >= 10);
  CHECK(few < cells.chords.size());
}
