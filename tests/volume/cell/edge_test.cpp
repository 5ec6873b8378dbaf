// Packets at the edge of what is allowed: unused lanes, tiny numbers, parts of chords, touching roots.
#include <isocast/apps/bench/cell_families.h>
#include <isocast/apps/bench/judge.h>
#include <volume/cell/diagonal_cell.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <limits>

using namespace isocast;
using namespace isocast::bench;
using reference::CellChord;

namespace {

constexpr CellMethod kAllMethods[] = {CellMethod::midpoint, CellMethod::linear, CellMethod::neubauer,
                                      CellMethod::schwarze, CellMethod::marmitt};

template <class T> Answer one_answer(CellMethod method, const CellOptions& options, const CellChord& chord) {
  return answer_of(bench::solve(widest_isa(), method, options, packets_of<T>(std::span(&chord, 1))), 0);
}

// A field that is `scale` (x - 1/4) along a chord in x.
CellChord slope_in_x(double scale) {
  CellChord chord{};
  for (int i = 0; i < 8; ++i) chord.f[i] = i & 1 ? 0.75 * scale : -0.25 * scale;
  chord.entry[1] = chord.exit[1] = 0.5;
  chord.entry[2] = chord.exit[2] = 0.25;
  chord.exit[0] = 1;
  return chord;
}

}  // namespace

TEMPLATE_TEST_CASE("inactive lanes report nothing and disturb nobody, whatever they hold", "", float,
                   double) {
  const auto cells = make_cells(cell_family("random"), 31, 0, kPacketSize, Rounding::to_float);
  std::vector<CellPacket<TestType>> clean = packets_of<TestType>(cells), dirty = clean;
  constexpr std::uint32_t kUnused = 0x5a3c;
  clean[0].active = dirty[0].active = 0xffff & ~kUnused;
  for (int lane = 0; lane < kPacketSize; ++lane)
    if (kUnused >> lane & 1)
      for (int i = 0; i < 8; ++i)
        dirty[0].f[i][lane] =
            i % 2 ? std::numeric_limits<TestType>::quiet_NaN() : -std::numeric_limits<TestType>::infinity();
  for (const Isa isa : available_isas())
    for (const CellMethod method : kAllMethods)
      for (const bool adaptive : {false, true}) {
        const auto a = bench::solve(isa, method, {.adaptive = adaptive}, clean),
                   b = bench::solve(isa, method, {.adaptive = adaptive}, dirty);
        REQUIRE(b[0].hit == a[0].hit);
        REQUIRE((b[0].hit & kUnused) == 0);
        REQUIRE((b[0].undecided & kUnused) == 0);
        for (int lane = 0; lane < kPacketSize; ++lane)
          if (a[0].hit >> lane & 1) REQUIRE(std::memcmp(&a[0].s[lane], &b[0].s[lane], sizeof(TestType)) == 0);
      }
  // a packet without any lane
  dirty[0].active = 0;
  for (const CellMethod method : kAllMethods)
    CHECK(bench::solve(widest_isa(), method, {}, dirty)[0].hit == 0);
}

TEST_CASE("signs hold where products underflow") {
  for (const CellMethod method :
       {CellMethod::linear, CellMethod::neubauer, CellMethod::schwarze, CellMethod::marmitt})
    for (const double scale : {1.0, 1e-25, 1e-30, -1e-30, 1e30}) {
      INFO("method " << int(method) << ", scale " << scale);
      const Answer answer = one_answer<float>(method, {.adaptive = true}, slope_in_x(scale));
      CHECK(answer.hit);
      CHECK(answer.s == Approx(0.25).margin(1e-6));
      CHECK(answer.negative_behind == (scale < 0));
    }
}

TEST_CASE("denormal corners: the crossing is found, as near as their few bits allow") {
  for (const CellMethod method : {CellMethod::linear, CellMethod::neubauer, CellMethod::marmitt}) {
    INFO("method " << int(method));
    const Answer answer = one_answer<float>(method, {.adaptive = true}, slope_in_x(1e-40));
    CHECK(answer.hit);
    CHECK(answer.s == Approx(0.25).margin(1e-3));
    CHECK(one_answer<double>(method, {.adaptive = true}, slope_in_x(1e-310)).s == Approx(0.25).margin(1e-3));
    // the smallest numbers there are: nothing but their signs is left
    CellChord smallest = slope_in_x(1);
    for (int i = 0; i < 8; ++i) smallest.f[i] = i & 1 ? 0x1p-149 : -0x1p-149;
    CHECK(one_answer<float>(method, {.adaptive = true}, smallest).hit);
  }
}

