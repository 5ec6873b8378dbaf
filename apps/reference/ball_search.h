// Roots of a function that is known by balls, by bisection.
#pragma once

#include <isocast/apps/reference/bracket.h>
#include <isocast/apps/reference/formula_balls.h>
#include <isocast/apps/reference/formula_roots.h>

namespace isocast::reference {

/// In s of [0, 1].
struct SearchRoot {
  Bracket s;
  bool crossing;
};
struct SearchDoubt {
  Bracket s;
  Doubt doubt;
};
struct SearchResult {
  std::vector<SearchRoot> roots;
  std::vector<SearchDoubt> doubts;
  slong bits = 0;
};

/// The roots of f in [0, 1] where it is continuous: parts that f, or its mean value form, proves empty are
/// left out, parts where it is monotone are decided by the signs at their ends, the others are divided down
/// to 2^-60.
///
/// width  of brackets, in s; the other options as in formula_roots.h
/// doubts touches without an exact zero, jumps, poles and edges of what is defined, always
/// source Mitchell: Robust ray intersection with interval arithmetic, Graphics Interface 1990; with mean
/// value
///        forms and adaptive precision
[[nodiscard]] SearchResult search(FormulaBalls& f, double width, const ReferenceOptions& options);

}  // namespace isocast::reference
