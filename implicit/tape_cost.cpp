#include <isocast/implicit/tape_cost.h>

namespace isocast {

double tape_cost(const Tape& tape, bool affine) {
  double cost = 0;
  for (const Instruction& i : tape.code) {
    switch (i.op) {
      case Op::constant:
      case Op::variable:
      case Op::negate: break;
      case Op::add:
      case Op::subtract: cost += affine ? 2 : 1; break;
      case Op::multiply: cost += 4; break;
      case Op::square:
      case Op::abs:
      case Op::min:
      case Op::max: cost += affine ? 3 : 1; break;
      case Op::power: cost += affine ? 20 : 8; break;
      case Op::chebyshev: cost += (affine ? 20 : 8) * i.n; break;
      case Op::divide:
      case Op::sqrt: cost += affine ? 30 : 8; break;
      default: cost += affine ? 60 : 20;
    }
  }
  return cost;
}

}  // namespace isocast