TEMPLATE_TEST_CASE("behind a root, with its sign carried on, the next one follows; none is lost or repeated",
                   "", float, double) {
  const CellChord chord = test::diagonal_cell_with_roots(1, 0.125, 0.5, 0.75);
  auto packets = packets_of<TestType>(std::span(&chord, 1));
  for (const double expected : {0.125, 0.5, 0.75}) {
    const Answer answer =
        answer_of(bench::solve(widest_isa(), CellMethod::marmitt, {.adaptive = true}, packets), 0);
    REQUIRE(answer.hit);
    CHECK(answer.s == Approx(expected).margin(2e-6));
    CHECK(answer.negative_behind == (expected == 0.5));
    packets[0].begin[0] = static_cast<TestType>(answer.s_hi);
    packets[0].carry[0] = answer.negative_behind ? -TestType(0) : TestType(0);
  }
  CHECK_FALSE(answer_of(bench::solve(widest_isa(), CellMethod::marmitt, {.adaptive = true}, packets), 0).hit);
}

TEMPLATE_TEST_CASE("carried signs: linear and Neubauer go on without repeating the root", "", float, double) {
  const CellChord chord = slope_in_x(1);
  for (const CellMethod method : {CellMethod::linear, CellMethod::neubauer, CellMethod::marmitt}) {
    auto packets = packets_of<TestType>(std::span(&chord, 1));
    // just before the root, but known to be behind it
    packets[0].begin[0] = TestType(0.2499);
    packets[0].carry[0] = TestType(0);
    CHECK_FALSE(answer_of(bench::solve(widest_isa(), method, {.adaptive = true}, packets), 0).hit);
    packets[0].carry[0] = std::numeric_limits<TestType>::quiet_NaN();
    CHECK(answer_of(bench::solve(widest_isa(), method, {.adaptive = true}, packets), 0).hit);
  }
}

TEMPLATE_TEST_CASE("a touch is a hit with touch=1 only, and undecided", "", float, double) {
  // touches at 1/4 from the negative side but for a little, so that rounding cannot make two crossings of it
  CellChord touching = test::diagonal_cell_with_roots(1, 0.25, 0.25, 1.5);
  for (double& f : touching.f) f -= 8 * std::numeric_limits<TestType>::epsilon() * 0.5;
  CHECK_FALSE(one_answer<TestType>(CellMethod::marmitt, {.adaptive = true, .touch = false}, touching).hit);
  const Answer answer =
      one_answer<TestType>(CellMethod::marmitt, {.adaptive = true, .touch = true}, touching);
  CHECK(answer.hit);
  CHECK(answer.undecided);
  CHECK(answer.s == Approx(0.25).margin(1e-3));
  // far from zero there is nothing to touch
  CHECK_FALSE(one_answer<TestType>(CellMethod::marmitt, {.adaptive = true, .touch = true},
                                   test::diagonal_cell(1, 0.5, 0.5, 1))
                  .hit);
}

TEST_CASE("a zero at entry is a hit only if f is negative behind it; at exit if it was negative before") {
  const auto hit = [](const CellChord& chord) {
    return one_answer<double>(CellMethod::marmitt, {.adaptive = true}, chord).hit;
  };
  CHECK_FALSE(hit(test::diagonal_cell_with_roots(1, 0, 1.5, 2)));
  CHECK(hit(test::diagonal_cell_with_roots(-1, 0, 1.5, 2)));
  CHECK(hit(test::diagonal_cell_with_roots(1, 1, 1.5, 2)));
  CHECK_FALSE(hit(test::diagonal_cell_with_roots(-1, 1, 1.5, 2)));
  CHECK_FALSE(hit(test::diagonal_cell(0, 0, 0, 0)));
}
