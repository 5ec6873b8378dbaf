// What the reference says of a formula along a ray.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace isocast::reference {

/// lo <= root <= hi, in t; no other root lies between, but that balls take a change of sign within 2^-60 of
/// the range asked for as one root. `crossing`: f changes sign there, else it only touches the iso-value. f
/// is continuous there.
struct FormulaRoot {
  double lo, hi;
  bool crossing;
};

/// Why a range of t is not decided: f comes close to the iso-value and perhaps touches it, f is it all along
/// or seems so, f jumps, f is somewhere undefined (a pole, an edge of what is defined), or too much work.
enum class Doubt { touch, zero, jump, undefined, work };
struct DoubtfulRange {
  double lo, hi;
  Doubt doubt;
};

/// roots   in increasing order
/// doubts  in increasing order: of these ranges nothing is known but the roots listed there
/// end     nothing is said of what lies beyond; the end asked for, or that of the last root
/// bits    the precision that was used at most, 0 for exact arithmetic
struct FormulaRoots {
  std::vector<FormulaRoot> roots;
  std::vector<DoubtfulRange> doubts;
  double end = 0;
  int bits = 0;
  [[nodiscard]] bool decided() const { return doubts.empty(); }
};

/// width           of a root's bracket, at most, as far as double precision can tell such numbers apart; in t
/// max_roots       the search ends with that many, at least 1
/// max_bits        of balls
/// max_operations  of balls, about; a million take a quarter of a second
/// exact           polynomials with rational coefficients are solved exactly where that is no great work
struct ReferenceOptions {
  double width = 0;
  std::size_t max_roots = static_cast<std::size_t>(-1);
  int max_bits = 512;
  std::int64_t max_operations = std::int64_t{1} << 22;
  bool exact = true;
};

}  // namespace isocast::reference
