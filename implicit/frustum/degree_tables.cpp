#include <isocast/implicit/frustum/collocation.h>
#include <isocast/implicit/frustum/degree_tables.h>

namespace isocast {

DegreeMatrices::DegreeMatrices(int degree, int checks)
    : degree_(degree), halves_{part_matrix(degree, 0, 0.5), part_matrix(degree, 0.5, 1)} {
  const std::size_t n = static_cast<std::size_t>(degree) + 1;
  at_checks_.resize(collocation(checks).points.size() * n);
  double* row = at_checks_.data();
  for (const double x : collocation(checks).points) {
    bernstein_values(degree, x, row);
    row += n;
  }
}

DegreeTables DegreeMatrices::view() const {
  const Collocation& nodes = collocation(degree_);
  return {degree_,
          nodes.points.data(),
          nodes.from_values.data(),
          at_checks_.data(),
          {halves_[0].data(), halves_[1].data()}};
}

}  // namespace isocast
