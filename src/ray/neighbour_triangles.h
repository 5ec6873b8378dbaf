// Normals from the hits of neighbouring pixels, a row of a tile in lanes.
#pragma once

#include <isocast/math/pack.h>
#include <isocast/ray/surface.h>
#include <isocast/ray/tile_slot.h>

namespace isocast::inline ISO_ISA {

/// find_neighbour_normals of one tile. Points are counted from one of them in double, in units of the way
/// between two pixels' rays there; from then on float follows what lies between neighbours to 1e-7 of what
/// the tile shows.
class NeighbourTriangles {
  using D = Native<double>;
  using F = Native<float>;

 public:
  /// t  of the object's hits, +inf in other slots; first: a slot with a hit
  NeighbourTriangles(const RayStream& rays, const HitStream& hits, const double (&t)[kStreamSize],
                     int first) {
    for (float& border : t_) border = kNone;
    int others = 0;
    for (int i = 0; i < kStreamSize; ++i)
      others += (hits.object[i] == hits.object[first]) & (hits.iso[i] != hits.iso[first]);
    alike_ = others == 0;
    set_frame(rays, first, t[first]);
    for (int slot = 0; slot < kStreamSize; slot += kPacketSize) take_packet(rays, hits, t, slot);
  }

  /// As NormalKernels has it.
  int find(DressedHits& dressed, bool (&made)[kStreamSize]) const {
    int left = 0;
    for (int y = 0; y < kSide; ++y) left += find_row(y, dressed, made);
    return left;
  }

 private:
  static constexpr int kSide = 16, kPitch = kSide + 8, kPlaces = (kSide + 2) * kPitch;
  static constexpr float kNone = __builtin_inff();

  // Pixels in rows with a border all around.
  static constexpr int place_of(int x, int y) { return (y + 1) * kPitch + x + 4; }

  // Where points are counted from, their unit, and which way rows and columns turn around the rays.
  void set_frame(const RayStream& rays, int slot, double t) {
    const double *const o[3] = {rays.ox, rays.oy, rays.oz}, *const d[3] = {rays.dx, rays.dy, rays.dz};
    constexpr int kCorner = tile_slot(0, 0), kRight = tile_slot(1, 0), kBelow = tile_slot(0, 1);
    double right[3], below[3], unit = 0, volume = 0;
    for (int a = 0; a < 3; ++a) {
      origin_[a] = o[a][slot] + t * d[a][slot];
      const auto from_corner = [&](int i) {
        return o[a][i] + t * d[a][i] - (o[a][kCorner] + t * d[a][kCorner]);
      };
      right[a] = from_corner(kRight), below[a] = from_corner(kBelow);
      unit = max(unit, max(abs(right[a]), abs(below[a])));
    }
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      volume += (right[b] * below[c] - right[c] * below[b]) * d[a][kCorner];
    }
    depth_ = t;
    per_unit_ = inverse_power_of_two(unit);
    turns_ = volume > 0;
  }

  void take_packet(const RayStream& rays, const HitStream& hits, const double* t, int slot) {
    bool some = false;
    for (int l = 0; l < kPacketSize; ++l) some |= t[slot + l] < double(kNone);
    if (!some) return;
    const double *const o[3] = {rays.ox, rays.oy, rays.oz}, *const d[3] = {rays.dx, rays.dy, rays.dz};
    double p[3][kPacketSize], depth[kPacketSize];
    for (int l = 0; l < kPacketSize; l += kWidth<D>) {
      const D here = load<D>(t + slot + l), scale = D(per_unit_);
      store(depth + l, scale * (here - D(depth_)));
      for (int a = 0; a < 3; ++a)
        store(p[a] + l,
              scale * ((load<D>(o[a] + slot + l) - D(origin_[a])) + here * load<D>(d[a] + slot + l)));
    }
    const int x = slot / kPacketSize % 4 * 4, y = slot / kPacketSize / 4 * 4;
    for (int row = 0; row < 4; ++row) {
      const int place = place_of(x, y + row);
      for (int c = 0; c < 4; ++c) t_[place + c] = float(depth[row * 4 + c]);
      for (int a = 0; a < 3; ++a)
        for (int c = 0; c < 4; ++c) p_[a][place + c] = float(p[a][row * 4 + c]);
      if (!alike_)
        for (int c = 0; c < 4; ++c) iso_[place + c] = float(hits.iso[slot + row * 4 + c]);
    }
  }

  // The way to the nearer in depth of the two neighbours that show the same iso-value, `first`: the one above
  // or to the left.
  struct Edge {
    F way[3];
    Mask<F> there, first;
  };
  Edge edge(int place, int step) const {
    const F t = load<F>(t_ + place), iso = load<F>(iso_ + place);
    const auto distance = [&](int other) {
      return select(load<F>(iso_ + other) == iso, abs(load<F>(t_ + other) - t), F(kNone));
    };
    const F before = distance(place - step), behind = distance(place + step);
    Edge edge;
    edge.there = min(before, behind) < F(kNone);
    edge.first = before <= behind;
    for (int a = 0; a < 3; ++a)
      edge.way[a] = select(edge.first, load<F>(p_[a] + place - step), load<F>(p_[a] + place + step)) -
                    load<F>(p_[a] + place);
    return edge;
  }

  int find_row(int y, DressedHits& dressed, bool (&made)[kStreamSize]) const {
    float row[3][kSide];
    unsigned hits = 0, known = 0;
    for (int x = 0; x < kSide; x += kWidth<F>) {
      const int place = place_of(x, y);
      const Mask<F> hit = load<F>(t_ + place) < F(kNone);
      if (!any(hit)) continue;
      const Edge across = edge(place, 1), down = edge(place, kPitch);
      F normal[3], squared = F(0);
      for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        normal[a] = across.way[b] * down.way[c] - across.way[c] * down.way[b];
        squared = squared + normal[a] * normal[a];
      }
      const Mask<F> ends = across.there & down.there & (squared > F(0)) & (squared < F(kNone));
      // points in front of the eye turn around a ray as the rays do: with it, or against it
      const Mask<F> away = (across.first != down.first) != Mask<F>(turns_);
      const F scale = F(1) / sqrt(squared), turned = select(away, -scale, scale);
      for (int a = 0; a < 3; ++a) store(row[a] + x, turned * normal[a]);
      hits |= bits_of(hit) << x, known |= bits_of(hit & ends) << x;
    }
    for (int x = 0; x < kSide; x += 4) write(row, x, known >> x & 15, tile_slot(x, y), dressed, made);
    return __builtin_popcount(hits & ~known);
  }

  // Four pixels of a row, of which bit l of `known` says whether the normal is.
  static void write(const float (&row)[3][kSide], int x, unsigned known, int slot, DressedHits& dressed,
                    bool (&made)[kStreamSize]) {
    // one bit a byte
    const std::uint32_t flags = known * 0x00204081u & 0x01010101u;
    __builtin_memcpy(made + slot, &flags, sizeof flags);
    for (int a = 0; a < 3; ++a) {
      double* const to = dressed.normal[a] + slot;
      if (known == 15)
        for (int l = 0; l < 4; ++l) to[l] = double(row[a][x + l]);
      else
        for (unsigned rest = known; rest; rest &= rest - 1)
          to[__builtin_ctz(rest)] = double(row[a][x + __builtin_ctz(rest)]);
    }
  }

  double origin_[3], depth_, per_unit_;
  bool turns_, alike_;  // alike: all hits are of one iso-value
  float t_[kPlaces], iso_[kPlaces] = {}, p_[3][kPlaces] = {};
};

}  // namespace isocast::inline ISO_ISA
