// Surfaces as functions that their source text was compiled to.
#pragma once

#include <isocast/implicit/solve/inclusion.h>

namespace isocast::test {

/// f at x, y, z, w, into the last argument.
template <class R> using WrittenFunction = void(R, R, R, R, R*);
struct WrittenSurface {
  const char* id;
  WrittenFunction<double>* number;
  WrittenFunction<Interval<float>>* interval;
  WrittenFunction<AffineForm<float, 1>>* affine;
  WrittenFunction<Gradient<Interval<float>>>* gradient;
};
extern const WrittenSurface kWrittenSurfaces[];
extern const int kWrittenCount;

}  // namespace isocast::test
