// What an intersector answered, held against what is true.
#pragma once

#include <isocast/apps/reference/cell_reference.h>
#include <isocast/apps/reference/ray_reference.h>
#include <isocast/isa/cpu.h>
#include <isocast/volume/cell/kernels.h>

#include <cstdint>
#include <span>
#include <vector>

namespace isocast::bench {

/// The names of interface.md: a root is a crossing (cell_reference.h), wrong_root a hit that is nearer to
/// another root; undecided: the method says that it does not know; unknown: the reference does.
enum class Verdict : std::uint8_t { hit, miss, false_hit, false_miss, wrong_root, undecided, unknown };

/// error  |s - s of the first crossing| (or of t), where both are
struct Judgement {
  Verdict verdict;
  double error;
};
[[nodiscard]] Judgement judge(const reference::CellReference& reference, bool hit, double s);
/// The same of a whole ray, whose truth is decided; errors in t.
[[nodiscard]] Judgement judge(const reference::RayTruth& truth, bool hit, double t);

/// The first crossing of a ray, or null.
[[nodiscard]] const reference::RayRoot* first_crossing(const reference::RayTruth& truth);
[[nodiscard]] inline double middle(const reference::RayRoot& root) { return 0.5 * (root.lo + root.hi); }

/// Between 0 and 180; 0 where a vector is zero.
[[nodiscard]] double angle_in_degrees(const Double3& a, const Double3& b);

/// Solves packets in the precision of T.
template <class T>
void solve(const CellKernels& kernels, CellMethod method, const CellOptions& options,
           std::span<const CellPacket<T>> packets, std::span<RootPacket<T>> roots) {
  const int m = static_cast<int>(method);
  if constexpr (sizeof(T) == sizeof(float))
    kernels.solve_float[m](options, packets.data(), roots.data(), packets.size());
  else kernels.solve_double[m](options, packets.data(), roots.data(), packets.size());
}
template <class T>
[[nodiscard]] std::vector<RootPacket<T>> solve(Isa isa, CellMethod method, const CellOptions& options,
                                               const std::vector<CellPacket<T>>& packets) {
  std::vector<RootPacket<T>> roots(packets.size());
  solve<T>(cell_kernels(isa), method, options, packets, roots);
  return roots;
}

/// One lane's answer.
struct Answer {
  bool hit, undecided, negative_behind, proved;
  double s, s_lo, s_hi;
};
template <class T> [[nodiscard]] Answer answer_of(const std::vector<RootPacket<T>>& roots, std::size_t n) {
  const RootPacket<T>& packet = roots[n / kPacketSize];
  const std::size_t lane = n % kPacketSize;
  const auto bit = [&](std::uint32_t bits) { return (bits >> lane & 1) != 0; };
  return {bit(packet.hit), bit(packet.undecided), bit(packet.sign), bit(packet.proved),
          packet.s[lane],  packet.s_lo[lane],     packet.s_hi[lane]};
}

}  // namespace isocast::bench
