// Compiled once per instruction set: triangles against the rays of a packet, in the native register of
// double.
#include <isocast/math/pack.h>
#include <isocast/scene/mesh/mesh_kernels.h>

namespace isocast::inline ISO_ISA {

extern const MeshKernels mesh_kernel_table;

namespace {

using R = Native<double>;

// Rays that pass one edge surely on the left and another surely on the right are beside the triangle.
Mask<R> surely_beside(const Projected<R> (&corner)[3]) {
  Mask<R> left(false), right(false);
  for (int i = 0; i < 3; ++i) {
    const Projected<R>&a = corner[i], &b = corner[(i + 1) % 3];
    const R e = area(a, b), error = area_error(a, b);
    left = left | (e > error);
    right = right | (e < R(-1) * error);
  }
  return left & right;
}

void may_hit(const ProjectedPacket& packet, const double* positions, const std::uint32_t* corners, int count,
             std::uint32_t* lanes) {
  for (int k = 0; k < count; ++k) lanes[k] = 0;
  for (int l = 0; l < kPacketSize; l += kWidth<R>) {
    R o[3], x[3], y[3];
    for (int a = 0; a < 3; ++a) {
      o[a] = load<R>(packet.o[a] + l);
      x[a] = load<R>(packet.x[a] + l);
      y[a] = load<R>(packet.y[a] + l);
    }
    for (int k = 0; k < count; ++k) {
      Projected<R> corner[3];
      for (int c = 0; c < 3; ++c)
        corner[c] = project(o, x, y, positions + 3 * std::size_t(corners[3 * k + c]));
      lanes[k] |= bits_of(!surely_beside(corner)) << l;
    }
  }
}

}  // namespace

const MeshKernels mesh_kernel_table = {may_hit};

}  // namespace isocast::inline ISO_ISA
