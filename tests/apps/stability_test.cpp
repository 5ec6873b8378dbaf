// The stress set: every case is as expected, whatever is counted is counted rightly, and no instruction set
// answers otherwise than another.
#include <isocast/apps/bench/stability.h>
#include <isocast/apps/bench/stability_report.h>
#include <isocast/apps/scene_build/applicable_methods.h>
#include <isocast/implicit/methods.h>
#include <isocast/volume/methods.h>
#include <temporary_folder.h>
#include <test_size.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <set>

using namespace isocast;
using namespace isocast::bench;
using reference::RayRoot, reference::RayTruth;

namespace {

constexpr double kInfinity = __builtin_inf();

std::string text_of(const StressOutcome& outcome) { return outcome.expected + ": found " + outcome.broken; }

void check(const StressResult& result) {
  REQUIRE_FALSE(result.answers.empty());
  for (const StressOutcome& outcome : result.outcomes) {
    INFO(result.name << ": " << text_of(outcome));
    CHECK(outcome.broken.empty());
  }
}

StressOptions small() {
  StressOptions options;
  options.size = static_cast<int>(test::cases(8, 40));
  options.cells = static_cast<std::uint64_t>(test::cases(512, 50'000));
  return options;
}

// One ray along z after the other, with what is true of them and what a method says.
struct Rays {
  PictureTruth truth;
  std::vector<RayStream> rays = std::vector<RayStream>(1);
  std::vector<HitStream> hits = std::vector<HitStream>(1);

  Rays() { rays[0].size = 0; }
  void add(RayTruth ray, double t_lo, double t, double t_hi, Certificate certificate) {
    const int i = rays[0].size++;
    rays[0].t_min[i] = 0;
    rays[0].t_max[i] = kInfinity;
    rays[0].id[i] = static_cast<std::uint32_t>(i);
    hits[0].t_lo[i] = t_lo;
    hits[0].t[i] = t;
    hits[0].t_hi[i] = t_hi;
    hits[0].iso[i] = 0;
    hits[0].certificate[i] = certificate;
    truth.rays.push_back(std::move(ray));
  }
  [[nodiscard]] StressCounts count() const { return count_proofs(truth, rays, hits); }
};

RayTruth roots_at(std::initializer_list<double> places, int iso = 0) {
  RayTruth truth;
  for (const double t : places) truth.roots.push_back({t, t, true, 1, kInfinity, iso});
  return truth;
}

StressAnswer answer_with(const char* method, const char* proves, std::int64_t rays, std::int64_t wrong) {
  StressAnswer answer;
  answer.row.method = method;
  answer.row.proves = proves;
  answer.row.precision = "float";
  answer.row.rays = rays;
  answer.row.false_hits = wrong;
  return answer;
}

// All that the surface says of the rays, as bytes.
std::vector<std::byte> answers(const Surface& surface, const std::vector<RayStream>& rays) {
  std::vector<HitStream> hits(rays.size());
  clear(hits);
  trace(surface, rays, hits);
  std::vector<std::byte> bytes;
  const auto add = [&](const auto& number) {
    const auto* from = reinterpret_cast<const std::byte*>(&number);
    bytes.insert(bytes.end(), from, from + sizeof number);
  };
  each_ray(rays, [&](std::size_t s, int i) {
    add(hits[s].certificate[i]);
    for (const double t : {hits[s].t[i], hits[s].t_lo[i], hits[s].t_hi[i]})
      if (is_hit(hits[s], i)) add(t);
  });
  return bytes;
}

}  // namespace

TEST_CASE("cells of every family are as expected", "[property]") {
  for (const StressFamily& family : stress_families()) check(run_stress(family, small()));
}

TEST_CASE("stress volumes are as expected", "[property]") {
  const test::TemporaryFolder folder;
  for (const StressCase& stress : stress_volumes(folder.path)) check(run_stress(stress, small()));
}

TEST_CASE("stress formulas are as expected", "[property]") {
  for (const StressCase& stress : stress_formulas()) check(run_stress(stress, small()));
}

TEST_CASE("hostile numbers: the same bits on every instruction set", "[property]") {
  const test::TemporaryFolder folder;
  std::vector<StressCase> all = stress_volumes(folder.path);
  for (StressCase& stress : stress_formulas()) all.push_back(std::move(stress));
  for (const StressCase& stress : all) {
    INFO(stress.name);
    BuiltScene built = build_scene(stress.scene, {});
    const Surface& surface = *built.scene.objects.front().surface;
    const std::vector<RayStream> rays = stress.rays(surface.bounds(), static_cast<int>(test::cases(4, 24)));
    for (const Method& method : applicable_methods(stress.scene.objects.front(), MethodWish::own_answers))
      for (const bool precise : {false, true}) {
        INFO(method.name << (precise ? " double" : " float"));
        std::vector<std::byte> expected;
        for (const Isa isa : available_isas()) {
          INFO(name_of(isa));
          built.objects.front().change_method(std::string(method.name), {}, {isa, precise});
          const std::vector<std::byte> found = answers(surface, rays);
          if (isa == Isa::scalar) expected = found;
          CHECK((found == expected));
        }
      }
  }
}

TEST_CASE("rays are numbered, start at t = 0, are no shorter than 1, and lie where they are meant to") {
  const Box box{{0, 0, 0}, {15, 15, 15}};
  for (const MakeRays make :
       {framing_rays, axis_rays, inner_rays, face_rays, central_rays, rays_from_x7, rays_from_sphere,
        lengthwise_rays, across_steiner, across_cross_cap, across_teardrop_tip}) {
    std::set<std::uint32_t> ids;
    const std::vector<RayStream> rays = make(box, 18);
    each_ray(rays, [&](std::size_t s, int i) {
      ids.insert(rays[s].id[i]);
      CHECK(rays[s].t_min[i] == 0);
      CHECK(length({rays[s].dx[i], rays[s].dy[i], rays[s].dz[i]}) > 1 - 1e-15);
    });
    CHECK(ids.size() == 18 * 18);
    CHECK(*ids.rbegin() == 18 * 18 - 1);
  }
  const std::vector<RayStream> in_faces = face_rays(box, 18), on_sphere = rays_from_sphere(box, 18);
  each_ray(in_faces, [&](std::size_t s, int i) {
    const auto flat = [](double o, double d) { return d == 0 && o == std::floor(o) && 0 <= o && o <= 15; };
    const RayStream& r = in_faces[s];
    CHECK((flat(r.ox[i], r.dx[i]) || flat(r.oy[i], r.dy[i]) || flat(r.oz[i], r.dz[i])));
  });
  each_ray(on_sphere, [&](std::size_t s, int i) {
    const RayStream& r = on_sphere[s];
    CHECK(r.ox[i] * r.ox[i] + r.oy[i] * r.oy[i] + r.oz[i] * r.oz[i] == 0.31640625);
  });
}

TEST_CASE("every expectation names methods that there are, and cases have names of their own") {
  const auto known = [](std::span<const Method> methods, std::string_view name) {
    return name.empty() || name == kProving ||
           std::ranges::find(methods, name, &Method::name) != methods.end();
  };
  const test::TemporaryFolder folder;
  std::set<std::string> names;
  const auto check_all = [&](const auto& cases, std::span<const Method> methods) {
    for (const auto& one : cases) {
      INFO(one.name);
      CHECK(names.insert(std::string(one.name) + methods.front().name.data()).second);
      for (const Expectation& e : one.expected) {
        CHECK(known(methods, e.method));
        CHECK((e.precision == "" || e.precision == "float" || e.precision == "double"));
        CHECK((0 <= e.least && e.least <= e.most && e.most <= 100));
      }
    }
  };
  check_all(stress_families(), volume_methods());
  check_all(stress_volumes(folder.path), volume_methods());
  check_all(stress_formulas(), formula_methods());
}

TEST_CASE("a false proof is one that the roots contradict") {
  using enum Certificate;
  Rays good, bad;
  good.add(roots_at({2, 3}), 1.9, 2, 2.1, proved_hit);
  good.add({}, kInfinity, kInfinity, kInfinity, proved_miss);
  good.add(roots_at({2}), kInfinity, kInfinity, kInfinity, undecided);
  good.add({{}, {{1, 2, reference::Doubt::jump}}, 0}, 1.9, 2, 2.1, proved_hit);
  CHECK(good.count().hits == 2);
  CHECK(good.count().misses == 1);
  CHECK(good.count().false_proofs == 0);
  bad.add(roots_at({1, 2}), 1.9, 2, 2.1, proved_hit);                    // a root in front
  bad.add(roots_at({3}), 1.9, 2, 2.1, proved_hit);                       // none inside
  bad.add(roots_at({2}, 1), 1.9, 2, 2.1, proved_hit);                    // of another iso-value
  bad.add(roots_at({2}), kInfinity, kInfinity, kInfinity, proved_miss);  // one that is missed
  bad.add(roots_at({2}), kInfinity, kInfinity, kInfinity, proved_hit);   // a hit without a hit
  CHECK(bad.count().false_proofs == 5);
  CHECK(bad.count().malformed == 0);
}

TEST_CASE("answers that are no answers are malformed") {
  Rays rays;
  rays.add({}, 1, 2, 3, Certificate::no_proof);
  rays.add({}, -1e-17, 0, 1e-17, Certificate::no_proof);
  CHECK(rays.count().malformed == 0);
  rays.add({}, 1, 0.5, 3, Certificate::no_proof);
  rays.add({}, 1, 2, kInfinity, Certificate::no_proof);
  rays.add({}, -2, -1, 1, Certificate::no_proof);
  rays.add({}, 1, std::nan(""), 2, Certificate::no_proof);
  CHECK(rays.count().malformed == 4);
}

TEST_CASE("an expectation is broken outside its bounds, by the methods that it names") {
  std::vector<StressAnswer> answers = {answer_with("one", "nothing", 200, 20),
                                       answer_with("two", "both", 200, 0)};
  const auto broken = [&](const Expectation& e) { return outcomes_of({e}, answers).back().broken; };
  CHECK(broken({Counted::wrong, 0, 10}).empty());
  CHECK(broken({Counted::wrong, 0, 9}) == "one in float: 10 %");
  CHECK(broken({Counted::wrong, 1, 100}) == "two in float: 0 %");
  CHECK(broken({Counted::wrong, 0, 0, "two"}).empty());
  CHECK(broken({Counted::wrong, 0, 0, kProving}).empty());
  CHECK(broken({Counted::wrong, 0, 0, "one", "double"}).empty());
  CHECK(outcomes_of({{Counted::proved_miss, 0, 0, "two"}}, answers).back().expected ==
        "two: a proved miss at none of the rays");
  answers[1].counts.false_proofs = 3;
  CHECK(outcomes_of({}, answers)[0].broken == "two in float: 3");

  StressResult result{"cells/odd", "what is odd", answers,
                      outcomes_of({{Counted::wrong, 0, 0, "one"}}, answers)};
  CHECK_FALSE(result.as_expected());
  CHECK_THAT(stability_summary({result}), Catch::Contains("cells/odd: NOT AS EXPECTED: one: wrong at none") &&
                                              Catch::Contains("0 of 1 cases"));
  CHECK_THAT(stability_html({result}, {}),
             Catch::Contains("NOT AS EXPECTED") && Catch::Contains("what is odd"));
  result.outcomes.clear();
  CHECK_THAT(stability_html({result}, {}), !Catch::Contains("NOT AS EXPECTED"));
}
