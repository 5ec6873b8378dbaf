// Schwarze: all roots of the cubic in closed form (Cardano), the smallest in the cell.
#pragma once

#include <isocast/math/elementary.h>
#include <isocast/volume/cell/cell.h>

namespace isocast::inline ISO_ISA {

/// Coefficients below this many unit roundoffs of the largest count as zero.
inline constexpr int kDegenerateUlps = 16;

/// The smallest root of a s^3 + b s^2 + c s + d in (begin, 1], by degree: line, quadratic, Cardano's cubic.
/// Every case is computed and selected. Near double roots the discriminant cancels, and small a make the
/// normalised coefficients huge: roots are then lost, invented or off (the paper's R-MAR-7). Touching roots
/// count as hits here. source  Schwarze: Cubic and quartic roots, Graphics Gems, 1990; Marmitt et al., VMV
/// 2004
template <Real R> ISO_HD inline Root<R> schwarze(const Cell<R>& cell, const CellOptions& options) {
  const PowerCubic<R> raw = options.stable ? power_form(cubic_along(cell)) : textbook_cubic_along(cell);
  const R largest = max(max(abs(raw.a), abs(raw.b)), max(abs(raw.c), abs(raw.d)));
  const R scale = inverse_power_of_two(largest), small = R(kDegenerateUlps * kUnitRoundoff<Scalar<R>>);
  const R a3 = raw.a * scale, a2 = raw.b * scale, a1 = raw.c * scale, a0 = raw.d * scale;
  const R nothing = R(2);  // outside (begin, 1]

  R first = nothing;
  const auto offer = [&](R s, Mask<R> valid) {
    first = select(valid & (s > cell.begin) & (s <= R(1)) & (s < first), s, first);
  };
  const Mask<R> is_cubic = abs(a3) > small, is_quadratic = (!is_cubic) & (abs(a2) > small);

  // the line a1 s + a0
  offer(-a0 / a1, (!is_cubic) & (!is_quadratic) & (abs(a1) > R(0)));

  // the quadratic, without cancellation
  if (any(is_quadratic)) {
    const R p = a1 / (R(2) * a2), q = a0 / a2, discriminant = p * p - q;
    const R w = -(p + copysign(sqrt(discriminant), p));
    const Mask<R> real = is_quadratic & (discriminant >= R(0));
    offer(w, real);
    offer(select(w == R(0), R(0), q / w), real);
  }

  // y^3 + 3 p y + 2 q with s = y - a/3
  if (any(is_cubic)) {
    const R a = a2 / a3, b = a1 / a3, c = a0 / a3, third = R(1) / R(3);
    const R shift = a * third;
    const R p = third * (b - a * shift), q = R(0.5) * (R(2) * shift * shift * shift - shift * b + c);
    const R p3 = p * p * p, discriminant = q * q + p3;
    const Mask<R> flat = is_cubic & (discriminant == R(0)), three = is_cubic & (discriminant < R(0)),
                  one = is_cubic & (discriminant > R(0));
    if (any(flat)) {
      const R u = cbrt(-q);
      offer(R(2) * u - shift, flat);
      offer(-u - shift, flat);
    }
    if (any(three)) {
      constexpr Scalar<R> kThirdOfPi = Scalar<R>(1.0471975511965977461542144610932);
      const R cosine = select(three, max(R(-1), min(-q / sqrt(-p3), R(1))), R(0));
      const R angle = third * acos(cosine), m = R(2) * sqrt(select(three, -p, R(0)));
      offer(m * cos(angle) - shift, three);
      offer(-m * cos(angle + R(kThirdOfPi)) - shift, three);
      offer(-m * cos(angle - R(kThirdOfPi)) - shift, three);
    }
    if (any(one)) {
      const R root = sqrt(select(one, discriminant, R(0)));
      offer(cbrt(root - q) - cbrt(root + q) - shift, one);
    }
  }
  const Mask<R> behind = negative(((a3 * R(3) * first + R(2) * a2) * first + a1));
  return {first, first, first, first <= R(1), Mask<R>(false), behind};
}

}  // namespace isocast::inline ISO_ISA
