// Compiled once per instruction set: every solver over the native register of float and double.
#include <isocast/implicit/solve/bisection.h>
#include <isocast/implicit/solve/kernels.h>
#include <isocast/math/pack.h>

namespace isocast::inline ISO_ISA {

extern const FormulaKernels formula_kernel_table;

namespace {

template <class F, class T>
void solve(const FormulaQuery<T>& query, const SegmentPacket<T>& packet, SegmentRoots<T>& roots,
           void* registers) {
  using R = Native<T>;
  constexpr unsigned kLanes = (1ull << kWidth<R>)-1;
  roots.hit = roots.proved = roots.crossing = 0;
  for (int lane = 0; lane < kSegments; lane += kWidth<R>) {
    const std::uint32_t active = packet.active >> lane & kLanes;
    if (active == 0) continue;
    SegmentLanes<R> lanes(query, packet, lane, registers);
    const SegmentRoot<R> root = first_root<F>(lanes, load<R>(packet.smallest + lane), lanes_of<R>(active));
    store(roots.s + lane, R(0.5) * root.lo + R(0.5) * root.hi);
    store(roots.s_lo + lane, root.lo);
    store(roots.s_hi + lane, root.hi);
    const std::uint32_t hit = bits_of(root.hit) & active;
    roots.hit |= hit << lane;
    roots.crossing |= (bits_of(root.crossing) & hit) << lane;
    roots.proved |= (active & ~bits_of(root.doubt) & (~hit | bits_of(root.crossing)) & kLanes) << lane;
    T iso[kWidth<R>], runs[kWidth<R>];
    store(iso, root.iso);
    store(runs, lanes.runs);
    const Interval<R> f = lanes.at(root.lo);
    std::uint32_t below[kMostIsos];
    for (int i = 0; i < query.iso_count; ++i)
      below[i] = bits_of(
          select(root.crossing & (root.iso == R(T(i))), root.below, lanes.sides_at(root.lo, f, i).below));
    for (int l = 0; l < kWidth<R>; ++l) {
      roots.iso[lane + l] = static_cast<std::uint8_t>(iso[l]);
      roots.evaluations[lane + l] = static_cast<std::uint32_t>(runs[l]);
      roots.sides[lane + l] = 0;
      for (int i = 0; i < query.iso_count; ++i) roots.sides[lane + l] |= (below[i] >> l & 1) << i;
    }
  }
}

template <class T> using R = Native<T>;

}  // namespace

// the order of FormulaMethod
const FormulaKernels formula_kernel_table = {
    {solve<Interval<R<float>>, float>, solve<AffineForm<R<float>, 1>, float>},
    {solve<Interval<R<double>>, double>, solve<AffineForm<R<double>, 1>, double>},
    sizeof(Gradient<Interval<R<double>>>) > sizeof(Gradient<Interval<R<float>>>)
        ? sizeof(Gradient<Interval<R<double>>>)
        : sizeof(Gradient<Interval<R<float>>>)};

}  // namespace isocast::inline ISO_ISA
