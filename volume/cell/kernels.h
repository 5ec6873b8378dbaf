// The table of cell intersectors, one per instruction set.
#pragma once

#include <isocast/volume/cell/options.h>
#include <isocast/volume/cell/packet.h>

namespace isocast {

enum class Isa : std::uint8_t;  // isa/cpu.h

/// Solves `count` packets. `width` is the number of lanes of a register; a packet is always kPacketSize
/// lanes, whatever it is.
struct CellKernels {
  using SolveFloat = void(const CellOptions&, const CellPacket<float>*, RootPacket<float>*,
                          std::size_t count);
  using SolveDouble = void(const CellOptions&, const CellPacket<double>*, RootPacket<double>*,
                           std::size_t count);
  SolveFloat* solve_float[kCellMethodCount];
  SolveDouble* solve_double[kCellMethodCount];
  int width_float, width_double;
};

/// The table of an instruction set that runs here. The same cells give the same bits in all of them.
[[nodiscard]] const CellKernels& cell_kernels(Isa isa);

}  // namespace isocast
