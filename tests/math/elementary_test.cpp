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

TEMPLATE_TEST_CASE("cos, acos and cbrt are within 1 ulp", "", float, double) {
  bench::Random random(7, 0);
  double worst[3] = {};
  for (int n = 0; n < 20'000; ++n) {
    const auto angle = static_cast<TestType>(random.uniform(-7, 7)),
               cosine = static_cast<TestType>(random.uniform(-1, 1));
    const auto number = static_cast<TestType>(random.sign() * std::exp2(random.uniform(-60, 60)));
    worst[0] = std::max(worst[0], error_in_ulps(mpfr_cos, angle, isocast::cos(angle)));
    worst[1] = std::max(worst[1], error_in_ulps(mpfr_acos, cosine, isocast::acos(cosine)));
    worst[2] = std::max(worst[2], error_in_ulps(mpfr_cbrt, number, isocast::cbrt(number)));
  }
  CAPTURE(worst[0], worst[1], worst[2]);
  for (const double error : worst) CHECK(error <= 1);
  CHECK(isocast::acos(TestType(1)) == 0);
  CHECK(isocast::cos(TestType(0)) == 1);
  CHECK(isocast::cbrt(TestType(0)) == 0);
}
