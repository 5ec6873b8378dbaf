// What the paper claims of the five intersectors (Marmitt et al., VMV 2004), against the exact reference.
#include <isocast/apps/bench/cell_families.h>
#include <isocast/apps/bench/judge.h>
#include <volume/cell/diagonal_cell.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace isocast;
using namespace isocast::bench;
using reference::CellChord;

namespace {

struct Cells {
  std::vector<CellChord> chords;
  std::vector<reference::CellReference> truth;
};

Cells cells_of(std::string_view family, std::uint64_t count) {
  Cells cells{make_cells(cell_family(family), 21, 0, count, Rounding::to_float), {}};
  cells.truth = reference::solve(cells.chords);
  return cells;
}

int crossings(const reference::CellReference& truth) {
  return static_cast<int>(std::count_if(truth.roots, truth.roots + truth.root_count,
                                        [](const auto& root) { return root.crossing; }));
}

// How often each verdict was given, and the mean error of the hits.
struct Tally {
  int verdicts[5] = {};
  double mean_error = 0;
  [[nodiscard]] int of(Verdict v) const { return verdicts[static_cast<int>(v)]; }
  [[nodiscard]] int wrong() const {
    return of(Verdict::false_hit) + of(Verdict::false_miss) + of(Verdict::wrong_root);
  }
};

template <class T> Tally tally(const Cells& cells, CellMethod method, const CellOptions& options) {
  const auto roots = bench::solve(widest_isa(), method, options, packets_of<T>(cells.chords));
  Tally result;
  for (std::size_t n = 0; n < cells.chords.size(); ++n) {
    const Answer answer = answer_of(roots, n);
    const Judgement judgement = judge(cells.truth[n], answer.hit, answer.s);
    ++result.verdicts[static_cast<int>(judgement.verdict)];
    result.mean_error += judgement.error;
  }
  result.mean_error /= std::max(1, result.of(Verdict::hit) + result.of(Verdict::wrong_root));
  return result;
}

constexpr CellOptions kMarmitt = {.adaptive = true};
constexpr const char* kPaperFamilies[] = {"random",    "smooth",    "mc-1-corner", "mc-2-edge",
                                          "mc-2-face", "mc-2-cube", "mc-3-face",   "mc-4-face"};

}  // namespace

TEST_CASE("R-MAR-1: midpoint hits wherever a ray enters a cell of mixed signs, in the middle") {
  const Cells cells = cells_of("random", 5000);
  const auto roots = bench::solve(widest_isa(), CellMethod::midpoint, {}, packets_of<float>(cells.chords));
  int without_root = 0;
  for (std::size_t n = 0; n < cells.chords.size(); ++n) {
    const auto& f = cells.chords[n].f;
    const auto negatives = std::count_if(std::begin(f), std::end(f), [](double x) { return x < 0; });
    const Answer answer = answer_of(roots, n);
    REQUIRE(answer.hit == (negatives > 0 && negatives < 8));
    if (answer.hit) REQUIRE(answer.s == 0.5);
    without_root += answer.hit && !first_crossing(cells.truth[n]);
  }
  CHECK(without_root > 1000);
}

