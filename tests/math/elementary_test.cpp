// Transcendental functions against MPFR: within 1 ulp.
#include <isocast/apps/bench/random.h>
#include <isocast/math/elementary.h>
#include <mpfr.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace isocast;

namespace {

// |found - function(x)| in units of the last place of the true value.
template <class T> double error_in_ulps(int (*function)(mpfr_t, const mpfr_t, mpfr_rnd_t), T x, T found) {
  mpfr_t truth, difference;
  mpfr_init2(truth, 200);
  mpfr_init2(difference, 200);
  mpfr_set_d(truth, x, MPFR_RNDN);
  function(truth, truth, MPFR_RNDN);
  mpfr_sub_d(difference, truth, found, MPFR_RNDN);
  const long digits = std::numeric_limits<T>::digits;
  const double error = mpfr_zero_p(truth) ? mpfr_get_d(difference, MPFR_RNDN)
                                          : std::ldexp(mpfr_get_d(difference, MPFR_RNDN),
                                                       static_cast<int>(digits - mpfr_get_exp(truth)));
  mpfr_clear(truth);
  mpfr_clear(difference);
  return std::abs(error);
}

}  // namespace

template <class T> struct Function {
  const char* name;
  int (*exact)(mpfr_t, const mpfr_t, mpfr_rnd_t);
  T (*ours)(T);
  double lo, hi;
};

TEMPLATE_TEST_CASE("every function of one number is within 1 ulp", "", float, double) {
  using T = TestType;
  const Function<T> functions[] = {{"cbrt", mpfr_cbrt, [](T a) { return isocast::cbrt(a); }, -1e6, 1e6},
                                   {"exp", mpfr_exp, [](T a) { return isocast::exp(a); }, -80, 80},
                                   {"log", mpfr_log, [](T a) { return isocast::log(a); }, 1e-6, 1e6},
                                   {"log near 1", mpfr_log, [](T a) { return isocast::log(a); }, 0.99, 1.01},
                                   {"log10", mpfr_log10, [](T a) { return isocast::log10(a); }, 1e-6, 1e6},
                                   {"sin", mpfr_sin, [](T a) { return isocast::sin(a); }, -1000, 1000},
                                   {"cos", mpfr_cos, [](T a) { return isocast::cos(a); }, -1000, 1000},
                                   {"tan", mpfr_tan, [](T a) { return isocast::tan(a); }, -1000, 1000},
                                   {"asin", mpfr_asin, [](T a) { return isocast::asin(a); }, -1, 1},
                                   {"acos", mpfr_acos, [](T a) { return isocast::acos(a); }, -1, 1},
                                   {"atan", mpfr_atan, [](T a) { return isocast::atan(a); }, -20, 20},
                                   {"sinh", mpfr_sinh, [](T a) { return isocast::sinh(a); }, -88, 88},
                                   {"cosh", mpfr_cosh, [](T a) { return isocast::cosh(a); }, -88, 88},
                                   {"tanh", mpfr_tanh, [](T a) { return isocast::tanh(a); }, -10, 10}};
  bench::Random random(7, 0);
  for (const Function<T>& function : functions) {
    double worst = 0;
    for (int n = 0; n < 10'000; ++n) {
      // half of them near zero, where the function has the domain for it
      const double near = function.lo < 0 && n % 2 ? std::exp2(random.uniform(-30, 0)) : 1;
      const T a = static_cast<T>(near * random.uniform(function.lo, function.hi));
      worst = std::max(worst, error_in_ulps(function.exact, a, function.ours(a)));
    }
    CAPTURE(function.name, worst);
    CHECK(worst <= 1.0001);  // the bound that SLEEF states for tanh of a float
  }
  CHECK(isocast::acos(TestType(1)) == 0);
  CHECK(isocast::cos(TestType(0)) == 1);
  CHECK(isocast::cbrt(TestType(0)) == 0);
}
