// What root finders do on every ray of a picture: steps, errors, and where a picture has edges.
#pragma once

#include <isocast/apps/bench/picture_case.h>
#include <isocast/implicit/frustum/depth_range.h>
#include <isocast/render/camera.h>

#include <vector>

namespace isocast::bench {

/// One finder's searches against those of the reference, over the whole picture.
///
/// steps         a ray, of rays that the reference needs a step for
/// steps_inside  a ray that hits away from edges
/// steps_edges   the same as steps of rays at an edge: a neighbour hits where it does not, or 1/50 of the
/// depths
///               away
/// value_*       |f| at hits over the largest coefficient of the whole form: mean, largest
/// depth_*       difference in depth where both hit, 1 from the nearest to the farthest point of the domain
/// other_roots   rays where that is more than 0.01
/// part_wrong    rays that hit in the part where the reference misses, or the reverse; part_hits: its hits
struct SearchNumbers {
  double steps = 0, steps_inside = 0, steps_edges = 0, value_mean = 0, value_max = 0, depth_mean = 0,
         depth_max = 0;
  std::int64_t other_roots = 0, part_wrong = 0, part_hits = 0;
};

/// A picture with the hits that count as right.
class SearchJudge {
 public:
  /// scale  of f: what its values at hits are divided by; part: what part_* look at
  SearchJudge(const View& view, const DepthRange& depths, const std::vector<RayStream>& rays,
              std::vector<HitStream> reference, double scale, const Box& part);

  [[nodiscard]] const std::vector<HitStream>& reference() const { return reference_; }
  [[nodiscard]] bool is_edge(std::uint32_t pixel) const { return edges_[pixel]; }
  /// Of hits of the surface on the same rays.
  [[nodiscard]] SearchNumbers numbers(const Surface& surface, const std::vector<HitStream>& hits) const;

 private:
  [[nodiscard]] double depth_of(std::size_t s, int i, double t) const;
  [[nodiscard]] bool in_part(std::size_t s, int i, double t) const;
  void find_edges(int width, int height);

  Double3 forward_;
  DepthRange depths_;
  const std::vector<RayStream>& rays_;
  std::vector<HitStream> reference_;
  double scale_;
  Box part_;
  std::vector<bool> edges_;  // by pixel
};

}  // namespace isocast::bench
