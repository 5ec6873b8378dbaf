// What compare says of two pictures, on made-up layers.
#include <input_error.h>
#include <isocast/apps/isocast/compare_images.h>

#include <cmath>
#include <limits>

using namespace isocast;
using test::says;

namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();

// A row of pixels, channel by channel.
Image picture(const std::vector<std::string>& channels, const std::vector<std::vector<float>>& values) {
  Image image{static_cast<int>(values.front().size()), 1, channels, {}};
  for (std::size_t x = 0; x < values.front().size(); ++x)
    for (std::size_t c = 0; c < channels.size(); ++c) image.pixels.push_back(values[c][x]);
  return image;
}
Image depths(const std::vector<float>& values) { return picture({"depth"}, {values}); }

}  // namespace

TEST_CASE("depth: over the pixels that both hit, with ranks and the worst first") {
  std::vector<float> a, b;
  for (int i = 0; i < 100; ++i) {
    a.push_back(float(i));
    b.push_back(float(i) + 0.25f * float(i % 10 == 9) + 1.0f * float(i == 70));
  }
  a[3] = b[5] = a[8] = b[8] = kInf;
  const Comparison c = compare_images(depths(a), depths(b));
  CHECK(c.mask.by == "depth");
  CHECK(c.mask.both == 97);
  CHECK(c.mask.only_a == 1);
  CHECK(c.mask.only_b == 1);
  CHECK(c.mask.neither == 1);
  REQUIRE(c.mask.first.size() == 2);
  CHECK(c.mask.first[0].x == 3);
  REQUIRE(c.layers.size() == 1);
  const LayerDifference& depth = c.layers[0];
  CHECK(depth.pixels == 97);
  CHECK(depth.p50 == 0);
  CHECK(depth.p90 == 0.25);
  CHECK(depth.p99 == 1);
  CHECK(depth.max == 1);
  REQUIRE(depth.worst.size() == 10);
  CHECK(depth.worst[0].x == 70);
  CHECK(depth.worst[0].difference == 1);
  CHECK(depth.worst[1].difference == 0.25);
  CHECK_FALSE(c.within(10));  // other pixels are hit
}

TEST_CASE("the tolerance is for each layer, angles in radians") {
  const std::vector<std::string> channels = {"R", "G", "B", "A", "depth", "normal.X", "normal.Y", "normal.Z"};
  std::vector<std::vector<float>> values(8, {0.5f, 0.5f});
  values[4] = {2, kInf};
  values[5] = {1, 0}, values[6] = values[7] = {0, 0};
  const Image a = picture(channels, values);
  CHECK(compare_images(a, a).within(0));
  SECTION("colour counts beside the surface too, and alpha") {
    values[3][1] = 0.25f;
    const Comparison c = compare_images(a, picture(channels, values));
    REQUIRE(c.layers.size() == 3);
    CHECK(c.layers[2].name == "color");
    CHECK(c.layers[2].max == 0.25);
    CHECK(c.layers[2].worst.size() == 1);
    CHECK(c.layers[2].worst[0].x == 1);
    CHECK_FALSE(c.within(0.24));
    CHECK(c.within(0.25));
  }
  SECTION("normals") {
    values[5][0] = 0.8f, values[6][0] = 0.6f;
    values[7][1] = 1;  // not a hit
    const Comparison c = compare_images(a, picture(channels, values));
    CHECK(c.layers[1].max == Approx(36.8699));
    CHECK_FALSE(c.within(0.64));
    CHECK(c.within(0.65));
  }
  SECTION("NaN in one is far away, in both it is the same") {
    values[4][0] = values[0][1] = std::nanf("");
    const Image b = picture(channels, values);
    CHECK(compare_images(b, b).within(0));
    const Comparison c = compare_images(a, b);
    CHECK(c.mask.only_a == 1);
    CHECK(c.layers[2].max == kInf);
    CHECK_FALSE(c.within(1e300));
  }
}

