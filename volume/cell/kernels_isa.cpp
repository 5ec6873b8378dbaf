// Compiled once per instruction set: every intersector over the native register of float and double.
#include <isocast/math/pack.h>
#include <isocast/volume/cell/certified.h>
#include <isocast/volume/cell/kernels.h>
#include <isocast/volume/cell/linear.h>
#include <isocast/volume/cell/marmitt.h>
#include <isocast/volume/cell/midpoint.h>
#include <isocast/volume/cell/neubauer.h>
#include <isocast/volume/cell/schwarze.h>

namespace isocast::inline ISO_ISA {

extern const CellKernels cell_kernel_table;

namespace {

template <Real R> Cell<R> load_cell(const CellPacket<Scalar<R>>& packet, int lane) {
  Cell<R> cell;
  for (int i = 0; i < 8; ++i) cell.f[i] = load<R>(packet.f[i] + lane);
  cell.entry = {load<R>(packet.entry[0] + lane), load<R>(packet.entry[1] + lane),
                load<R>(packet.entry[2] + lane)};
  cell.exit = {load<R>(packet.exit[0] + lane), load<R>(packet.exit[1] + lane),
               load<R>(packet.exit[2] + lane)};
  cell.begin = load<R>(packet.begin + lane);
  cell.carry = load<R>(packet.carry + lane);
  cell.slack = load<R>(packet.slack + lane);
  return cell;
}

template <class T> struct Methods {
  using R = Native<T>;
  using Intersector = Root<R>(const Cell<R>&, const CellOptions&);

  // One register at a time; a register without an active lane is skipped.
  template <Intersector* intersect>
  static void solve(const CellOptions& options, const CellPacket<T>* packets, RootPacket<T>* roots,
                    std::size_t count) {
    constexpr unsigned lanes = (1ull << kWidth<R>)-1;
    for (std::size_t i = 0; i < count; ++i) {
      std::uint32_t hit = 0, undecided = 0, sign = 0, proved = 0;
      for (int lane = 0; lane < kPacketSize; lane += kWidth<R>) {
        const std::uint32_t active = packets[i].active >> lane & lanes;
        if (active == 0) continue;
        const Root<R> root = intersect(load_cell<R>(packets[i], lane), options);
        store(roots[i].s + lane, root.s);
        store(roots[i].s_lo + lane, root.s_lo);
        store(roots[i].s_hi + lane, root.s_hi);
        hit |= (bits_of(root.hit) & active) << lane;
        undecided |= (bits_of(root.undecided) & active) << lane;
        sign |= (bits_of(root.sign_behind) & active) << lane;
        proved |= (bits_of(root.proved) & active) << lane;
      }
      roots[i].hit = hit;
      roots[i].undecided = undecided;
      roots[i].sign = sign;
      roots[i].proved = proved;
    }
  }
};

template <class T> using M = Methods<T>;

}  // namespace

// the order of CellMethod
const CellKernels cell_kernel_table = {
    {M<float>::solve<midpoint>, M<float>::solve<linear>, M<float>::solve<neubauer>, M<float>::solve<schwarze>,
     M<float>::solve<marmitt>, M<float>::solve<certified>},
    {M<double>::solve<midpoint>, M<double>::solve<linear>, M<double>::solve<neubauer>,
     M<double>::solve<schwarze>, M<double>::solve<marmitt>, M<double>::solve<certified>},
    kWidth<Native<float>>,
    kWidth<Native<double>>};

}  // namespace isocast::inline ISO_ISA
