// Affine maps: composition, inverse, gradients.
#include <isocast/apps/bench/random.h>
#include <isocast/math/transform.h>

#include <catch2/catch.hpp>

using namespace isocast;

namespace {

Transform any_transform(bench::Random& random) {
  Transform t;
  for (auto& row : t.m)
    for (double& x : row) x = random.uniform(-2, 2);
  return t;
}

void check_equal(const Double3& a, const Double3& b) {
  for (int i = 0; i < 3; ++i) CHECK(a[i] == Approx(b[i]).margin(1e-9));
}

}  // namespace

TEST_CASE("composition applies the right map first, the inverse undoes") {
  bench::Random random(6, 0);
  for (int n = 0; n < 100; ++n) {
    const Transform a = any_transform(random), b = any_transform(random);
    if (std::abs(a.determinant()) < 0.1) continue;
    const Double3 p = {random.uniform(), random.uniform(), random.uniform()};
    check_equal((a * b).point(p), a.point(b.point(p)));
    check_equal((a * b).vector(p), a.vector(b.vector(p)));
    check_equal(a.inverse().point(a.point(p)), p);
    CHECK((a * b).determinant() == Approx(a.determinant() * b.determinant()).margin(1e-9));
    // A^T v keeps scalar products: (A^T v) . w = v . (A w)
    CHECK(dot(a.transposed_vector(p), b.vector(p)) == Approx(dot(p, a.vector(b.vector(p)))).margin(1e-9));
  }
}

TEST_CASE("a known map") {
  Transform t;
  t.m[0][0] = 2;
  t.m[1][1] = -1;
  t.m[0][3] = 5;
  check_equal(t.point({1, 2, 3}), {7, -2, 3});
  check_equal(t.vector({1, 2, 3}), {2, -2, 3});
  CHECK(t.determinant() == -2);
  check_equal(t.inverse().point({7, -2, 3}), {1, 2, 3});
}

TEST_CASE("vectors") {
  check_equal(cross({1, 0, 0}, {0, 1, 0}), {0, 0, 1});
  CHECK(length({3, 4, 12}) == 13);
  check_equal(normalized({0, 0, 5}), {0, 0, 1});
  check_equal(normalized({0, 0, 0}), {0, 0, 0});
}
