// The matrices of one degree, as kernels read them.
#pragma once

#include <isocast/implicit/frustum/block_query.h>

#include <vector>

namespace isocast {

class DegreeMatrices {
 public:
  /// checks  the degree whose points at_checks is for
  DegreeMatrices(int degree, int checks);

  /// For as long as this object lives.
  [[nodiscard]] DegreeTables view() const;

 private:
  int degree_;
  std::vector<double> at_checks_, halves_[2];
};

}  // namespace isocast
