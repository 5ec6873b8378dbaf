// FLINT's exact numbers and polynomials as values.
#pragma once

#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>
#include <flint/fmpz_poly.h>

namespace isocast::reference {

inline void initialize(fmpq* x) { fmpq_init(x); }
inline void release(fmpq* x) { fmpq_clear(x); }
inline void assign(fmpq* x, const fmpq* y) { fmpq_set(x, y); }
inline void exchange(fmpq* x, fmpq* y) { fmpq_swap(x, y); }

inline void initialize(fmpq_poly_struct* x) { fmpq_poly_init(x); }
inline void release(fmpq_poly_struct* x) { fmpq_poly_clear(x); }
inline void assign(fmpq_poly_struct* x, const fmpq_poly_struct* y) { fmpq_poly_set(x, y); }
inline void exchange(fmpq_poly_struct* x, fmpq_poly_struct* y) { fmpq_poly_swap(x, y); }

inline void initialize(fmpz_poly_struct* x) { fmpz_poly_init(x); }
inline void release(fmpz_poly_struct* x) { fmpz_poly_clear(x); }
inline void assign(fmpz_poly_struct* x, const fmpz_poly_struct* y) { fmpz_poly_set(x, y); }
inline void exchange(fmpz_poly_struct* x, fmpz_poly_struct* y) { fmpz_poly_swap(x, y); }

/// A T of FLINT that frees itself; its address goes wherever FLINT wants one.
template <class T> class Owned {
 public:
  Owned() { initialize(&value_); }
  Owned(const Owned& other) : Owned() { assign(&value_, &other.value_); }
  Owned(Owned&& other) noexcept : Owned() { exchange(&value_, &other.value_); }
  Owned& operator=(Owned other) noexcept {
    exchange(&value_, &other.value_);
    return *this;
  }
  ~Owned() { release(&value_); }

  [[nodiscard]] const T* get() const { return &value_; }
  [[nodiscard]] T* set() { return &value_; }

 private:
  T value_;
};

using Rational = Owned<fmpq>;
using RationalPolynomial = Owned<fmpq_poly_struct>;
using WholePolynomial = Owned<fmpz_poly_struct>;

}  // namespace isocast::reference
