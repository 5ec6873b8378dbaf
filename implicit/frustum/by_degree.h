// Tables of polynomials, made once a degree.
#pragma once

#include <isocast/implicit/frustum/bezier.h>

#include <array>
#include <mutex>

namespace isocast {

/// make(degree), 0 <= degree <= kMostFormDegree, from the first call on and for good. Any thread may call it.
template <auto make> const auto& made_once(int degree) {
  static std::array<decltype(make(0)), kMostFormDegree + 1> made;
  static std::array<std::once_flag, kMostFormDegree + 1> flags;
  const auto d = static_cast<std::size_t>(degree);
  std::call_once(flags[d], [&] { made[d] = make(degree); });
  return made[d];
}

}  // namespace isocast
