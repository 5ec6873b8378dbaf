// Compiled once per instruction set: neighbours' normals over the native registers of double and float.
#include <isocast/ray/neighbour_normals.h>
#include <isocast/ray/neighbour_triangles.h>

namespace isocast::inline ISO_ISA {

extern const NormalKernels normal_kernel_table;

namespace {

int find_neighbour_normals(const RayStream& rays, const HitStream& hits, std::uint16_t object,
                           DressedHits& dressed, bool (&made)[kStreamSize]) {
  for (bool& one : made) one = false;
  int own = 0;
  for (const std::uint16_t hit : hits.object) own += hit == object;
  if (own == 0) return 0;
  double t[kStreamSize];
  for (int i = 0; i < kStreamSize; ++i) t[i] = hits.object[i] == object ? hits.t[i] : __builtin_inf();
  for (int first = 0; first < kStreamSize; ++first)
    if (t[first] < __builtin_inf()) return NeighbourTriangles(rays, hits, t, first).find(dressed, made);
  return 0;
}

}  // namespace

const NormalKernels normal_kernel_table = {find_neighbour_normals};

}  // namespace isocast::inline ISO_ISA
