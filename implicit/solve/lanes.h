// One register's share of a SegmentPacket, and the values of a formula on it.
#pragma once

#include <isocast/implicit/solve/inclusion.h>
#include <isocast/implicit/solve/segment.h>

namespace isocast::inline ISO_ISA {

/// Lanes whose bit is set, counted from bit 0.
template <Real R> ISO_HD inline Mask<R> lanes_of(std::uint32_t bits) {
  Scalar<R> set[kWidth<R>];
  for (int l = 0; l < kWidth<R>; ++l) set[l] = Scalar<R>(bits >> l & 1);
  return load<R>(set) > R(0);
}

/// Where f lies with regard to an iso-value. Neither: not known.
template <Real R> struct Sides { Mask<R> below, above; };

/// Some lanes' segments and the formula, with room for its registers.
template <Real R> class SegmentLanes {
  using T = Scalar<R>;

 public:
  ISO_HD SegmentLanes(const FormulaQuery<T>& query, const SegmentPacket<T>& packet, int lane, void* registers)
      : query_(query), registers_(registers) {
    for (int a = 0; a < 3; ++a) {
      e_[a] = Interval<R>(load<R>(packet.e_lo[a] + lane), load<R>(packet.e_hi[a] + lane));
      d_[a] = Interval<R>(load<R>(packet.d_lo[a] + lane), load<R>(packet.d_hi[a] + lane));
    }
    begin = load<R>(packet.begin + lane);
    carried_ = lanes_of<R>(packet.carried >> lane);
    for (int i = 0; i < query.iso_count; ++i) {
      std::uint32_t below = 0;
      for (int l = 0; l < kWidth<R>; ++l) below |= (packet.sides[lane + l] >> i & 1) << l;
      starts_below_[i] = lanes_of<R>(below);
    }
  }

  R begin;
  R runs = R(0);  // of the tape, on behalf of each lane

  ISO_HD void count(Mask<R> lanes, int more) { runs = runs + select(lanes, R(T(more)), R(0)); }

  /// f over the part from s0 to s1, as an F: Interval<R>, AffineForm<R, 1> or a Gradient of one.
  template <class F> ISO_HD F over(R s0, R s1) {
    F inputs[4];
    for (int a = 0; a < 3; ++a) put(inputs[a], coordinate(a, s0), coordinate(a, s1), a);
    inputs[3] = constant_as({query_.time, true}, F{});
    return evaluate(query_.tape, inputs, static_cast<F*>(registers_));
  }
  /// f at the points s.
  ISO_HD Interval<R> at(R s) { return over<Interval<R>>(s, s); }

  /// The derivative of f along the segment, over a part.
  ISO_HD Interval<R> slope(R s0, R s1) {
    const auto g = over<Gradient<Interval<R>>>(s0, s1);
    return g.dx * d_[0] + g.dy * d_[1] + g.dz * d_[2];
  }

  ISO_HD int iso_count() const { return query_.iso_count; }
  ISO_HD bool trims() const { return query_.options.trim; }

  /// Sides of iso i; an undefined f has none.
  ISO_HD Sides<R> sides(const Interval<R>& f, int i) const {
    return {f.hi<R(query_.iso_lo[i]), f.lo> R(query_.iso_hi[i])};
  }
  /// The same at the point s, where f has the inclusion `f`: known where the segment's start is.
  ISO_HD Sides<R> sides_at(R s, const Interval<R>& f, int i) const {
    const Mask<R> start = at_known_start(s), defined = f.defined;
    const Sides<R> found = sides(f, i);
    return {select(start, starts_below_[i], found.below & defined),
            select(start, !starts_below_[i], found.above & defined)};
  }
  ISO_HD Mask<R> at_known_start(R s) const { return carried_ & (s == begin); }
  /// No iso-value lies in f: the only reason to reject a part.
  ISO_HD Mask<R> leaves_out(const Interval<R>& f) const {
    Mask<R> out = Mask<R>(true);
    for (int i = 0; i < query_.iso_count; ++i) {
      const Sides<R> s = sides(f, i);
      out = out & (s.below | s.above);
    }
    return out | f.empty;
  }
  ISO_HD Interval<R> iso(int i) const { return Interval<R>(R(query_.iso_lo[i]), R(query_.iso_hi[i])); }

 private:
  ISO_HD Interval<R> coordinate(int a, R s) const { return e_[a] + Interval<R>(s) * d_[a]; }
  template <class F> ISO_HD static void put(F& input, const Interval<R>& p, const Interval<R>& q, int) {
    input = coordinate_between(p, q, F{});
  }
  template <class F>
  ISO_HD static void put(Gradient<F>& input, const Interval<R>& p, const Interval<R>& q, int axis) {
    input = Gradient<F>(coordinate_between(p, q, F{}), F(T(axis == 0)), F(T(axis == 1)), F(T(axis == 2)));
  }

  const FormulaQuery<T>& query_;
  void* registers_;
  Interval<R> e_[3], d_[3];
  Mask<R> carried_, starts_below_[kMostIsos];
};

}  // namespace isocast::inline ISO_ISA
