// A formula along a ray, in balls.
#pragma once

#include <isocast/apps/reference/enclosure.h>
#include <isocast/apps/reference/exact_formula.h>

#include <vector>

namespace isocast::reference {

/// One axis of the points p(s) = start + s span of a ray, s from 0 to 1; exact.
struct RayAxis {
  Ball start, span;
};

/// f - iso along one ray. For one thread; the formula outlives it.
class FormulaBalls {
 public:
  FormulaBalls(const ExactFormula& formula, const RayAxis (&axes)[3]) : formula_(formula), axes_(axes) {}

  /// Over all s of a ball, computed with `bits`; slopes only if `sloped`.
  [[nodiscard]] Enclosure over(const Ball& s, slong bits, bool sloped);
  /// At an exact s, with 64, 128, ... up to `max_bits` until the sign is known or the value exactly zero;
  /// not a number where f has no value.
  [[nodiscard]] Ball at(const Ball& s, slong max_bits);

  /// Bits that at() last needed, and the operations done so far.
  [[nodiscard]] slong bits() const { return bits_; }
  [[nodiscard]] std::int64_t operations() const { return operations_; }

 private:
  const ExactFormula& formula_;
  const RayAxis (&axes_)[3];
  std::vector<Enclosure> values_;
  slong bits_ = 64;
  std::int64_t operations_ = 0;
};

}  // namespace isocast::reference
