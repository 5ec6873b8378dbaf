// Rewrites of a formula that keep its meaning exactly and spare operations.
#pragma once

#include <isocast/implicit/expression/expression.h>

namespace isocast {

/// Integer powers above this go through pow, like powers that are no integers.
inline constexpr int kMaxPower = 1024;

/// The same function with less to do, and undefined (NaN) wherever it was. Evaluated in double precision it
/// gives the same bits, except that integer powers are products and no longer pow, and that Chebyshev
/// polynomials are what they are and no longer what rounding made of them.
///
/// constants  an operation on numbers is done now when its result is exact in double precision; 0.1 + 0.2 and
///            sqrt(2) stay
/// powers     x^2 and x * x become square, x^n with a literal integer n, |n| <= kMaxPower, becomes power
///            (repeated squaring)
/// chebyshev  what is exactly T_n(u), 3 <= n <= 50, becomes that, however it is written (see polynomial.h);
///            T_m(T_n(u)) becomes T_mn(u)
/// truth      0 and 1 of comparisons are not made 0 or 1 again; if(not c, a, b) becomes if(c, b, a), and a
///            condition that is a number decides now
/// neutral    x * 1, x / 1, x - 0, x^1, -(-x) become x, and x + 0 too unless x may be -0; x / 4 becomes x *
///            0.25
/// signs      a + -b and a - -b become a - b and a + b
/// shared     operands of + and * are put in one order, so that a + b and b + a are one node
/// never      x * 0, x - x, x / x and the like, which hide where x is undefined
[[nodiscard]] Expression simplify(const Expression& expression);

}  // namespace isocast
