// What a formula's kernel is given.
#pragma once

#include <isocast/implicit/solve/segment.h>

namespace isocast {

/// Segments of `streams` streams, whose roots it fills. The tape of `query` is only for kernels that
/// interpret it.
template <class T> struct SegmentWork {
  FormulaQuery<T> query;
  const SegmentStream<T>* segments;
  SegmentRoots<T>* roots;
  std::int32_t streams;
};

}  // namespace isocast
