#include <isocast/implicit/implicit_surface.h>
#include <isocast/implicit/register_memory.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isocast {
namespace {

// Three points an edge: the one on the ray, and those before and behind it.
constexpr int kEdges = kStreamSize / 3;

// Newton's method for one edge: a is the share of the step, s the depth.
struct Edge {
  double a = 0, s = 0, step = 0;
  Double3 p, along_a, along_s, mixed;  // the point, its derivatives by a and s, and by both
  bool active = true, found = false;

  void place(const PixelLines& l, const EdgeStep& e) {
    const double u = e.u + a * e.du, v = e.v + a * e.dv;
    for (int i = 0; i < 3; ++i) {
      along_s[i] = l.d[i] + u * l.d_u[i] + v * l.d_v[i];
      p[i] = l.o[i] + u * l.o_u[i] + v * l.o_v[i] + s * along_s[i];
      mixed[i] = e.du * l.d_u[i] + e.dv * l.d_v[i];
      along_a[i] = e.du * l.o_u[i] + e.dv * l.o_v[i] + s * mixed[i];
    }
  }
  // One step towards two functions' common zero, of which values and derivatives by a and s are given.
  void move(double g, double g_a, double g_s, double h, double h_a, double h_s) {
    const double determinant = g_a * h_s - g_s * h_a;
    const double da = (g * h_s - g_s * h) / determinant, ds = (g_a * h - h_a * g) / determinant;
    a -= da, s -= ds;
    const double drawn_in = 1e-3;
    // a quadratic's first step goes twice as far as its silhouette is
    active = a > -1 && a < 2.5 && s > 0 && std::isfinite(da + ds);
    found = active && std::abs(da) < drawn_in;
    active = active && !found;
  }
};

}  // namespace

// Where the front of a surface ends on the way to a pixel's neighbour: at its silhouette, f = iso and df/ds =
// 0, or else at the face of the domain that is nearest to the hit.
void ImplicitSurface::find_edges(const PixelLines& lines, std::span<const EdgeStep> steps,
                                 std::span<float> shares) const {
  constexpr int kMostSteps = 8;
  const FormulaKernels& kernels = formula_kernels(options_.isa);
  void* const registers = registers_of(tape_.registers * kernels.gradient_bytes);
  const double longest = std::ranges::max(bounds_.hi - bounds_.lo);
  GradientStream points = {};
  for (std::size_t first = 0; first < steps.size(); first += kEdges) {
    const int count = static_cast<int>(std::min<std::size_t>(kEdges, steps.size() - first));
    Edge edges[kEdges];
    for (const bool silhouette : {true, false}) {
      int face[kEdges] = {};
      for (int n = 0; n < count; ++n) {
        Edge& edge = edges[n];
        if (edge.found) continue;
        edge = {};
        edge.s = steps[first + n].depth;
        edge.place(lines, steps[first + n]);
        edge.step = 1e-5 * longest / length(edge.along_s);
        for (int k = 1; k < 6; ++k) {
          const auto distance = [&](int f) {
            return std::abs(edge.p[f / 2] - (f % 2 ? bounds_.hi : bounds_.lo)[f / 2]);
          };
          if (distance(k) < distance(face[n])) face[n] = k;
        }
      }
      for (int round = 0; round < kMostSteps; ++round) {
        points.size = 0;
        for (int n = 0; n < count; ++n) {
          if (!edges[n].active) continue;
          edges[n].place(lines, steps[first + n]);
          for (const double shift : {0.0, edges[n].step, -edges[n].step}) {
            for (int a = 0; a < 3; ++a)
              points.position[a][points.size] = edges[n].p[a] + shift * edges[n].along_s[a];
            ++points.size;
          }
        }
        if (points.size == 0) break;
        kernels.find_gradients(tape_.view(), options_.time, points, registers);
        for (int n = 0, next = 0; n < count; ++n) {
          Edge& edge = edges[n];
          if (!edge.active) continue;
          const int at_edge = std::exchange(next, next + 3);
          const auto gradient = [&](int k) {
            return Double3{points.gradient[0][k], points.gradient[1][k], points.gradient[2][k]};
          };
          const Double3 at = gradient(at_edge);
          const double g = points.value[at_edge] - options_.iso[steps[first + n].iso],
                       g_a = dot(at, edge.along_a), g_s = dot(at, edge.along_s);
          if (silhouette) {
            const Double3 bend = (0.5 / edge.step) * (gradient(at_edge + 1) - gradient(at_edge + 2));
            edge.move(g, g_a, g_s, g_s, dot(edge.along_a, bend) + dot(at, edge.mixed),
                      dot(edge.along_s, bend));
          } else {
            const int a = face[n] / 2;
            edge.move(g, g_a, g_s, edge.p[a] - (face[n] % 2 ? bounds_.hi : bounds_.lo)[a], edge.along_a[a],
                      edge.along_s[a]);
          }
        }
      }
      for (int n = 0; n < count; ++n) edges[n].found = edges[n].found && edges[n].a >= 0 && edges[n].a <= 1;
    }
    for (int n = 0; n < count; ++n)
      if (edges[n].found) shares[first + n] = static_cast<float>(edges[n].a);
  }
}

}  // namespace isocast
