// Compiled once per instruction set.
#include <isocast/math/pack.h>
#include <math/inclusion_kernels.h>
#include <math/inclusion_operations.h>

namespace isocast::inline ISO_ISA {

extern const test::InclusionKernels inclusion_kernel_table;

namespace {

constexpr int kLanes = test::kInclusionLanes;

template <Real R> void read(const Scalar<R>* in, Interval<R>& a) { a = {load<R>(in), load<R>(in + kLanes)}; }
template <Real R, int N> void read(const Scalar<R>* in, AffineForm<R, N>& a) {
  a = AffineForm<R, N>(load<R>(in));
  for (int k = 0; k < N; ++k) a.e[k] = load<R>(in + (k + 1) * kLanes);
  a.r = load<R>(in + (N + 1) * kLanes);
}
template <Real R> void read(const Scalar<R>* in, Gradient<Interval<R>>& a) {
  const Interval<R> zero(R(0)), one(R(1));
  read(in, a.value);
  a.dx = one, a.dy = a.value, a.dz = zero;
}

template <Real R, class F> Scalar<R>* write_decorations(const F& a, Scalar<R>* out) {
  store(out, select(a.defined, R(1), R(0)) + select(a.continuous, R(2), R(0)) + select(a.empty, R(4), R(0)));
  return out + kLanes;
}
template <Real R> Scalar<R>* write(const Interval<R>& a, Scalar<R>* out) {
  store(out, a.lo);
  store(out + kLanes, a.hi);
  return write_decorations<R>(a, out + 2 * kLanes);
}
template <Real R, int N> Scalar<R>* write(const AffineForm<R, N>& a, Scalar<R>* out) {
  store(out, a.c);
  for (int k = 0; k < N; ++k) store(out + (k + 1) * kLanes, a.e[k]);
  store(out + (N + 1) * kLanes, a.r);
  return write_decorations<R>(a, out + (N + 2) * kLanes);
}
template <Real R> Scalar<R>* write(const Gradient<Interval<R>>& a, Scalar<R>* out) {
  return write(a.dz, write(a.dy, write(a.dx, write(a.value, out))));
}

template <class F, Real R>
void apply_lanes(test::Inclusion operation, int n, const Scalar<R>* a, const Scalar<R>* b, Scalar<R>* out) {
  for (int i = 0; i < kLanes; i += kWidth<R>) {
    F x, y;
    read(a + i, x);
    read(b + i, y);
    write(apply(operation, x, y, n), out + i);
  }
}

template <class T>
void apply_all(test::Kind kind, test::Inclusion operation, int n, const T* a, const T* b, T* out) {
  using R = Native<T>;
  switch (kind) {
    case test::Kind::interval: return apply_lanes<Interval<R>, R>(operation, n, a, b, out);
    case test::Kind::affine_1: return apply_lanes<AffineForm<R, 1>, R>(operation, n, a, b, out);
    case test::Kind::affine_3: return apply_lanes<AffineForm<R, 3>, R>(operation, n, a, b, out);
    default: return apply_lanes<Gradient<Interval<R>>, R>(operation, n, a, b, out);
  }
}

}  // namespace

const test::InclusionKernels inclusion_kernel_table = {apply_all<float>, apply_all<double>};

}  // namespace isocast::inline ISO_ISA
