// Rays in structure of arrays: what goes between the stages of the renderer and into kernels.
#pragma once

#include <isocast/isa/std.h>

namespace isocast {

inline constexpr int kStreamSize = 256;
/// Rays in a row that make a packet: 4x4 pixels of a primary stream.
inline constexpr int kPacketSize = 16;
inline constexpr std::uint16_t kNoObject = 0xffff;

enum class RayKind : std::uint8_t { primary, shadow, reflection, transparency };

/// Up to 256 rays p(t) = o + t d in world space, t in [t_min, t_max]; d has any length. Sixteen rays in a row
/// make a packet (4x4 pixels of a primary stream). A slot without a ray has t_min > t_max.
///
/// u, v          pixel position of primary rays, in pixels from the upper left corner
/// id            pixel index of the ray, for the film
/// start_object  the object whose surface the ray starts on (kNoObject: none), and
/// start_sides   on which side of each of its iso-values it starts: bit i set means f < iso i there
struct alignas(64) RayStream {
  double ox[kStreamSize], oy[kStreamSize], oz[kStreamSize];
  double dx[kStreamSize], dy[kStreamSize], dz[kStreamSize];
  double t_min[kStreamSize], t_max[kStreamSize];
  float u[kStreamSize], v[kStreamSize];
  std::uint32_t id[kStreamSize];
  std::uint32_t start_sides[kStreamSize];
  std::uint16_t start_object[kStreamSize];
  int size;
  RayKind kind;
};

}  // namespace isocast
