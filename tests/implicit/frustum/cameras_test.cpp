// The frustum form from any camera: what its pictures prove agrees with affine bisection and with the rays'
// own polynomials, with the same bits on every instruction set.
#include <implicit/framed_rays.h>
#include <implicit/random_camera.h>
#include <isocast/base/error.h>
#include <isocast/implicit/expression/parse.h>
#include <isocast/implicit/implicit_surface.h>
#include <test_size.h>

#include <catch2/catch.hpp>
#include <random>

using namespace isocast;
using namespace isocast::test;

namespace {

const Domain kBox = {{-2, -2, -2}, {2, 2, 2}};

enum class Arithmetic { single, mixed, full };

ImplicitSurface surface_of(const char* formula, const char* method, Arithmetic arithmetic,
                           Isa isa = widest_isa()) {
  ImplicitSurfaceOptions options;
  options.iso = {0, 0.3};
  options.method = choose_formula_method(method, {});
  options.double_precision = arithmetic == Arithmetic::full;
  options.mixed_precision = arithmetic == Arithmetic::mixed;
  options.isa = isa;
  return ImplicitSurface(parse_expression(formula), kBox, options);
}

constexpr const char* kMethods[] = {"frustum-lr",      "frustum-mr",        "frustum-lr-mult",
                                    "frustum-mr-mult", "frustum-schneider", "frustum-clip"};

void require_same_bits(const HitStream& a, const HitStream& b) {
  for (int i = 0; i < kStreamSize; ++i) {
    REQUIRE(a.t[i] == b.t[i]);
    REQUIRE(a.certificate[i] == b.certificate[i]);
    REQUIRE(a.cost[i] == b.cost[i]);
    if (!is_hit(a, i)) continue;
    REQUIRE(a.t_lo[i] == b.t_lo[i]);
    REQUIRE(a.t_hi[i] == b.t_hi[i]);
    REQUIRE(a.iso[i] == b.iso[i]);
    REQUIRE(a.sides[i] == b.sides[i]);
  }
}

// Two surfaces' words on the same ray.
bool agree(const HitStream& a, const HitStream& b, int i) {
  const auto open = [i](const HitStream& hits) { return hits.certificate[i] == Certificate::undecided; };
  if (open(a) || open(b)) return false;
  REQUIRE(a.certificate[i] == b.certificate[i]);
  if (!is_hit(a, i)) return true;
  REQUIRE(a.t_lo[i] <= b.t_hi[i]);
  REQUIRE(b.t_lo[i] <= a.t_hi[i]);
  REQUIRE(a.iso[i] == b.iso[i]);
  REQUIRE(a.sides[i] == b.sides[i]);
  return true;
}

}  // namespace

