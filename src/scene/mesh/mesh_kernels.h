// Which rays of a packet may hit triangles, one table per instruction set.
#pragma once

#include <isocast/scene/mesh/projection.h>

namespace isocast {

enum class Isa : std::uint8_t;  // isa/cpu.h

/// may_hit  for `count` triangles of three corners each, numbers of positions (x, y, z in a row): one bit per
///          ray that is not surely beside it
struct MeshKernels {
  void (*may_hit)(const ProjectedPacket& packet, const double* positions, const std::uint32_t* corners,
                  int count, std::uint32_t* lanes);
};

/// The table of an instruction set that runs here.
[[nodiscard]] const MeshKernels& mesh_kernels(Isa isa);

}  // namespace isocast
