#include <isocast/implicit/gradient_scale.h>
#include <isocast/implicit/register_memory.h>
#include <isocast/implicit/solve/inclusion.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace isocast {

double median_gradient(const Tape& tape, const Box& box, double time) {
  using F = Gradient<double>;
  constexpr int kPoints = 1024;
  constexpr double kRatio = 1.2207440846057596;  // x^4 = x + 1
  auto* const registers = static_cast<F*>(registers_of(tape.registers * sizeof(F)));
  std::vector<double> lengths;
  for (int n = 1; n <= kPoints; ++n) {
    F inputs[4] = {F(0.0), F(0.0), F(0.0), F(time)};
    double step = 1;
    for (int a = 0; a < 3; ++a) {
      step /= kRatio;
      const double place = n * step - std::floor(n * step);
      inputs[a].value = box.lo[a] + place * (box.hi[a] - box.lo[a]);
    }
    inputs[0].dx = inputs[1].dy = inputs[2].dz = 1;
    const F f = evaluate(tape.view(), inputs, registers);
    const double size = length({f.dx, f.dy, f.dz});
    if (std::isfinite(size) && size > 0) lengths.push_back(size);
  }
  if (lengths.empty()) return 1;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

}  // namespace isocast
