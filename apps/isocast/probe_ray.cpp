#include <fmt/format.h>
#include <isocast/apps/bench/judge.h>
#include <isocast/apps/bench/timing.h>
#include <isocast/apps/isocast/probe_ray.h>
#include <isocast/apps/reference/scene_reference.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace isocast {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A stream of one ray and its hit.
struct OneRay {
  RayStream rays;
  HitStream hits;

  OneRay(const View& view, int x, int y) {
    view.fill(x / kTileSize, y / kTileSize, 0.5, 0.5, rays);
    const int packet = y % kTileSize / 4 * 4 + x % kTileSize / 4,
              from = packet * kPacketSize + y % 4 * 4 + x % 4;
    for (double* const part : {rays.ox, rays.oy, rays.oz, rays.dx, rays.dy, rays.dz, rays.t_min, rays.t_max})
      part[0] = part[from];
    rays.u[0] = rays.u[from], rays.v[0] = rays.v[from];
    rays.id[0] = rays.id[from];
    rays.size = 1;
    clear(hits);
  }
  // a surface that proves leaves proved misses as they were
  void trace(const Surface& surface, TraceCounts& counts) {
    hits.t[0] = kInfinity;
    hits.object[0] = kNoObject;
    hits.cost[0] = 0;
    hits.certificate[0] = surface.proves() ? Certificate::proved_miss : Certificate::no_proof;
    surface.first_hit(rays, hits, counts);
  }
};

double seconds_of(OneRay& ray, const Surface& surface) {
  constexpr double kRun = 1e-3;
  constexpr int kRuns = 11;
  TraceCounts counts;
  const auto repeated = [&](int times) {
    return [&, times] {
      for (int i = 0; i < times; ++i) ray.trace(surface, counts);
    };
  };
  const double once = bench::time_interleaved({repeated(1)}, 1, bench::Clock::thread)[0].seconds;
  const int times = static_cast<int>(std::clamp(kRun / once, 1.0, 1e4));
  return bench::time_interleaved({repeated(times)}, kRuns, bench::Clock::thread)[0].seconds / times;
}

// Beyond this t there is nothing; directions have unit length.
double reach(const Box& bounds, const RayStream& rays) {
  return length(bounds.center() - Double3{rays.ox[0], rays.oy[0], rays.oz[0]}) + bounds.diagonal();
}

// Whether the reference knows the first crossing: no doubt lies before it.
bool is_known(const reference::RayTruth& truth) {
  const reference::RayRoot* const first = bench::first_crossing(truth);
  return std::ranges::none_of(truth.doubts,
                              [&](const auto& doubt) { return !first || doubt.lo <= first->hi; });
}

}  // namespace

std::string_view verdict_of(const reference::RayTruth& truth, Certificate certificate, double t) {
  if (certificate == Certificate::undecided) return "undecided";
  if (!is_known(truth)) return "unknown";
  switch (bench::judge(truth, t < kInfinity, t).verdict) {
    case bench::Verdict::false_hit: return "false hit";
    case bench::Verdict::false_miss: return "false miss";
    case bench::Verdict::wrong_root: return "wrong root";
    default: return "right";
  }
}

std::string contradiction_of(const reference::RayTruth& truth, Certificate certificate, double t_lo,
                             double t_hi) {
  const auto first = std::ranges::find(truth.roots, false, &reference::RayRoot::from_above);
  const bool any = first != truth.roots.end();
  if (certificate == Certificate::proved_miss && any)
    return fmt::format("a miss is proved, but there is a root at {:.17g}", first->lo);
  if (certificate != Certificate::proved_hit) return {};
  if (any && first->hi < t_lo)
    return fmt::format("nothing before {:.17g} is proved, but there is a root at {:.17g}", t_lo, first->lo);
  const auto overlaps = [&](const auto& range) { return range.lo <= t_hi && range.hi >= t_lo; };
  if (std::ranges::any_of(truth.roots, overlaps) || std::ranges::any_of(truth.doubts, overlaps)) return {};
  return fmt::format("a root between {:.17g} and {:.17g} is proved, but there is none", t_lo, t_hi);
}

std::optional<std::size_t> object_at(const BuiltScene& built, const View& view, int x, int y) {
  const auto ray = std::make_unique<OneRay>(view, x, y);
  TraceCounts counts;
  for (const SceneObject& object : built.scene.objects)
    object.surface->first_hit(ray->rays, ray->hits, counts);
  for (std::size_t i = 0; i < built.objects.size() && is_hit(ray->hits, 0); ++i) {
    const BuiltObject& object = built.objects[i];
    if (ray->hits.object[0] >= object.place && ray->hits.object[0] < object.place + object.count) return i;
  }
  return std::nullopt;
}

Probe probe_ray(const SceneDescription& description, const BuiltScene& built, const View& view, int x, int y,
                const std::vector<ProbeMethod>& methods, Isa isa) {
  const auto ray = std::make_unique<OneRay>(view, x, y);
  const RayStream& rays = ray->rays;
  Probe probe{{rays.ox[0], rays.oy[0], rays.oz[0]}, {rays.dx[0], rays.dy[0], rays.dz[0]}, 0, {}, {}};
  const ObjectDescription& object = description.objects.front();
  if (std::holds_alternative<FormulaSource>(object.source)) {
    // into the space of the formula, as its surface does
    const Transform own_from_world = object.place.inverse();
    probe.origin = own_from_world.point(probe.origin);
    probe.direction = own_from_world.vector(probe.direction);
  }
  const auto reference = reference::make_reference(description, built);
  const Box bounds = built.scene.bounds();
  probe.unit = reference->unit();
  if (!bounds.empty())  // else there is nothing
    probe.truth = reference->solve(probe.origin, probe.direction, 0, reach(bounds, rays));

  const Surface& surface = *built.scene.objects[built.objects.front().place].surface;
  const reference::RayRoot* const first = bench::first_crossing(probe.truth);
  for (const auto& [method, settings] : methods)
    for (const bool precise : {false, true}) {
      built.objects.front().change_method(method, settings, {isa, precise});
      TraceCounts counts;
      ray->trace(surface, counts);
      const HitStream& hits = ray->hits;
      ProbeAnswer answer{method,
                         precise ? "double" : "float",
                         hits.t[0],
                         hits.t_lo[0],
                         hits.t_hi[0],
                         hits.certificate[0],
                         std::nan(""),
                         counts.solves + counts.evaluations,
                         0,
                         {},
                         {}};
      if (first && answer.t < kInfinity)
        answer.error = std::abs(answer.t - bench::middle(*first)) * length(probe.direction) / probe.unit;
      answer.verdict = verdict_of(probe.truth, answer.certificate, answer.t);
      answer.contradiction = contradiction_of(probe.truth, answer.certificate, answer.t_lo, answer.t_hi);
      answer.seconds = seconds_of(*ray, surface);
      probe.answers.push_back(std::move(answer));
    }
  return probe;
}

}  // namespace isocast
