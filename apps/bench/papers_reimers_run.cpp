#include <fmt/format.h>
#include <isocast/apps/bench/paper_rows.h>
#include <isocast/apps/bench/papers_reimers_run.h>

#include <algorithm>

namespace isocast::bench {
namespace {

// Of every surface.
std::vector<FinderWay> common_ways() {
  std::vector<FinderWay> ways;
  for (const char* name : kFinders) ways.push_back({finder(name)});
  for (const char* name : {"frustum-lr", "frustum-mr"}) ways.push_back({finder(name, {{"stop", "value"}})});
  ways.push_back({finder("frustum-lr", {{"iterations", "1"}})});
  ways.push_back({finder("frustum-lr", {{"certify", "1"}})});
  ways.push_back({finder("frustum-mr", {{"eps", "0.0001"}}), true});
  ways.push_back({finder("frustum-lr"), true});
  for (const char* eps : kValueEps)
    ways.push_back({finder("frustum-lr", {{"stop", "value"}, {"eps", eps}}), true});
  return ways;
}

// The camera of the surface's own domain before a domain that is kLarge times as long.
PictureCase enlarged(PictureCase picture) {
  auto& f = std::get<FormulaSource>(picture.scene.objects.front().source);
  Box box;
  for (std::size_t a = 0; a < 3; ++a) {
    double &lo = f.domain.lo[a], &hi = f.domain.hi[a];
    box.lo[a] = lo, box.hi[a] = hi;
    const double more = 0.5 * (kLarge - 1) * (hi - lo);
    lo -= more, hi += more;
  }
  const Camera camera = frame(box, picture.scene.camera, double(picture.width) / picture.height);
  picture.scene.camera.position = camera.position, picture.scene.camera.target = camera.target;
  picture.scene.camera.up = camera.up;
  picture.name = large_case(picture.name);
  return picture;
}

}  // namespace

std::string large_case(std::string_view id) { return fmt::format("{}_x{}", id, kLarge); }

ReimersRun::ReimersRun(const PaperWishes& wishes) : size_(wishes.quick ? 256 : 512) {
  for (const SurfaceOfReimers& s : kReimersSurfaces) {
    if (wishes.quick && !s.quick) continue;
    const PictureCase picture = paper_surface(s.id, size_);
    std::vector<FinderWay> ways = common_ways();
    Box neck;
    if (s.id == "kiss") {
      for (const char* eps : kNeckEps) ways.push_back({finder("frustum-lr", {{"eps", eps}})});
      neck = {{-Box::inf, -Box::inf, -kNeck}, {Box::inf, Box::inf, kNeck}};
    }
    if (std::ranges::find(kLargeSurfaces, s.id) != std::end(kLargeSurfaces)) {
      const MethodSetting lr = finder("frustum-lr", {{"eps", kLargeEps}});
      run(wishes, enlarged(picture), {{lr}, {lr, true}});
    }
    run(wishes, picture, ways, neck);
  }
}

void ReimersRun::run(const PaperWishes& wishes, const PictureCase& picture,
                     const std::vector<FinderWay>& ways, const Box& part) {
  ReimersWishes asked{ways, part, {3, 9, 2.0}, wishes.cache};
  if (wishes.quick) asked.repetitions = {3, 5, 0.3};
  cases_[picture.name] = run_finders(picture, asked);
}

std::vector<Row> ReimersRun::rows() const {
  std::vector<Row> rows;
  for (const auto& [name, findings] : cases_)
    for (const FinderResult& one : findings.results) rows.push_back(one.row);
  return rows;
}

const FinderResult* ReimersRun::result(std::string_view case_name, const MethodSetting& setting,
                                       bool precise) const {
  const auto one = cases_.find(case_name);
  if (one == cases_.end()) return nullptr;
  const auto found = std::ranges::find_if(one->second.results, [&](const FinderResult& r) {
    return r.row.method == setting.method && r.row.setting == setting.text &&
           r.row.precision == (precise ? "double" : "float");
  });
  return found == one->second.results.end() ? nullptr : &*found;
}

const ShadingNumbers* ReimersRun::shading(std::string_view id) const {
  const auto found = cases_.find(id);
  return found == cases_.end() ? nullptr : &found->second.shading;
}

double ReimersRun::root_seconds(const SurfaceOfReimers& s) const {
  const FinderResult &all = *result(s.id, finder("frustum-lr")),
                     &one = *result(s.id, finder("frustum-lr", {{"iterations", "1"}}));
  return (all.row.seconds - one.row.seconds) * all.search.steps / (all.search.steps - one.search.steps);
}

double ReimersRun::cost_of_value_rule(const SurfaceOfReimers& s) const {
  const auto by_value = [&](const char* eps) -> const FinderResult& {
    return *result(s.id, finder("frustum-lr", {{"stop", "value"}, {"eps", eps}}), true);
  };
  const FinderResult &coarse = by_value(kValueEps[0]), &fine = by_value(kValueEps[1]),
                     &density = *result(s.id, finder("frustum-lr"), true);
  // steps are about linear in the digits
  const auto digits = [](const FinderResult& r) { return -std::log(r.row.t_error_p50); };
  const double share = (digits(density) - digits(coarse)) / (digits(fine) - digits(coarse));
  return std::lerp(coarse.search.steps, fine.search.steps, share) / density.search.steps;
}

double ReimersRun::knots(const SurfaceOfReimers& s, const MethodSetting& setting) const {
  const bool inserts = setting.method == "frustum-mr" || setting.method == "frustum-mr-mult";
  return result(s.id, setting)->search.steps * (inserts ? 1 : s.degree);
}

}  // namespace isocast::bench
