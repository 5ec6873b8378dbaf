// Compiled once per instruction set.
#include <isocast/math/elementary.h>
#include <isocast/math/pack.h>
#include <math/pack_operations.h>

namespace isocast::inline ISO_ISA {

extern const test::PackOperations pack_operation_table;

namespace {

using test::Operation;

template <Real R> R number_of(Mask<R> m) { return select(m, R(1), R(0)); }

template <Real R> R apply(Operation operation, R a, R b, R c) {
  const Mask<R> m = a < b, n = b < c;
  switch (operation) {
    case Operation::add: return a + b;
    case Operation::subtract: return a - b;
    case Operation::multiply: return a * b;
    case Operation::divide: return a / b;
    case Operation::negate: return -a;
    case Operation::minimum: return min(a, b);
    case Operation::maximum: return max(a, b);
    case Operation::absolute: return abs(a);
    case Operation::square_root: return sqrt(abs(a));
    case Operation::multiply_add: return mul_add(a, b, c);
    case Operation::lerp: return lerp(a, b, c);
    case Operation::clamp: return clamp01(a);
    case Operation::copy_sign: return copysign(a, b);
    case Operation::inverse_power: return inverse_power_of_two(a);
    case Operation::select_less: return select(m, b, c);
    case Operation::less: return number_of<R>(a < b);
    case Operation::less_equal: return number_of<R>(a <= b);
    case Operation::greater: return number_of<R>(a > b);
    case Operation::greater_equal: return number_of<R>(a >= b);
    case Operation::equal: return number_of<R>(a == b);
    case Operation::not_equal: return number_of<R>(a != b);
    case Operation::sign: return number_of<R>(negative(a));
    case Operation::mask_and: return number_of<R>(m & n);
    case Operation::mask_or: return number_of<R>(m | n);
    case Operation::mask_xor: return number_of<R>(m != n);
    case Operation::mask_equal: return number_of<R>(m == n);
    case Operation::mask_not: return number_of<R>(!m);
    case Operation::mask_select: return number_of<R>(select(m, n, Mask<R>(true)));
    case Operation::cosine: return cos(clamp01(a));
    case Operation::arc_cosine: return acos(clamp01(a) - clamp01(b));
    default: return cbrt(a);
  }
}

template <class T> void apply_all(Operation operation, const T* a, const T* b, const T* c, T* out) {
  using R = Native<T>;
  for (int i = 0; i < test::kLanes; i += kWidth<R>)
    store(out + i, apply<R>(operation, load<R>(a + i), load<R>(b + i), load<R>(c + i)));
}

template <class T> std::uint32_t lanes_of(const T* a, const T* b) {
  using R = Native<T>;
  std::uint32_t lanes = 0;
  bool agrees = true;
  for (int i = 0; i < test::kLanes; i += kWidth<R>) {
    const Mask<R> less = load<R>(a + i) < load<R>(b + i);
    lanes |= bits_of(less) << i;
    agrees = agrees && any(less) == (bits_of(less) != 0);
  }
  return lanes | std::uint32_t(agrees) << test::kLanes;
}

}  // namespace

const test::PackOperations pack_operation_table = {apply_all<float>, apply_all<double>, lanes_of<float>,
                                                   lanes_of<double>};

}  // namespace isocast::inline ISO_ISA