TEST_CASE("proofs of the frustum form agree with those of others, from any camera", "[property]") {
  std::mt19937_64 random(13);
  std::int64_t hits_seen = 0, compared = 0, rays_seen = 0;
  const std::unique_ptr<BlockHits> blocks[2] = {std::make_unique<BlockHits>(), std::make_unique<BlockHits>()};
  for (std::int64_t n = 0, count = cases(120, 6000); n < count; ++n) {
    const char* formulas[] = {"x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8",
                              "x + 2*y - 0.3*z",
                              "x^2 + y^2 + z^2 - 1",
                              "(x^2+y^2+z^2-1)*((x-1)^2+y^2-0.1)*(z-x*y)",
                              "2*(4*x^3-3*x)^2 - 1 + y*z^5 - 0.2",
                              "x*y*z"};
    const char* formula = formulas[n % 6];
    const char* method = kMethods[n / 6 % 6];
    const auto arithmetic = static_cast<Arithmetic>(n % 3);
    INFO(formula << " " << method << " " << n % 3);
    const ImplicitSurface frustum = surface_of(formula, method, arithmetic),
                          scalar = surface_of(formula, method, arithmetic, Isa::scalar),
                          affine = surface_of(formula, "affine", Arithmetic::full);
    const View view(random_camera(random), 520, 400);
    const auto pass = frustum.primary(view), scalar_pass = scalar.primary(view);
    if (!pass) continue;
    TraceCounts counts;
    BlockHits &block = *blocks[0], &scalar_block = *blocks[1];
    const int bx = static_cast<int>(random() % 5), by = static_cast<int>(random() % 4);
    block.reset(true), scalar_block.reset(true);
    pass->first_hits(bx, by, 0.5, 0.25, block, counts);
    scalar_pass->first_hits(bx, by, 0.5, 0.25, scalar_block, counts);
    RayStream rays;
    for (int n_tile = 0; n_tile < 6; ++n_tile) {
      const int x = static_cast<int>(random() % kBlockTiles), y = static_cast<int>(random() % kBlockTiles);
      const HitStream& found = block.tile(x, y);
      require_same_bits(found, scalar_block.tile(x, y));
      view.fill(bx * kBlockTiles + x, by * kBlockTiles + y, 0.5, 0.25, rays);
      const HitStream alone = first_hits(frustum, rays), other = first_hits(affine, rays);
      require_same_bits(alone, first_hits(scalar, rays));
      for (int i = 0; i < rays.size; ++i) {
        if (rays.t_min[i] > rays.t_max[i]) continue;
        ++rays_seen;
        INFO(std::hexfloat << rays.ox[i] << " " << rays.oy[i] << " " << rays.oz[i] << " towards "
                           << rays.dx[i] << " " << rays.dy[i] << " " << rays.dz[i]);
        compared += agree(found, other, i);
        agree(alone, other, i);
        hits_seen += is_hit(found, i);
      }
    }
  }
  CHECK(compared > 0.9 * static_cast<double>(rays_seen));
  CHECK(hits_seen > 6000);
}

TEST_CASE("every crossing of a ray is found in order, none twice") {
  const ImplicitSurface frustum = surface_of("(x^2+y^2+z^2-1)*(x^2+y^2+z^2-0.25)*(z-0.1)", "frustum-lr",
                                             Arithmetic::full),
                        affine = surface_of("(x^2+y^2+z^2-1)*(x^2+y^2+z^2-0.25)*(z-0.1)", "affine",
                                            Arithmetic::full);
  const View view({{0.3, -5, 1.2}, {0, 0, 0}, {0, 0, 1}, 40, {}}, 16, 16);
  RayStream rays;
  view.fill(0, 0, 0.5, 0.5, rays);
  HitStream a = first_hits(frustum, rays), b = first_hits(affine, rays);
  int crossings = 0;
  for (int round = 0; round < 16; ++round) {
    for (int i = 0; i < rays.size; ++i) {
      if (a.certificate[i] == Certificate::undecided || b.certificate[i] == Certificate::undecided) {
        forget(a, i), forget(b, i);
        continue;
      }
      REQUIRE(is_hit(a, i) == is_hit(b, i));
      if (!is_hit(a, i)) continue;
      ++crossings;
      REQUIRE(a.t[i] == Approx(b.t[i]).epsilon(1e-6));
      REQUIRE(a.iso[i] == b.iso[i]);
      REQUIRE(a.sides[i] == b.sides[i]);
    }
    TraceCounts counts;
    frustum.next_hit(rays, a, counts);
    affine.next_hit(rays, b, counts);
  }
  CHECK(crossings > 300);
}

TEST_CASE("what is no polynomial is refused with the reason") {
  const auto refusal = [](const char* formula) {
    try {
      surface_of(formula, "frustum-mr", Arithmetic::single);
    } catch (const InputError& error) { return std::string(error.what()); }
    return std::string();
  };
  CHECK(refusal("x + sin(y)") ==
        "--method frustum-mr needs a polynomial in x, y and z, and the formula is not a polynomial because "
        "of sin");
  CHECK(refusal("1/x") != "");
  CHECK(refusal("x^61") != "");
  CHECK(refusal("x^2 + sin(w) * y / exp(2)") == "");
}