TEST_CASE("without depth the mask comes from z, id or alpha") {
  const std::vector<float> zero = {0, 0, 0}, some = {0, 2, 2};
  CHECK(compare_images(picture({"z", "id"}, {{kInf, 1, 2}, zero}), picture({"z"}, {{1, 1, kInf}})).mask.by ==
        "z");
  const Comparison by_id =
      compare_images(picture({"id", "R", "G", "B", "A"}, {some, zero, zero, zero, zero}),
                     picture({"R", "G", "B", "A", "id"}, {zero, zero, zero, zero, zero}));
  CHECK(by_id.mask.by == "id");
  CHECK(by_id.mask.only_a == 2);
  CHECK(by_id.layers[0].max == 0);
  CHECK(compare_images(picture({"R", "G", "B", "A"}, {zero, zero, zero, some}),
                       picture({"R", "G", "B", "A"}, {zero, zero, zero, some}))
            .mask.both == 2);
}

TEST_CASE("every layer is compared, whatever its names; cost and certificate do not decide") {
  const std::vector<std::string> plain = {"depth", "position.X", "position.Y",  "position.Z",
                                          "value", "albedo.R",   "albedo.G",    "albedo.B",
                                          "id",    "object",     "certificate", "cost"},
                                 compositor = {"depth.Z", "P.X",      "P.Y",           "P.Z",
                                               "value.X", "albedo.R", "albedo.G",      "albedo.B",
                                               "id.X",    "object.X", "certificate.X", "cost.X"};
  std::vector<std::vector<float>> a(12, {1, 1}), b = a;
  CHECK(compare_images(picture(plain, a), picture(compositor, b)).within(0));
  b[10] = {0, 0.5f}, b[11] = {7, 100};
  const Comparison methods = compare_images(picture(plain, a), picture(compositor, b));
  CHECK(methods.within(0));
  REQUIRE(methods.layers.size() == 8);
  CHECK(methods.layers[7].max == 99);
  CHECK_FALSE(methods.layers[7].decides);
  for (const auto& [channel, difference] : {std::pair{2, 0.25}, {4, 3.0}, {6, 0.5}, {8, 1.0}, {9, 1.0}}) {
    std::vector<std::vector<float>> c = a;
    c[static_cast<std::size_t>(channel)][1] += channel == 8 ? 4.0f : static_cast<float>(difference);
    const Comparison found = compare_images(picture(plain, a), picture(compositor, c));
    INFO(plain[static_cast<std::size_t>(channel)]);
    CHECK_FALSE(found.within(0.2));
    CHECK(found.within(difference));
  }
  const Comparison other =
      compare_images(picture({"depth", "z"}, {{1}, {1}}), picture({"depth", "id"}, {{1}, {1}}));
  CHECK(other.only_a == std::vector<std::string>{"z"});
  CHECK(other.only_b == std::vector<std::string>{"id"});
}

TEST_CASE("the picture of differences: black, grey, white, red, blue") {
  const Comparison c = compare_images(depths({1, 1, 1, 1, kInf}), depths({1, 1.001f, 2, kInf, 1}));
  const std::vector<float> rgba = difference_picture(c);
  REQUIRE(rgba.size() == 20);
  CHECK(rgba[0] == 0);
  CHECK(rgba[4] == Approx(0.25).margin(1e-3));
  CHECK(rgba[8] == 1);
  CHECK((rgba[12] == 1 && rgba[13] == 0 && rgba[14] == 0));
  CHECK((rgba[16] == 0 && rgba[17] == 0 && rgba[18] == 1));
  for (const float channel : difference_picture(compare_images(depths({1, kInf}), depths({1, kInf}))))
    CHECK((channel == 0 || channel == 1));
}

TEST_CASE("pictures that cannot be compared") {
  CHECK_THROWS_MATCHES(compare_images(depths({1, 2}), depths({1})), InputError, says("2x1 and 1x1 pixels"));
  CHECK_THROWS_MATCHES(compare_images(depths({1}), picture({"z"}, {{1}})), InputError,
                       says("share none of the layers"));
}
