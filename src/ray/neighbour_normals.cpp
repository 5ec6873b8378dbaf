#include <isocast/ray/neighbour_normals.h>

#include <cmath>

namespace isocast {
namespace {

constexpr int kSide = 16;  // of a tile

// The slot of a tile's pixel: packets of 4 x 4.
int slot_of(int x, int y) { return (y / 4 * 4 + x / 4) * kPacketSize + y % 4 * 4 + x % 4; }

}  // namespace

void find_neighbour_normals(const RayStream& rays, const HitStream& hits, std::uint16_t object,
                            DressedHits& dressed, bool (&made)[kStreamSize]) {
  const auto hit = [&](int i) { return hits.object[i] == object && is_hit(hits, i); };
  const auto point = [&](int i) {
    return Double3{rays.ox[i] + hits.t[i] * rays.dx[i], rays.oy[i] + hits.t[i] * rays.dy[i],
                   rays.oz[i] + hits.t[i] * rays.dz[i]};
  };
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const int i = slot_of(x, y);
      made[i] = false;
      if (!hit(i)) continue;
      // of the neighbours on both sides the one nearest in depth; -1: none
      const auto nearer = [&](bool before, int a, bool behind, int b) {
        const auto fits = [&](bool there, int k) { return there && hit(k) && hits.iso[k] == hits.iso[i]; };
        const int first = fits(before, a) ? a : -1, second = fits(behind, b) ? b : -1;
        if (first < 0 || second < 0) return std::max(first, second);
        return std::abs(hits.t[first] - hits.t[i]) <= std::abs(hits.t[second] - hits.t[i]) ? first : second;
      };
      const int h = nearer(x > 0, slot_of(x - (x > 0), y), x < kSide - 1, slot_of(x + (x < kSide - 1), y)),
                v = nearer(y > 0, slot_of(x, y - (y > 0)), y < kSide - 1, slot_of(x, y + (y < kSide - 1)));
      if (h < 0 || v < 0) continue;
      const Double3 p = point(i), normal = normalized(cross(point(h) - p, point(v) - p));
      made[i] = length(normal) > 0;
      const double turn = dot(normal, {rays.dx[i], rays.dy[i], rays.dz[i]}) > 0 ? -1 : 1;
      if (made[i])
        for (int a = 0; a < 3; ++a) dressed.normal[a][i] = turn * normal[a];
    }
}

}  // namespace isocast
