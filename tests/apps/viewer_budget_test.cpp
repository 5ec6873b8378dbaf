// Previews: how coarse they are, and that there is always one at the end of the frame budget.
#include <isocast/apps/viewer/best_in_time.h>
#include <isocast/apps/viewer/render_loop.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <thread>

using namespace isocast;
using namespace isocast::viewer;

namespace {

void breathe() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

Picture picture_with(int divisor) {
  Picture picture;
  picture.divisor = divisor;
  return picture;
}

Wish slow_wish(double budget_ms) {
  Wish wish;
  wish.words.input = "@chmutov_18";
  wish.words.size = "512x512";
  wish.budget_ms = budget_ms;
  return wish;
}

constexpr double kForever = 1e8, kNoTime = 1e-3;  // ms

}  // namespace

TEST_CASE("the resolution of previews follows what pictures cost") {
  FrameBudget budget;
  CHECK_FALSE(budget.knows_previews());
  CHECK(budget.divisor(33) == 1);  // as far as time allows
  budget.note_ended(1, 5);  // a full one that was not wanted for long: it may have been near its end or not
  CHECK_FALSE(budget.full_is_near(33));
  budget.note(256, 1);  // more than four minutes for all pixels
  CHECK(budget.divisor(33) == 54);
  budget.note(64, 1);  // no: it is every picture that takes a millisecond
  CHECK(budget.divisor(33) == 14);
  budget.note(8, 10);  // 640 ms for all pixels
  CHECK(budget.divisor(33) == 6);
  budget.note(6, 100);
  CHECK(budget.divisor(33) == 13);
  for (int i = 0; i < 20; ++i) budget.note(4, 1);
  CHECK(budget.divisor(33) == 2);
  budget.note(1, 20);
  CHECK(budget.divisor(33) == 1);
  CHECK(budget.full_is_near(33));
  budget.note_ended(1, 400);
  CHECK_FALSE(budget.full_is_near(33));
  CHECK(budget.divisor(33) == 2);
  budget.note_ended(2, 1e9);
  CHECK(budget.divisor(33) == kCoarsest);
  budget.forget();
  CHECK_FALSE(budget.knows_previews());
}

TEST_CASE("in time only the best picture is shown") {
  std::vector<int> shown;
  bool over = false;
  {
    BestInTime best(
        Clock::now() + milliseconds(kForever),
        [&](const Picture& picture) { shown.push_back(picture.divisor); }, [&] { over = true; });
    best.keep(picture_with(16));
    best.keep(picture_with(4));
    CHECK(shown.empty());
    best.show_now(picture_with(1));
  }
  CHECK(shown == std::vector{1});
  CHECK_FALSE(over);
}

TEST_CASE("at the end of the budget what there is is shown") {
  std::vector<int> shown;
  std::atomic<bool> over = false;
  const Clock::time_point end = Clock::now() + std::chrono::milliseconds(30);
  BestInTime best(
      end, [&](const Picture& picture) { shown.push_back(picture.divisor); }, [&] { over = true; });
  best.keep(picture_with(64));
  best.keep(picture_with(16));
  while (!over) breathe();
  CHECK(Clock::now() >= end);
  CHECK(shown == std::vector{16});
  best.keep(picture_with(4));
  best.show_now(picture_with(1));
  CHECK(shown == std::vector{16, 4, 1});
}

TEST_CASE("a budget that is long enough is waited for, another one shows the coarsest picture first") {
  for (const double budget : {kForever, kNoTime}) {
    std::vector<Picture> shown;
    RenderLoop* asked = nullptr;
    RenderLoop loop([&] {
      const auto picture = asked ? asked->picture() : nullptr;
      if (picture && (shown.empty() || shown.back().divisor != picture->divisor)) shown.push_back(*picture);
    });
    asked = &loop;
    Wish wish = slow_wish(budget);
    wish.words.input = "@tangle";
    loop.ask(wish);
    while (!loop.at_rest()) breathe();
    REQUIRE_FALSE(shown.empty());
    CHECK(shown.back().stage == Stage::final);
    if (budget == kForever) CHECK(shown.size() == 1);
    else {
      CHECK(shown.front().divisor == kCoarsest);
      CHECK(shown.front().width == 512 / kCoarsest);
      CHECK(std::ranges::is_sorted(shown, std::greater(), &Picture::divisor));
    }
  }
}

TEST_CASE("a slow formula in no time: every wish that is begun has its picture") {
  RenderLoop loop;
  Wish wish = slow_wish(kNoTime);
  std::uint64_t seen = 0;
  for (int i = 0; i < 20; ++i) {
    wish.words.position = std::to_string(3 + 0.01 * i) + ",-4,2";
    const std::uint64_t revision = loop.ask(wish);
    // it must come, though work on the next picture never ends in the budget
    while (!loop.picture() || loop.picture()->revision < revision) breathe();
    CHECK(loop.picture()->divisor > 1);
    CHECK(loop.picture()->revision > seen);
    seen = loop.picture()->revision;
  }
  CHECK(loop.counts().pictures[static_cast<std::size_t>(Stage::preview)] >= 20);
  CHECK(loop.counts().pictures[static_cast<std::size_t>(Stage::final)] == 0);
}
