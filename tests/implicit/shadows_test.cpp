// Shadow rays start on the surface without an offset: held against shadows from exact hit points.
#include <implicit/framed_rays.h>
#include <isocast/implicit/expression/catalogue.h>
#include <isocast/implicit/implicit_surface.h>
#include <test_size.h>

#include <array>
#include <catch2/catch.hpp>
#include <vector>

using namespace isocast;
using namespace isocast::test;
using reference::FormulaReference, reference::FormulaRoots;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A setting of a method; eps-rel is 2^-digits.
struct Setting {
  const char* method;
  bool precise;
  int digits;
};
std::vector<Setting> settings() {
  std::vector<Setting> all;
  for (const char* method : {"interval", "affine"})
    for (const bool precise : {false, true})
      for (const int digits : {8, 12, 16, 20}) all.push_back({method, precise, digits});
  return all;
}

// The largest share of hit pixels, in percent, that may be on the wrong side of a shadow.
constexpr double kWrongShare = 0.1;
// And of those that are on the right side for where their ray starts, but not for the exact point: with 2^-8,
// the near end of a bracket lies up to 1/256 of the domain in front of it, and the shadows' edges move along.
double moved_share(const Setting& setting) { return setting.digits == 8 ? 0.3 : 0.05; }

// A pixel as exact arithmetic sees it: the first root and, if the surface faces the light there, the roots of
// the ray from it towards the light.
struct ExactPixel {
  double t = kInfinity;
  bool faces_light = false;
  std::vector<double> occluders;
};
// The exact point as doubles is off by a few ulp, and so may be one root at the start.
constexpr double kRounding = 1e-9;

// What is known of the hit that a shadow ray leaves: how long the bracket in front of the root is, and
// whether it is proved; only then is the side that the ray starts on.
struct Start {
  double bracket = 0;
  bool proved = false;
};

struct Tally {
  int hits = 0, skipped = 0, wrong = 0, moved = 0;
};

// One surface, one light, by the reference and by methods.
class ShadowPicture {
 public:
  ShadowPicture(const CatalogueSurface& surface, const Double3& light, int size)
      : expression_(surface_expression(surface)),
        domain_(surface.domain),
        reference_(expression_),
        to_light_(normalized(light)),
        size_(size),
        exact_(std::size_t(size) * std::size_t(size)) {
    const ImplicitSurface plain(expression_, domain_, {});
    box_ = plain.bounds();
    each_tile(box_, size_, [&](const RayStream& rays) { solve(rays, plain); });
  }

  void compare(const Setting& setting, Tally& tally) const {
    ImplicitSurfaceOptions options;
    options.method = choose_formula_method(setting.method, {});
    options.method.eps_rel = std::ldexp(1, -setting.digits);
    options.double_precision = setting.precise;
    const ImplicitSurface surface(expression_, domain_, options);
    each_tile(box_, size_, [&](const RayStream& rays) { compare_tile(surface, rays, tally); });
  }

 private:
  [[nodiscard]] FormulaRoots roots_along(const Double3& o, const Double3& d, std::size_t most) const {
    const Reach range = range_inside(box_, o, d);
    reference::ReferenceOptions options;
    options.max_roots = most;
    options.width = 1e-14;
    return range.empty() ? FormulaRoots{} : reference_.solve(o, d, range.lo, range.hi, options);
  }
  [[nodiscard]] bool faces_light(const Surface& surface, const RayStream& rays, const HitStream& hits,
                                 int i) const {
    DressedHits dressed;
    surface.dress(rays, hits, {true, false, false}, dressed);
    return dot(normal_of(dressed, i), to_light_) > 0;
  }

  void solve(const RayStream& rays, const Surface& plain) {
    for (int i = 0; i < rays.size; ++i) {
      if (!is_ray(rays, i)) continue;
      const Double3 o = origin_of(rays, i), d = direction_of(rays, i);
      const FormulaRoots first = roots_along(o, d, 1);
      if (first.roots.empty()) continue;
      ExactPixel& pixel = exact_[rays.id[i]];
      pixel.t = first.roots[0].lo;
      HitStream hits;
      clear(hits);
      hits.t[i] = pixel.t, hits.object[i] = 0;
      pixel.faces_light = faces_light(plain, rays, hits, i);
      if (!pixel.faces_light) continue;
      for (const auto& root : roots_along(o + pixel.t * d, to_light_, 99).roots)
        if (root.lo > kRounding) pixel.occluders.push_back(root.lo);
    }
  }

