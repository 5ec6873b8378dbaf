#include <isocast/volume/sample.h>
#include <isocast/volume/sure_hits.h>
#include <isocast/volume/trace_stream.h>

#include <algorithm>
#include <cmath>

namespace isocast {
namespace {

// Where a ray is looked at, as shares of its way through the grid: what is left longest is halved.
constexpr double kPlaces[] = {1. / 2,  1. / 4,  3. / 4,   1. / 8,  5. / 8,   3. / 8,  7. / 8,  1. / 16,
                              9. / 16, 5. / 16, 13. / 16, 3. / 16, 11. / 16, 7. / 16, 15. / 16};

// Bit i: f < iso i.
struct Sides {
  bool known = false;
  std::uint32_t bits = 0;
};

// The blocks of a grid, each on one side of every iso-value or not.
template <class S> class SettledBlocks {
 public:
  explicit SettledBlocks(const VolumeQuery& query)
      : level_(query.grid.levels[kMacroLevels - 1]), count_(query.iso_count) {
    for (int i = 0; i < count_; ++i) keys_[i] = static_cast<Key>(query.key[i]);
  }

  // Of the block that the ray surely is in at t; none where it is near a border, or f takes both sides.
  [[nodiscard]] Sides at(const GridRay& ray, double t) const {
    const double size = 1 << level_.shift;
    std::size_t block = 0;
    for (int a = 2; a >= 0; --a) {
      const double way = t * ray.d[a], place = (ray.o[a] + way) / size, lowest = std::floor(place),
                   room = 0x1p-12 + 0x1p-48 * (std::abs(ray.o[a]) + std::abs(way));
      if (!(lowest >= 0 && lowest < level_.dims[a] && place - lowest > room && place - lowest < 1 - room))
        return {};
      block = block * static_cast<std::size_t>(level_.dims[a]) + static_cast<std::size_t>(lowest);
    }
    const Number* const range = static_cast<const Number*>(level_.ranges) + 2 * block;
    Sides sides = {true, 0};
    for (int i = 0; i < count_; ++i) {
      const bool below = range[1] < keys_[i];
      if (range[0] < keys_[i] && !below) return {};
      sides.bits |= std::uint32_t(below) << i;
    }
    return sides;
  }

 private:
  using Number = typename SampleTraits<S>::Arithmetic;
  using Key = typename SampleTraits<S>::Key;
  const MacroLevel& level_;
  int count_;
  Key keys_[kMaxIsos];
};

// The ray's way through the grid; false where there is none.
bool clip(const VolumeQuery& query, const GridRay& ray, double& near, double& far) {
  for (int a = 0; a < 3; ++a) {
    if (ray.step[a] == 0) {
      if (ray.o[a] < query.samples.first[a] || ray.o[a] > query.samples.last[a]) return false;
      continue;
    }
    const double t0 = ray.plane_t(a, query.samples.first[a]), t1 = ray.plane_t(a, query.samples.last[a]);
    near = std::max(near, std::min(t0, t1)), far = std::min(far, std::max(t0, t1));
  }
  return near < far && far - near < __builtin_inf();
}

// start: the sides there, if they are known.
template <class S>
bool crosses(const SettledBlocks<S>& blocks, const GridRay& ray, Sides start, double near, double far,
             std::int64_t& looked_at) {
  for (const double share : kPlaces) {
    ++looked_at;
    const Sides sides = blocks.at(ray, near + share * (far - near));
    if (sides.known && start.known && sides.bits != start.bits) return true;
    if (sides.known) start = sides;
  }
  return false;
}

}  // namespace

int find_sure_hits(const VolumeQuery& query, const RayStream& rays, bool (&hit)[kStreamSize],
                   TraceCounts& counts) {
  constexpr int kTrials = 6, kLeastShare = 3;  // of those tried, one in so many
  int found = 0;
  visit_sample_type(query.grid.type, [&]<class S>(SampleTag<S>) {
    const SettledBlocks<S> blocks(query);
    int tried = 0;
    for (int i = 0; i < rays.size; ++i) {
      if (tried >= kTrials && found * kLeastShare < tried) return;
      const GridRay ray = grid_ray(query, rays, i);
      double near = rays.t_min[i], far = rays.t_max[i];
      if (hit[i] || !(rays.t_min[i] <= rays.t_max[i]) || !clip(query, ray, near, far)) continue;
      const Sides start = {rays.start_object[i] == query.object, rays.start_sides[i]};
      hit[i] = crosses(blocks, ray, start, near, far, counts.macrocells);
      ++tried, found += hit[i];
    }
  });
  return found;
}

}  // namespace isocast
