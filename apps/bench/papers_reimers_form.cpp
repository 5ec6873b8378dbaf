#include <isocast/apps/bench/papers_reimers_form.h>
#include <isocast/implicit/expression/evaluate.h>
#include <isocast/implicit/expression/simplify.h>
#include <isocast/implicit/expression/tape.h>
#include <isocast/implicit/frustum/collocation.h>

#include <Eigen/LU>
#include <cmath>

namespace isocast::bench {

DepthRange depths_of(const View& view, const Box& box) {
  return *depth_range(view.lines(), 0, view.width(), 0, view.height(), box);
}

double largest_coefficient(const FormulaSource& f, int degree, const View& view, const DepthRange& depths) {
  const Tape tape = make_tape(simplify(f.expression));
  std::vector<double> registers(tape.registers);
  const Collocation& nodes = collocation(degree);
  const PixelLines lines = view.lines();
  const Eigen::Index n = degree + 1;
  // values of one line along u after the other
  Eigen::MatrixXd b(n, n * n);
  for (Eigen::Index column = 0; column < n * n; ++column)
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto node = [&](Eigen::Index at) { return nodes.points[static_cast<std::size_t>(at)]; };
      const double u = view.width() * node(i), v = view.height() * node(column % n),
                   s = depths.near + (depths.far - depths.near) * node(column / n);
      double inputs[4] = {0, 0, 0, f.time};
      for (int a = 0; a < 3; ++a)
        inputs[a] = lines.o[a] + u * lines.o_u[a] + v * lines.o_v[a] +
                    s * (lines.d[a] + u * lines.d_u[a] + v * lines.d_v[a]);
      b(i, column) = evaluate(tape.view(), inputs, registers.data());
    }
  const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> from_values(
      nodes.from_values.data(), n, n);
  // an axis becomes coefficients, then the next one comes first
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::MatrixXd turned = (from_values * b).transpose();
    b = Eigen::Map<const Eigen::MatrixXd>(turned.data(), n, n * n);
  }
  return b.cwiseAbs().maxCoeff();
}

double collocation_condition(int degree, Nodes nodes) {
  const Eigen::Index n = degree + 1;
  Eigen::MatrixXd omega(n, n);
  std::vector<double> row(static_cast<std::size_t>(n));
  for (Eigen::Index j = 0; j < n; ++j) {
    const double x = nodes == Nodes::chebyshev ? collocation(degree).points[static_cast<std::size_t>(j)]
                     : nodes == Nodes::even    ? double(j) / degree
                                               : double(2 * j + 1) / double(2 * n);
    bernstein_values(degree, x, row.data());
    for (Eigen::Index i = 0; i < n; ++i) omega(j, i) = row[static_cast<std::size_t>(i)];
  }
  const auto norm = [](const Eigen::MatrixXd& m) { return m.cwiseAbs().rowwise().sum().maxCoeff(); };
  return norm(omega) * norm(omega.inverse());
}

}  // namespace isocast::bench