  // Spawns the shadow rays as the renderer does and judges what they meet.
  void compare_tile(const ImplicitSurface& surface, const RayStream& rays, Tally& tally) const {
    const HitStream hits = first_hits(surface, rays);
    DressedHits dressed;
    surface.dress(rays, hits, {true, false, false}, dressed);
    RayStream shadow;
    shadow.size = 0;
    shadow.kind = RayKind::shadow;
    std::array<Start, kStreamSize> starts;
    const double tolerance = 0x1p-8 * std::ranges::max(box_.hi - box_.lo);
    for (int i = 0; i < rays.size; ++i) {
      if (!is_ray(rays, i) || !is_hit(hits, i)) continue;
      const ExactPixel& pixel = exact_[rays.id[i]];
      ++tally.hits;
      // not the first root, an undecided hit: there is no exact point to compare with
      const bool same = std::abs(hits.t[i] - pixel.t) <= tolerance;
      const bool faces = dot(normal_of(dressed, i), to_light_) > 0;
      tally.skipped += !same || faces != pixel.faces_light;
      if (!same || !faces || !pixel.faces_light) continue;
      starts[static_cast<std::size_t>(shadow.size)] = {std::max(hits.t_hi[i], pixel.t) - hits.t_lo[i],
                                                       hits.certificate[i] == Certificate::proved_hit};
      spawn(rays, hits, i, to_light_, shadow);
    }
    bool blocked[kStreamSize] = {};
    TraceCounts counts;
    surface.any_hit(shadow, blocked, counts);
    const HitStream met = first_hits(surface, shadow);
    for (int n = 0; n < shadow.size; ++n) {
      REQUIRE(blocked[n] == is_hit(met, n));
      judge(shadow, met, n, starts[static_cast<std::size_t>(n)], tally);
    }
  }

  // A ray from a bracket's near end may pass what lies closer to the exact point than the bracket is long, or
  // meet it: neither is wrong. Where else the light differs from that at the exact point, the ray's own roots
  // tell whether the edge of a shadow runs between the two starts, or the ray has found its own surface, or
  // overlooked another; then nothing may have been proved.
  void judge(const RayStream& shadow, const HitStream& met, int n, const Start& start, Tally& tally) const {
    const std::vector<double>& occluders = exact_[shadow.id[n]].occluders;
    const bool blocked = is_hit(met, n);
    const bool dark = std::ranges::any_of(occluders, [&](double s) { return s > start.bracket; });
    if (dark == blocked || (!dark && !occluders.empty())) return;
    const Double3 o = origin_of(shadow, n);
    if (roots_along(o, to_light_, 1).roots.empty() != blocked) {
      ++tally.moved;
      return;
    }
    INFO(std::hexfloat << "o " << o[0] << " " << o[1] << " " << o[2]);
    if (start.proved) REQUIRE(met.certificate[n] == Certificate::undecided);
    ++tally.wrong;
  }

  Expression expression_;
  Domain domain_;
  FormulaReference reference_;
  Double3 to_light_;
  int size_;
  Box box_;
  std::vector<ExactPixel> exact_;  // by pixel
};

}  // namespace

TEST_CASE("shadows from the near ends of brackets are those from exact points", "[property]") {
  const int size = static_cast<int>(cases(48, 160));
  for (const char* id : {"sphere", "tangle", "barth_sextic", "barth_decic"}) {
    INFO(id);
    const std::vector<Setting> all = settings();
    std::vector<Tally> tallies(all.size());
    // from above, from the side, and from behind
    for (const Double3& light : {Double3{1, -1, 2}, Double3{-1, -0.4, 0.3}, Double3{0.5, 1, 0.4}}) {
      const ShadowPicture picture(require_surface(id), light, size);
      for (std::size_t k = 0; k < all.size(); ++k) picture.compare(all[k], tallies[k]);
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
      const auto& [hits, skipped, wrong, moved] = tallies[k];
      INFO(all[k].method << (all[k].precise ? " double" : " float") << " eps-rel 2^-" << all[k].digits);
      // of few pixels, one or two more are chance
      CHECK(hits > size * size / 4);
      CHECK(skipped <= 0.01 * hits);
      CHECK(wrong <= 0.01 * kWrongShare * hits + 2);
      CHECK(moved <= 0.01 * moved_share(all[k]) * hits + 2);
    }
  }
}
