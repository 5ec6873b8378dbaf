#include <isocast/apps/bench/picture_truth.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isocast::bench {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

Double3 direction_of(const RayStream& rays, int i) { return {rays.dx[i], rays.dy[i], rays.dz[i]}; }

Verdict verdict_of(const reference::RayTruth& truth, const HitStream& hits, int i) {
  if (!truth.decided()) return Verdict::unknown;
  if (hits.certificate[i] == Certificate::undecided) return Verdict::undecided;
  return judge(truth, std::isfinite(hits.t[i]), hits.t[i]).verdict;
}

// Normals of a surface at its hits, by pixel; zero elsewhere.
std::vector<Double3> normals_at(const Surface& surface, const std::vector<RayStream>& rays,
                                const std::vector<HitStream>& hits, std::size_t pixels) {
  std::vector<Double3> normals(pixels, Double3{});
  std::vector<DressedHits> dressed(1);
  for (std::size_t s = 0; s < rays.size(); ++s) {
    surface.dress(rays[s], hits[s], {.normal = true}, dressed[0]);
    for (int i = 0; i < rays[s].size; ++i)
      if (std::isfinite(hits[s].t[i]))
        for (std::size_t a = 0; a < 3; ++a) normals[rays[s].id[i]][a] = dressed[0].normal[a][i];
  }
  return normals;
}

}  // namespace

std::int64_t undecided_rays(const PictureTruth& truth) {
  return std::ranges::count_if(truth.rays, [](const auto& ray) { return !ray.decided(); });
}

void add_normals(PictureTruth& truth, const Surface& surface, const std::vector<RayStream>& rays,
                 std::vector<HitStream> hits) {
  each_ray(rays, [&](std::size_t s, int i) {
    const reference::RayTruth& ray = truth.rays[rays[s].id[i]];
    const bool right = verdict_of(ray, hits[s], i) == Verdict::hit;
    hits[s].t[i] = right ? middle(*first_crossing(ray)) : std::numeric_limits<double>::infinity();
  });
  truth.normals = normals_at(surface, rays, hits, truth.rays.size());
}

std::vector<PixelAnswer> judge_picture(const PictureTruth& truth, const Surface& surface,
                                       const std::vector<RayStream>& rays,
                                       const std::vector<HitStream>& hits) {
  std::vector<PixelAnswer> answers(truth.rays.size());
  const std::vector<Double3> normals = normals_at(surface, rays, hits, truth.rays.size());
  each_ray(rays, [&](std::size_t s, int i) {
    const std::size_t pixel = rays[s].id[i];
    const reference::RayTruth& ray = truth.rays[pixel];
    PixelAnswer& answer = answers[pixel];
    answer.verdict = verdict_of(ray, hits[s], i);
    if (answer.verdict != Verdict::hit) return;
    answer.t_error =
        std::abs(hits[s].t[i] - middle(*first_crossing(ray))) * length(direction_of(rays[s], i)) / truth.unit;
    const Double3 &found = normals[pixel], &right = truth.normals[pixel];
    const bool known = length(found) > 0 && length(right) > 0;
    answer.normal_error_deg = known ? angle_in_degrees(found, right) : kUnknown;
  });
  return answers;
}

void summarize(std::span<const PixelAnswer> answers, Row& row) {
  ErrorSamples errors;
  row.rays = static_cast<std::int64_t>(answers.size());
  for (const PixelAnswer& answer : answers) {
    row.false_misses += answer.verdict == Verdict::false_miss;
    row.false_hits += answer.verdict == Verdict::false_hit;
    row.wrong_root += answer.verdict == Verdict::wrong_root;
    row.undecided += answer.verdict == Verdict::undecided;
    row.undecided_reference += answer.verdict == Verdict::unknown;
    if (answer.verdict != Verdict::hit) continue;
    errors.t.push_back(answer.t_error);
    if (!std::isnan(answer.normal_error_deg)) errors.normal_deg.push_back(answer.normal_error_deg);
  }
  errors.summarize(row);
}

}  // namespace isocast::bench
