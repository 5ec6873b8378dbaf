#include <isocast/apps/reference/formula_balls.h>

#include <algorithm>

namespace isocast::reference {

Enclosure FormulaBalls::over(const Ball& s, slong bits, bool sloped) {
  values_.clear();
  for (const Node& node : formula_.nodes) {
    if (node.op == Op::constant) {
      values_.push_back(enclosure_of(ball_of(formula_.constants[node.a], bits)));
    } else if (node.op == Op::variable) {
      const RayAxis& axis = axes_[node.a];
      Ball x;
      arb_mul(x.set(), axis.span.get(), s.get(), bits);
      arb_add(x.set(), x.get(), axis.start.get(), bits);
      values_.push_back(enclosure_of(x, axis.span));
    } else {
      values_.push_back(
          apply(node.op, node.n, values_[node.a], values_[node.b], values_[node.c], bits, sloped));
    }
  }
  operations_ += static_cast<std::int64_t>(formula_.nodes.size());
  return values_.back();
}

Ball FormulaBalls::at(const Ball& s, slong max_bits) {
  for (bits_ = std::min<slong>(64, max_bits);; bits_ = std::min(2 * bits_, max_bits)) {
    Enclosure f = over(s, bits_, false);
    if (f.empty) arb_indeterminate(f.value.set());
    if (f.empty || f.value.sign() != 0 || f.value.is_zero() || bits_ >= max_bits) return f.value;
  }
}

}  // namespace isocast::reference
