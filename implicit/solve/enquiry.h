// What f and its derivative are over small parts of rays.
#pragma once

#include <isocast/implicit/solve/slots.h>
#include <isocast/implicit/solve/verdict.h>

namespace isocast::inline ISO_ISA {

/// The derivative of f along a ray from its gradient; row(kDx) ... row(kWz) are those of the ray.
template <Real R, class Row> ISO_HD inline Slope<R> slope_along(const Gradient<Interval<R>>& g, Row row) {
  Interval<R> d[3];
  for (int a = 0; a < 3; ++a) {
    const R middle = row(kDx + a), slack = row(kWx + a);
    d[a] = Interval<R>(middle - slack, middle + slack);
  }
  return {g.dx * d[0] + g.dy * d[1] + g.dz * d[2], g.value.continuous};
}

/// Evaluates f for the lanes that ask only, side by side in as few packs as hold them: derivatives are dear,
/// and few lanes of a pack ask at a time.
template <Real R> class Enquiry {
  using T = Scalar<R>;
  using G = Gradient<Interval<R>>;
  static constexpr int kPacks = Slots<R>::kPacks, kW = kWidth<R>;

 public:
  static constexpr std::size_t kRegisterBytes = kPacks * sizeof(G);

  /// For the small lanes of parts[n], whose rays are in pack packs[n]: the slope from near to end, f at end
  /// and, if `near_too`, at near.
  ISO_HD Enquiry(const FormulaQuery<T>& query, void* registers, const Slots<R>& slots, const int* packs,
                 const Part<R>* parts, int count, bool near_too)
      : query_(query), registers_(registers) {
    gather(slots, packs, parts, count);
    const G* const g = evaluate<G>(near_, end_);
    for (int q = 0; q < dense_; ++q) {
      const Slope<R> slope = slope_along<R>(g[q], [this, q](int row) { return get(row, q); });
      scatter(q, kSlope, slope.value);
      scatter_bits(q, smooth_, slope.continuous);
    }
    const Interval<R>* f = evaluate<Interval<R>>(end_, end_);
    for (int q = 0; q < dense_; ++q) scatter(q, kEnd, f[q]);
    if (!near_too) return;
    f = evaluate<Interval<R>>(near_, near_);
    for (int q = 0; q < dense_; ++q) scatter(q, kNear, f[q]);
  }

  /// The answers to parts[n]; lanes that did not ask hold nothing of use.
  ISO_HD Slope<R> slope(int n) const { return {answer(kSlope, n), lanes_of<R>(smooth_, n)}; }
  ISO_HD Interval<R> at_end(int n) const { return answer(kEnd, n); }
  ISO_HD Interval<R> at_near(int n) const { return answer(kNear, n); }

 private:
  enum Question { kSlope, kEnd, kNear, kQuestions };

  // Where the lane that asked stands among those of all parts.
  ISO_HD int place(int lane) const { return kSlots == 1 ? 0 : place_[lane]; }
  ISO_HD R get(int row, int q) const { return load<R>(rows_[row] + q * kW); }

  ISO_HD void gather(const Slots<R>& slots, const int* packs, const Part<R>* parts, int count) {
    int asked = 0;
    for (int n = 0; n < count; ++n) {
      T near[kW], end[kW];
      store(near, parts[n].near), store(end, parts[n].end);
      for_lanes<kW>(bits_of(parts[n].small), [&](int l) {
        for (int row = kEx; row <= kWz; ++row) rows_[row][asked] = slots.field[row][packs[n] * kW + l];
        near_[asked] = near[l], end_[asked] = end[l];
        place_[asked++] = n * kW + l;
      });
    }
    dense_ = slots.some_packs((asked + kW - 1) / kW);
    for (int l = asked; l < dense_ * kW; ++l) {
      for (int row = kEx; row <= kWz; ++row) rows_[row][l] = rows_[row][asked - 1];
      near_[l] = near_[asked - 1], end_[l] = end_[asked - 1];
      place_[l] = place_[asked - 1];
    }
  }

  template <class Kind> ISO_HD const Kind* evaluate(const T* from, const T* to) {
    Kind inputs[4 * kPacks];
    for (int q = 0; q < dense_; ++q) {
      const auto row = [this, q](int first) { return [this, q, first](int a) { return get(first + a, q); }; };
      RayPart<R>(load<R>(from + q * kW), load<R>(to + q * kW))
          .template put<kPacks>(inputs, q, query_.time, row(kEx), row(kDx), row(kWx));
    }
    return evaluate_some<kPacks>(query_.tape, static_cast<const Kind*>(inputs),
                                 static_cast<Kind*>(registers_), dense_);
  }

  ISO_HD void scatter(int q, Question question, const Interval<R>& y) {
    T lo[kW], hi[kW];
    store(lo, y.lo), store(hi, y.hi);
    for (int l = 0; l < kW; ++l) {
      lo_[question][place(q * kW + l)] = lo[l];
      hi_[question][place(q * kW + l)] = hi[l];
    }
    scatter_bits(q, defined_[question], y.defined);
    scatter_bits(q, continuous_[question], y.continuous);
    scatter_bits(q, empty_[question], y.empty);
  }
  ISO_HD void scatter_bits(int q, SlotBits& bits, Mask<R> mask) const {
    const unsigned set = bits_of(mask);
    for (int l = 0; l < kW; ++l) {
      const int at = place(q * kW + l);
      bits = (bits & ~(SlotBits(1) << at)) | SlotBits(set >> l & 1) << at;
    }
  }
  ISO_HD Interval<R> answer(Question question, int n) const {
    return Interval<R>(load<R>(lo_[question] + n * kW), load<R>(hi_[question] + n * kW),
                       lanes_of<R>(defined_[question], n), lanes_of<R>(continuous_[question], n),
                       lanes_of<R>(empty_[question], n));
  }

  const FormulaQuery<T>& query_;
  void* registers_;
  alignas(64) T rows_[kWz + 1][kSlots], near_[kSlots], end_[kSlots];
  alignas(64) T lo_[kQuestions][kSlots] = {}, hi_[kQuestions][kSlots] = {};
  SlotBits defined_[kQuestions] = {}, continuous_[kQuestions] = {}, empty_[kQuestions] = {}, smooth_ = 0;
  int place_[kSlots], dense_ = 0;
};

}  // namespace isocast::inline ISO_ISA
