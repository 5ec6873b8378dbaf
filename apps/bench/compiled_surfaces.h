// Two surfaces of the catalogue written by hand for any kind of number, operation by operation as their
// simplified tapes, with everything inlined: what a formula costs at best.
#pragma once

#include <isocast/implicit/solve/inclusion.h>

namespace isocast::inline ISO_ISA {

/// x^4 - 5 x^2 + y^4 - 5 y^2 + z^4 - 5 z^2 + 11.8
struct CompiledTangle {
  template <class F> [[gnu::flatten]] static inline F value(const F& x, const F& y, const F& z) {
    const F five = constant_as({5, true}, F{});
    F f = power(x, 4) - five * square(x);
    f = (f + power(y, 4)) - five * square(y);
    f = (f + power(z, 4)) - five * square(z);
    return f + constant_as({11.8, false}, F{});
  }
};

/// 8 (x^2 - phi^4 y^2) (y^2 - phi^4 z^2) (z^2 - phi^4 x^2)
///   (x^4 + y^4 + z^4 - 2 x^2 y^2 - 2 x^2 z^2 - 2 y^2 z^2)
///   + (3 + 5 phi) (x^2 + y^2 + z^2 - 1)^2 (x^2 + y^2 + z^2 - (2 - phi))^2
struct CompiledBarthDecic {
  template <class F> [[gnu::flatten]] static inline F value(const F& x, const F& y, const F& z) {
    const F one = constant_as({1, true}, F{}), two = constant_as({2, true}, F{}),
            three = constant_as({3, true}, F{}), five = constant_as({5, true}, F{}),
            eight = constant_as({8, true}, F{}), phi = constant_as({1.618033988749895, false}, F{}),
            phi4 = power(phi, 4), xx = square(x), yy = square(y), zz = square(z);
    const F planes = eight * (xx - phi4 * yy) * (yy - phi4 * zz) * (zz - phi4 * xx);
    const F quartic =
        (power(x, 4) + power(y, 4) + power(z, 4)) - two * xx * yy - two * xx * zz - two * yy * zz;
    const F sum = xx + yy + zz;
    return planes * quartic + (three + five * phi) * square(sum - one) * square(sum - (two - phi));
  }
};

}  // namespace isocast::inline ISO_ISA
