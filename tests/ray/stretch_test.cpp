// When a ray that follows a surface in doubt leaps on.
#include <isocast/ray/stretch.h>

#include <catch2/catch.hpp>
#include <memory>
#include <string_view>

using namespace isocast;

namespace {

// Takes note of crossings at t = 1, 2, ...: u undecided, p proved; the number of the first that is leapt
// behind, or 0, and how far.
struct Leap {
  int behind = 0;
  double length = 0;
};
Leap first_leap(std::string_view crossings) {
  const auto hits = std::make_unique<HitStream>();
  clear(*hits);
  Stretch stretch;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    hits->t[0] = hits->t_lo[0] = hits->t_hi[0] = static_cast<double>(i + 1);
    hits->certificate[0] = crossings[i] == 'u' ? Certificate::undecided : Certificate::proved_hit;
    if (stretch.leaps_behind(*hits, 0)) return {static_cast<int>(i + 1), stretch.length(*hits, 0)};
  }
  return {};
}

}  // namespace

TEST_CASE("a ray leaps behind a row of undecided crossings, as far as the row is long") {
  CHECK(first_leap("uuuuu").behind == 5);
  CHECK(first_leap("uuuuu").length == 4);
  CHECK(first_leap("pppuuuuu").length == 4);
  CHECK(first_leap("uuuu").behind == 0);
}

TEST_CASE("decided crossings between delay a leap and do not prevent it") {
  const Leap leap = first_leap("upupupupupupupupupup");
  CHECK(leap.behind > 5);
  CHECK(leap.behind < 20);
  CHECK(leap.length == leap.behind - 1);
}

TEST_CASE("doubts here and there are no stretch") {
  CHECK(first_leap("uppuppuppuppuppuppuppuppuppuppupp").behind == 0);
  CHECK(first_leap("pppppppppppppppppppppppppppppppp").behind == 0);
}
