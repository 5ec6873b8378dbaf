#include <isocast/apps/bench/papers_reimers_search.h>

#include <algorithm>
#include <cmath>

namespace isocast::bench {
namespace {

constexpr double kEdge = 0.02, kOtherRoot = 0.01;  // of the depths

}  // namespace

SearchJudge::SearchJudge(const View& view, const DepthRange& depths, const std::vector<RayStream>& rays,
                         std::vector<HitStream> reference, double scale, const Box& part)
    : forward_(view.forward()),
      depths_(depths),
      rays_(rays),
      reference_(std::move(reference)),
      scale_(scale),
      part_(part) {
  find_edges(view.width(), view.height());
}

double SearchJudge::depth_of(std::size_t s, int i, double t) const {
  const Double3 d = {rays_[s].dx[i], rays_[s].dy[i], rays_[s].dz[i]};
  return (t * dot(d, forward_) - depths_.near) / (depths_.far - depths_.near);
}

bool SearchJudge::in_part(std::size_t s, int i, double t) const {
  const RayStream& r = rays_[s];
  const Double3 p = {r.ox[i] + t * r.dx[i], r.oy[i] + t * r.dy[i], r.oz[i] + t * r.dz[i]};
  for (int a = 0; a < 3; ++a)
    if (!(p[a] >= part_.lo[a] && p[a] <= part_.hi[a])) return false;
  return true;
}

void SearchJudge::find_edges(int width, int height) {
  const auto columns = static_cast<std::size_t>(width), pixels = columns * static_cast<std::size_t>(height);
  std::vector<double> depth(pixels, Box::inf);
  each_ray(rays_, [&](std::size_t s, int i) {
    if (is_hit(reference_[s], i)) depth[rays_[s].id[i]] = depth_of(s, i, reference_[s].t[i]);
  });
  edges_.assign(pixels, false);
  const auto compare = [&](std::size_t a, std::size_t b) {
    if (std::abs(depth[a] - depth[b]) > kEdge) edges_[a] = edges_[b] = true;
  };
  for (std::size_t i = 0; i < pixels; ++i) {
    if ((i + 1) % columns != 0) compare(i, i + 1);
    if (i + columns < pixels) compare(i, i + columns);
  }
}

SearchNumbers SearchJudge::numbers(const Surface& surface, const std::vector<HitStream>& hits) const {
  SearchNumbers sums;
  std::int64_t searched = 0, inside = 0, edges = 0, found_hits = 0, both = 0;
  std::vector<DressedHits> dressed(rays_.size());
  for (std::size_t s = 0; s < rays_.size(); ++s)
    surface.dress(rays_[s], hits[s], {.value = true}, dressed[s]);
  each_ray(rays_, [&](std::size_t s, int i) {
    const HitStream &found = hits[s], &right = reference_[s];
    const bool hit = is_hit(found, i), expected = is_hit(right, i), edge = edges_[rays_[s].id[i]];
    if (right.cost[i] > 0) ++searched, sums.steps += found.cost[i];
    if (edge && right.cost[i] > 0) ++edges, sums.steps_edges += found.cost[i];
    if (expected && !edge) ++inside, sums.steps_inside += found.cost[i];
    if ((hit || expected) && in_part(s, i, expected ? right.t[i] : found.t[i]))
      sums.part_hits += expected, sums.part_wrong += hit != expected;
    if (!hit) return;
    ++found_hits;
    const double value = std::abs(dressed[s].value[i]) / scale_;
    sums.value_mean += value, sums.value_max = std::max(sums.value_max, value);
    if (!expected) return;
    ++both;
    const double off = std::abs(depth_of(s, i, found.t[i]) - depth_of(s, i, right.t[i]));
    sums.other_roots += off > kOtherRoot;
    sums.depth_mean += off, sums.depth_max = std::max(sums.depth_max, off);
  });
  sums.steps /= double(searched), sums.steps_inside /= double(inside), sums.steps_edges /= double(edges);
  sums.value_mean /= double(found_hits), sums.depth_mean /= double(both);
  return sums;
}

}  // namespace isocast::bench
