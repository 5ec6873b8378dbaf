// marmitt against the exact reference: which root it finds and how near, over all families.
#include <fmt/format.h>
#include <isocast/apps/bench/cell_families.h>
#include <isocast/apps/bench/judge.h>
#include <isocast/math/real.h>
#include <isocast/math/rounding.h>
#include <isocast/volume/cell/cell.h>
#include <test_size.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

using namespace isocast;
using namespace isocast::bench;
using reference::CellChord;
using reference::CellReference;

namespace {

// The documented bound: an answer is right when f at entry, exit and the extrema is farther from zero than
// this many unit roundoffs of max |corner|, and f at the root found is nearer than that, or the root within
// two tolerances. An underflow rounds by the smallest number, so a unit is no less than that.
constexpr double kBound = 8;

double largest_corner(const CellChord& chord) {
  double largest = 0;
  for (const double f : chord.f) largest = std::max(largest, std::abs(f));
  return largest;
}

// |f| where it is nearest to zero without being a root: what rounding may turn over.
double margin(const CellReference& reference) {
  double least = INFINITY;
  for (int i = 0; i < reference.critical_count; ++i)
    least = std::min(least, std::abs(reference.critical[i].value));
  return least;
}

// Cells by margin in unit roundoffs of max |corner|: below 1/64, 1/8, 1, kBound, and above; how many were
// answered wrongly.
struct Counts {
  std::array<std::int64_t, 5> cells{}, wrong{};
  void add(double margin_ulps, bool is_wrong) {
    const double limits[] = {1.0 / 64, 1.0 / 8, 1, kBound};
    const std::size_t bin =
        std::upper_bound(std::begin(limits), std::end(limits), margin_ulps) - std::begin(limits);
    ++cells[bin];
    wrong[bin] += is_wrong;
  }
};

std::string to_text(const Counts& counts) {
  std::string text = "wrong of cells with a margin below 1/64, 1/8, 1, 8 and above:";
  for (std::size_t i = 0; i < counts.cells.size(); ++i)
    text += fmt::format(" {}/{}", counts.wrong[i], counts.cells[i]);
  return text;
}

}  // namespace

TEMPLATE_TEST_CASE("marmitt finds the first root wherever rounding leaves no doubt", "[property]", float,
                   double) {
  constexpr double u = kUnitRoundoff<TestType>, tolerance = kTolerance<TestType>;
  const std::int64_t per_family =
      test::cases(100'000, 10'000'000) / static_cast<std::int64_t>(cell_families().size());
  const std::int64_t slab = std::min<std::int64_t>(per_family, 20'000);
  Counts total;
  double worst_margin = 0, worst_residual = 0;
  for (const CellFamily& family : cell_families()) {
    INFO("family " << family.name);
    double largest_error = 0;
    for (std::int64_t first = 0; first < per_family; first += slab) {
      const auto cells =
          make_cells(family, 5, first, slab, sizeof(TestType) == 4 ? Rounding::to_float : Rounding::none);
      const std::vector<CellReference> references = reference::solve(cells);
      const auto roots =
          bench::solve(widest_isa(), CellMethod::marmitt, {.adaptive = true}, packets_of<TestType>(cells));
      for (std::size_t n = 0; n < cells.size(); ++n) {
        const Answer answer = answer_of(roots, n);
        const Judgement judgement = judge(references[n], answer.hit, answer.s);
        const bool right = judgement.verdict == Verdict::hit || judgement.verdict == Verdict::miss;
        const double unit = std::max<double>(u * largest_corner(cells[n]), kSmallest<TestType>);

        // the right answer, or a value within rounding of zero that decides it
        const double margin_ulps = margin(references[n]) / unit;
        total.add(margin_ulps, !right);
        if (!right) worst_margin = std::max(worst_margin, margin_ulps);

        // near the root, or where f is zero but for rounding
        if (judgement.verdict != Verdict::hit) continue;
        REQUIRE((answer.s_lo <= answer.s && answer.s <= answer.s_hi));
        largest_error = std::max(largest_error, judgement.error);
        if (judgement.error > 2 * tolerance)
          worst_residual =
              std::max(worst_residual, std::abs(reference::exact_value(cells[n], answer.s)) / unit);
      }
    }
    UNSCOPED_INFO(family.name << ": largest error of s " << largest_error);
  }
  INFO(to_text(total));
  INFO("largest margin of a wrong answer "
       << worst_margin << ", largest |f| at a root off by more than two tolerances " << worst_residual);
  CHECK(worst_margin <= kBound);
  CHECK(worst_residual <= kBound);
  CHECK(total.wrong.back() == 0);
  CHECK(total.cells.back() > total.cells.front());
}
