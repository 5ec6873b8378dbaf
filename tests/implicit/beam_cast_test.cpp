// beam-uniform and beam-adaptive: what they throw away holds no root, and both throw away the same.
#include <implicit/framed_rays.h>
#include <implicit/random_camera.h>
#include <isocast/implicit/expression/parse.h>
#include <isocast/implicit/implicit_surface.h>
#include <test_size.h>

#include <catch2/catch.hpp>
#include <map>
#include <vector>

using namespace isocast;
using namespace isocast::test;

namespace {

const Domain kBox = {{-2, -2, -2}, {2, 2, 2}};
using Settings = std::map<std::string, std::string>;

ImplicitSurface surface_of(const char* formula, const char* method, const Settings& settings,
                           bool precise = false, Isa isa = widest_isa()) {
  ImplicitSurfaceOptions options;
  options.method = choose_formula_method(method, settings);
  options.double_precision = precise;
  options.isa = isa;
  return ImplicitSurface(parse_expression(formula), kBox, options);
}

std::vector<HitStream> picture_of(const Surface& surface, const View& view) {
  std::vector<HitStream> tiles;
  each_tile_of_pass(surface, view, [&](const RayStream&, const HitStream& hits) { tiles.push_back(hits); });
  return tiles;
}
int hit_count(const std::vector<HitStream>& picture) {
  int count = 0;
  for (const HitStream& hits : picture)
    for (int i = 0; i < kStreamSize; ++i) count += is_hit(hits, i);
  return count;
}

constexpr const char* kFormulas[] = {"x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8",
                                     "sin(4*x)+sin(4*y)+sin(4*z)",
                                     "x^2 + y^2 - 0.0004",
                                     "1/x + y*z",
                                     "exp(-4*(x^2+y^2)) - z^2",
                                     "x - 0.3*y"};

}  // namespace

TEST_CASE("beams that are thrown away hold no root", "[property]") {
  std::mt19937_64 random(13);
  std::uniform_real_distribution<double> unit(0, 1);
  std::int64_t empty = 0, painted = 0;
  for (std::int64_t n = 0, count = cases(24, 1000); n < count; ++n) {
    const char* formula = kFormulas[n % 6];
    const char* method = n % 4 < 2 ? "beam-adaptive" : "beam-uniform";
    const Settings settings = {
        {"form", n % 2 ? "affine" : "interval"}, {"depth", n % 3 ? "0" : "1"}, {"eps", "0.004"}};
    INFO(formula << " " << method << " " << settings.at("form") << " depth " << settings.at("depth"));
    const View view(random_camera(random), 37, 45);
    const bool precise = n % 5 == 0;
    const ImplicitSurface beams = surface_of(formula, method, settings, precise),
                          truth = surface_of(formula, "affine", {}, true);
    std::vector<HitStream> picture = picture_of(beams, view);
    for (const Isa isa : available_isas()) {
      const std::vector<HitStream> same =
          picture_of(surface_of(formula, method, settings, precise, isa), view);
      for (std::size_t tile = 0; tile < same.size(); ++tile)
        require_same_bits(picture[tile], same[tile], kStreamSize);
    }
    // rays through anywhere in the pixels
    const int columns = (view.width() + kTileSize - 1) / kTileSize;
    for (int look = 0; look < 8; ++look) {
      const double u = look == 0   ? 0
                       : look == 1 ? 1
                                   : unit(random),
                   v = look == 0   ? 0
                       : look == 1 ? 1
                                   : unit(random);
      int tile = 0;
      each_tile_of_pass(beams, view, [&](const RayStream& middle, const HitStream&) {
        const HitStream& found = picture[static_cast<std::size_t>(tile++)];
        RayStream rays;
        const int x = static_cast<int>(middle.id[0]) % view.width() / kTileSize,
                  y = static_cast<int>(middle.id[0]) / view.width() / kTileSize;
        REQUIRE(x < columns);
        view.fill(x, y, u, v, rays);
        rays.kind = RayKind::reflection;
        const HitStream roots = first_hits(truth, rays);
        for (int i = 0; i < rays.size; ++i) {
          if (!is_ray(rays, i)) continue;
          INFO(std::hexfloat << rays.ox[i] << " " << rays.oy[i] << " " << rays.oz[i] << " towards "
                             << rays.dx[i] << " " << rays.dy[i] << " " << rays.dz[i]);
          REQUIRE(found.certificate[i] ==
                  (is_hit(found, i) ? Certificate::undecided : Certificate::proved_miss));
          (is_hit(found, i) ? painted : empty) += 1;
          if (roots.certificate[i] != Certificate::proved_hit) continue;
          REQUIRE(is_hit(found, i));
          // in depth: not before what the pixel's beam was cut to
          const Double3& forward = view.forward();
          const double root = roots.t_hi[i] * dot(direction_of(rays, i), forward),
                       cut = found.t_lo[i] * dot(direction_of(middle, i), forward);
          REQUIRE(root >= cut - 1e-9 * std::abs(cut));
        }
      });
    }
  }
  CHECK(empty > 10000);
  CHECK(painted > 10000);
}

TEST_CASE("adaptive beams paint what uniform ones do") {
  for (const char* formula : kFormulas)
    for (const char* form : {"interval", "affine"}) {
      INFO(formula << " " << form);
      const View view(frame(surface_of(formula, "affine", {}).bounds(), {}, 1), 96, 96);
      const Settings settings = {{"form", form}, {"eps", "0.0005"}};
      const std::vector<HitStream> adaptive =
                                       picture_of(surface_of(formula, "beam-adaptive", settings), view),
                                   uniform = picture_of(surface_of(formula, "beam-uniform", settings), view);
      int differ = 0;
      double farthest = 0;
      for (std::size_t tile = 0; tile < adaptive.size(); ++tile)
        for (int i = 0; i < kStreamSize; ++i) {
          differ += is_hit(adaptive[tile], i) != is_hit(uniform[tile], i);
          if (is_hit(adaptive[tile], i) && is_hit(uniform[tile], i))
            farthest = std::max(farthest, std::abs(adaptive[tile].t[i] - uniform[tile].t[i]));
        }
      CHECK(differ <= 0.005 * hit_count(uniform));
      CHECK(farthest < 4);
    }
}

TEST_CASE("finer levels throw away more, and coarse levels what is far") {
  const char* thin = "x^2 + y^2 - 0.0004";
  const View view(frame(surface_of(thin, "affine", {}).bounds(), {}, 1), 64, 64);
  int before = 1 << 20;
  for (const char* depth : {"0", "1", "2"}) {
    const Settings settings = {{"depth", depth}, {"eps", "0.002"}};
    const int count = hit_count(picture_of(surface_of(kFormulas[0], "beam-adaptive", settings), view));
    CHECK(count < before);
    before = count;
    // a thread thinner than a pixel stays
    CHECK(hit_count(picture_of(surface_of(thin, "beam-adaptive", settings), view)) > 30);
  }
  // the level map
  const auto picture = picture_of(surface_of(thin, "beam-adaptive", {}), view);
  std::map<std::uint32_t, int> levels;
  for (const HitStream& hits : picture)
    for (int i = 0; i < kStreamSize; ++i) {
      if (is_hit(hits, i)) CHECK(hits.cost[i] == 8);
      else ++levels[hits.cost[i]];
    }
  CHECK(levels.begin()->first <= 3);
  CHECK(levels.rbegin()->first == 7);
}
