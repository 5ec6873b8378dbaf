// Colours along a range.
#include <input_error.h>
#include <isocast/scene/color_map.h>
#include <isocast/scene/srgb.h>

#include <catch2/catch.hpp>
#include <limits>

using namespace isocast;
using test::says;

TEST_CASE("colour maps begin and end as published, and rise between") {
  const ColorMap viridis = color_map_from_name("viridis");
  const auto is = [](const Color& color, int r, int g, int b) {
    const int expected[3] = {r, g, b};
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(color[c] == Approx(linear_from_srgb(expected[c] / 255.0)).margin(1e-6));
  };
  is(viridis.at(0), 0x44, 0x01, 0x54);
  is(viridis.at(0.5), 0x21, 0x91, 0x8c);
  is(viridis.at(1), 0xfd, 0xe7, 0x25);
  is(viridis.at(-3), 0x44, 0x01, 0x54);
  is(viridis.at(3), 0xfd, 0xe7, 0x25);
  CHECK(viridis.at(std::numeric_limits<double>::quiet_NaN()) == Color{0.5f, 0.5f, 0.5f});
  is(color_map_from_name("coolwarm").at(0.5), 0xdd, 0xdd, 0xdd);
  is(color_map_from_name("grey").at(0.2), 51, 51, 51);
  for (const char* const name : {"viridis", "plasma", "magma", "inferno", "grey"}) {
    const ColorMap map = color_map_from_name(name);
    double last = -1;
    for (double x = 0; x <= 1; x += 0.01) {
      const Color color = map.at(x);
      const double light = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
      CHECK(light >= last);
      last = light;
    }
  }
}

TEST_CASE("a step between two points stays a step") {
  const ColorMap map({{0, {0, 0, 0}}, {0.5, {0, 0, 0}}, {0.5, {1, 1, 1}}, {1, {1, 1, 1}}});
  CHECK(map.at(0.499)[0] == 0);
  CHECK(map.at(0.501)[0] == 1);
}

TEST_CASE("unknown maps are told with those that there are") {
  CHECK_THROWS_MATCHES(color_map_from_name("jet"), InputError,
                       says("found the colour map 'jet', expected one of: viridis"));
}