TEST_CASE("R-MAR-2, 3, 4: linear and Neubauer miss two roots in a cell, however many iterations") {
  const Cells cells = cells_of("random", 20'000);
  const auto packets = packets_of<double>(cells.chords);
  const auto linear = bench::solve(widest_isa(), CellMethod::linear, {}, packets);
  const auto two = bench::solve(widest_isa(), CellMethod::neubauer, {.iterations = 2}, packets);
  const auto ten = bench::solve(widest_isa(), CellMethod::neubauer, {.iterations = 10}, packets);
  int with_two = 0;
  for (std::size_t n = 0; n < cells.chords.size(); ++n) {
    const bool odd = crossings(cells.truth[n]) % 2 == 1;
    with_two += crossings(cells.truth[n]) == 2;
    REQUIRE(answer_of(linear, n).hit == odd);
    REQUIRE(answer_of(two, n).hit == odd);
    REQUIRE(answer_of(ten, n).hit == odd);
  }
  CHECK(with_two > 500);
  CHECK(tally<double>(cells, CellMethod::neubauer, {.iterations = 2}).of(Verdict::false_miss) == with_two);
  CHECK(tally<double>(cells, CellMethod::neubauer, {.iterations = 10}).of(Verdict::false_miss) == with_two);
}

TEST_CASE("R-MAR-3: Neubauer may return the last of three roots, and is nearer than linear elsewhere") {
  const CellChord three = test::diagonal_cell_with_roots(1, 0.125, 0.1875, 0.9375);
  const auto packets = packets_of<double>(std::span(&three, 1));
  const Answer neubauer =
      answer_of(bench::solve(widest_isa(), CellMethod::neubauer, {.iterations = 10}, packets), 0);
  const Answer marmitt = answer_of(bench::solve(widest_isa(), CellMethod::marmitt, kMarmitt, packets), 0);
  CHECK(neubauer.hit);
  CHECK(neubauer.s == Approx(0.9375).margin(1e-3));
  CHECK(marmitt.hit);
  CHECK(marmitt.s == Approx(0.125).margin(1e-13));
  const Cells cells = cells_of("smooth", 5000);
  const double by_linear = tally<double>(cells, CellMethod::linear, {}).mean_error;
  const double by_neubauer = tally<double>(cells, CellMethod::neubauer, {.iterations = 2}).mean_error;
  CHECK(by_neubauer < 0.05 * by_linear);
}

TEST_CASE("R-MAR-5: Schwarze and marmitt both agree with the reference in double") {
  for (const char* family : kPaperFamilies) {
    INFO(family);
    const Cells cells = cells_of(family, 5000);
    const Tally schwarze = tally<double>(cells, CellMethod::schwarze, {}),
                marmitt = tally<double>(cells, CellMethod::marmitt, kMarmitt);
    CHECK(schwarze.wrong() == 0);
    CHECK(marmitt.wrong() == 0);
    CHECK(schwarze.of(Verdict::hit) == marmitt.of(Verdict::hit));
    CHECK(schwarze.mean_error < 1e-9);
    CHECK(marmitt.mean_error < 1e-14);
  }
}

TEST_CASE("R-MAR-7: in float marmitt is right more often than Schwarze on the same cells, and nearer") {
  int wrong_by_schwarze = 0, wrong_by_marmitt = 0;
  double error_of_schwarze = 0, error_of_marmitt = 0;
  for (const CellFamily& family : cell_families()) {
    INFO(family.name);
    const Cells cells = cells_of(family.name, 1000);
    const Tally schwarze = tally<float>(cells, CellMethod::schwarze, {}),
                marmitt = tally<float>(cells, CellMethod::marmitt, kMarmitt);
    wrong_by_schwarze += schwarze.wrong();
    wrong_by_marmitt += marmitt.wrong();
    error_of_schwarze += schwarze.mean_error;
    error_of_marmitt += marmitt.mean_error;
  }
  CAPTURE(wrong_by_marmitt, wrong_by_schwarze, error_of_marmitt, error_of_schwarze);
  CHECK(wrong_by_marmitt < wrong_by_schwarze);
  CHECK(error_of_marmitt < error_of_schwarze);
}

TEMPLATE_TEST_CASE("R-MAR-13: bilinear values on the face give the same bits", "", float, double) {
  for (const CellMethod method : {CellMethod::linear, CellMethod::neubauer})
    for (const CellFamily& family : cell_families()) {
      if (family.name == "denormal") continue;  // a zero that underflowed has either sign
      const auto packets = packets_of<TestType>(make_cells(family, 22, 0, 2000, Rounding::to_float));
      const auto trilinear = bench::solve(widest_isa(), method, {.face = false}, packets);
      const auto bilinear = bench::solve(widest_isa(), method, {.face = true}, packets);
      for (std::size_t n = 0; n < 2000; ++n) {
        const Answer a = answer_of(trilinear, n), b = answer_of(bilinear, n);
        REQUIRE(a.hit == b.hit);
        if (a.hit) REQUIRE(a.s == b.s);
      }
    }
}
