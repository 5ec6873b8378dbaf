// Edges between pixels: the picture comes closer to what many samples show, and normals from neighbours.
#include <render/formula_scene.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace isocast;
using namespace isocast::test;

namespace {

double covered(const Film& film) {
  double sum = 0;
  for (std::size_t i = 3; i < film.color().size(); i += 4) sum += film.color()[i];
  return sum;
}

}  // namespace

TEST_CASE("the covered area of a disc is right to a fraction of a pixel's row") {
  Scene scene;
  add_formula(scene, "x^2 + y^2 + z^2 - 1", {Material{}});
  const View view = view_along({0, -5, 0.1}, {0, 0, 0}, 64, 2.5);
  const double area = std::numbers::pi * (64 / 2.5) * (64 / 2.5);
  RenderCounts counts;
  const Film hard = picture(scene, view, {}), soft = picture(scene, view, {.silhouettes = true}, &counts),
             many = picture(scene, view, {.spp = 64});
  CHECK(counts.blended > 100);
  CHECK(counts.blended < 400);
  CHECK(std::abs(covered(soft) - area) < 0.001 * area);
  CHECK(mean_difference(soft, many) < 0.4 * mean_difference(hard, many));
}

TEST_CASE("edges in front of a surface, and where the domain cuts it, are blended too") {
  Scene scene;
  add_formula(scene, "z - 0.3*x*y", {Material{}});
  add_formula(scene, "x^2 + y^2 + (z-1)^2 - 0.5", {Material{{0.9f, 0.1f, 0.1f}, 1, 0}});
  const View view = view_along({1, -5, 4}, {0, 0, 0}, 96, 9);
  const Film hard = picture(scene, view, {}), soft = picture(scene, view, {.silhouettes = true}),
             many = picture(scene, view, {.spp = 64});
  CHECK(mean_difference(soft, many) < 0.5 * mean_difference(hard, many));
}

TEST_CASE("nothing is blended where no edge is, and bytes do not depend on who asks") {
  Scene scene;
  add_formula(scene, "z", {Material{}});
  RenderCounts counts;
  const View inside = view_along({0, 0.1, 5}, {0, 0, 0}, 32, 2);
  const Film soft = picture(scene, inside, {.silhouettes = true}, &counts);
  CHECK(counts.blended == 0);
  CHECK(same_films(soft, picture(scene, inside, {})));
}

TEST_CASE("normals from neighbours are those of the gradient but at edges") {
  const View view = view_along({0, -5, 0.1}, {0, 0, 0}, 128, 2.5);
  ImplicitSurfaceOptions options;
  options.method = choose_formula_method("affine", {});
  options.double_precision = true;
  const auto normals = [&](NormalKind kind) {
    options.normals = kind;
    Scene scene;
    scene.objects.push_back({std::make_shared<ImplicitSurface>(parse_expression("x^2 + y^2 + z^2 - 1"),
                                                               Domain{{-3, -3, -3}, {3, 3, 3}}, options),
                             {Material{}}});
    Film film(128, 128, {Layer::normal});
    render(scene, view, {}, film);
    return film.layer(Layer::normal);
  };
  const std::vector<float> exact = normals(NormalKind::gradient), near = normals(NormalKind::neighbour);
  int hits = 0, close = 0;
  for (std::size_t i = 0; i < exact.size(); i += 3) {
    const double size = exact[i] * exact[i] + exact[i + 1] * exact[i + 1] + exact[i + 2] * exact[i + 2];
    if (size < 0.5) {
      CHECK(near[i] == 0);
      continue;
    }
    ++hits;
    close += exact[i] * near[i] + exact[i + 1] * near[i + 1] + exact[i + 2] * near[i + 2] > std::cos(0.05);
  }
  CHECK(hits > 5000);
  CHECK(close > 0.9 * hits);
  CHECK_FALSE(exact == near);
}
