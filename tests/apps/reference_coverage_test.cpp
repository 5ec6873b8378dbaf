// How many of the rays that pictures of the catalogue are made of the reference decides.
#include <fmt/format.h>
#include <isocast/apps/bench/picture_reference.h>
#include <isocast/implicit/expression/catalogue.h>
#include <test_size.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

using namespace isocast;
using namespace isocast::bench;

namespace {

const char* name_of(reference::Doubt doubt) {
  constexpr const char* kNames[] = {"touch", "zero", "jump", "undefined", "work"};
  return kNames[static_cast<int>(doubt)];
}

// All rays of the default camera, without a cache.
PictureTruth truth_of(const CatalogueSurface& record, int size) {
  PictureCase picture{"surfaces", record.id, {}, size, size};
  picture.scene.objects.front().source = FormulaSource{surface_expression(record), record.domain};
  const BuiltScene built = build_scene(picture.scene, {});
  return solve_picture(picture.scene, built, primary_rays(picture, built.scene.bounds()), {});
}

std::string doubts_of(const PictureTruth& truth) {
  std::map<std::string, int> counts;
  for (const reference::RayTruth& ray : truth.rays)
    if (!ray.decided()) ++counts[name_of(ray.doubts.front().doubt)];
  std::string text;
  for (const auto& [name, count] : counts) text += fmt::format(" {} {}", count, name);
  return text;
}

}  // namespace

TEST_CASE("the reference decides 99.9 % of the catalogue's rays", "[property]") {
  const int size = static_cast<int>(test::cases(16, 128));
  std::int64_t rays = 0, undecided = 0, crossed = 0;
  std::string exceptions;
  for (const CatalogueSurface& record : catalogue()) {
    const PictureTruth truth = truth_of(record, size);
    const std::int64_t count = undecided_rays(truth), all = std::ssize(truth.rays);
    rays += all;
    undecided += count;
    crossed +=
        std::ranges::count_if(truth.rays, [](const auto& ray) { return first_crossing(ray) != nullptr; });
    if (1000 * count > all)
      exceptions += fmt::format("{}: {} of {} rays undecided:{}\n", record.id, count, all, doubts_of(truth));
  }
  INFO(exceptions << undecided << " of " << rays << " rays undecided, " << crossed << " with a crossing");
  CHECK(1000 * undecided <= rays);
  CHECK(10 * crossed > rays);
}
