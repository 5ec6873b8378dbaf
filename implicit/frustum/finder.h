// What the root finders of the frustum form share.
#pragma once

#include <isocast/implicit/frustum/bezier.h>

namespace isocast {

/// signs: of `certified`, not from the source
enum class RootFinder : std::uint8_t { lr, mr, lr_mult, mr_mult, schneider, clip, signs };

/// eps     in the polynomial's parameter
/// value   stop where |f| < eps^2 of the largest coefficient, or a subdivision's interval is shorter than
/// eps,
///         as the older methods do, and not by the knots' density
/// most    subdivisions of a ray, at most 64; three times as many knots are inserted, eight times as often is
/// one
///         clipped
struct FinderOptions {
  RootFinder finder = RootFinder::lr;
  double eps = 0x1p-11;
  bool value = false;
  int most = 64;
};

}  // namespace isocast

namespace isocast::inline ISO_ISA {

/// The smallest root in [0, 1], one a lane.
///
/// open   the steps ended before the search did: s is where it stood
/// sure   of a hit: if signs prove a root beside it, there is no other in front; of a miss: it is proved
/// steps  subdivisions or inserted knots
template <Real R> struct FirstRoot {
  R s = R(0);
  Mask<R> hit = Mask<R>(false), open = Mask<R>(false), sure = Mask<R>(false);
  R steps = R(0);

  void settle(Mask<R> lanes, R at) {
    s = select(lanes, at, s);
    hit = hit | lanes;
  }
  void give_up(Mask<R> lanes, R at) {
    open = open | lanes;
    settle(lanes, at);
  }
};

/// Newton's step at a root of multiplicity m is m times too short: what to multiply it by, from a value and
/// two derivatives there, 1 to `most`. The source cites an unpublished report; this rule is ours.
template <Real R> inline R step_factor(R f, R slope, R bend, R most) {
  const R m = R(1) / (R(1) - f * bend / (slope * slope));
  const R whole = floor(m + R(0.5));
  return select(whole == whole, min(max(whole, R(1)), most), R(1));
}

}  // namespace isocast::inline ISO_ISA
