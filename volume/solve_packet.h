// One packet of cells through the query's intersector.
#pragma once

#include <isocast/isa/isa.h>
#include <isocast/volume/query.h>

namespace isocast::inline ISO_ISA {

inline void solve_packet(const VolumeQuery& query, const CellPacket<float>& packet,
                         RootPacket<float>& roots) {
  query.cells->solve_float[int(query.method)](query.options, &packet, &roots, 1);
}
inline void solve_packet(const VolumeQuery& query, const CellPacket<double>& packet,
                         RootPacket<double>& roots) {
  query.cells->solve_double[int(query.method)](query.options, &packet, &roots, 1);
}

}  // namespace isocast::inline ISO_ISA
