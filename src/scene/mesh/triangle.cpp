#include <isocast/scene/mesh/triangle.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isocast {
namespace {

// a * b = product + error, exactly (Dekker 1971), for numbers far from over- and underflow.
struct ExactProduct {
  double product, error;
  ExactProduct(double a, double b) : product(a * b) {
    const auto split = [](double x) {
      const double shifted = 134217729 * x;
      return shifted - (shifted - x);
    };
    const double a_high = split(a), a_low = a - a_high, b_high = split(b), b_low = b - b_high;
    error = a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low);
  }
};

// The sign of a.x b.y - a.y b.x: what is uncertain is computed exactly, and zero is decided as if the ray
// passed a little beside.
int side(const Projected<double>& a, const Projected<double>& b) {
  const double e = area(a, b);
  if (std::abs(e) > area_error(a, b)) return e > 0 ? 1 : -1;
  const ExactProduct p(a.x, b.y), q(a.y, b.x);
  const double difference = p.product - q.product, rest = p.error - q.error, sum = difference + rest;
  const double part = rest - p.error, lost = (p.error - (rest - part)) - (q.error + part);
  for (const double sign : {sum, lost, a.y - b.y, b.x - a.x})
    if (sign != 0) return sign > 0 ? 1 : -1;
  return 0;
}

double along(const ProjectedPacket& packet, int l, const double* corner) {
  double t = 0;
  for (int k = 0; k < 3; ++k) t += (corner[k] - packet.o[k][l]) * packet.z[k][l];
  return t;
}

}  // namespace

std::optional<TriangleHit> hit_triangle(const ProjectedPacket& packet, int l, const double* a,
                                        const double* b, const double* c) {
  double o[3], x[3], y[3];
  for (int k = 0; k < 3; ++k) o[k] = packet.o[k][l], x[k] = packet.x[k][l], y[k] = packet.y[k][l];
  const Projected<double> pa = project(o, x, y, a), pb = project(o, x, y, b), pc = project(o, x, y, c);
  const int turn = side(pa, pb);
  if (turn == 0 || side(pb, pc) != turn || side(pc, pa) != turn) return std::nullopt;
  const double wa = std::abs(area(pb, pc)), wb = std::abs(area(pc, pa)), wc = std::abs(area(pa, pb)),
               sum = wa + wb + wc;
  if (!(sum > 0)) return std::nullopt;
  const double ta = along(packet, l, a), tb = along(packet, l, b), tc = along(packet, l, c), u = wb / sum,
               v = wc / sum;
  const double t =
      std::clamp(ta + u * (tb - ta) + v * (tc - ta), std::min({ta, tb, tc}), std::max({ta, tb, tc}));
  if (!std::isfinite(t)) return std::nullopt;
  return TriangleHit{t, u, v, turn < 0};
}

ProjectedPacket project_packet(const RayStream& rays, int first, double size) {
  ProjectedPacket packet = {};
  const double scale = inverse_power_of_two(size);
  for (int l = 0; l < kPacketSize; ++l) {
    // slots behind the last ray are its copies
    const int i = std::min(first + l, rays.size - 1);
    const double o[3] = {rays.ox[i], rays.oy[i], rays.oz[i]}, d[3] = {rays.dx[i], rays.dy[i], rays.dz[i]};
    int z = 0;
    for (int a = 1; a < 3; ++a)
      if (std::abs(d[a]) > std::abs(d[z])) z = a;
    int x = (z + 1) % 3, y = (z + 2) % 3;
    if (d[z] < 0) std::swap(x, y);
    for (int a = 0; a < 3; ++a) packet.o[a][l] = o[a];
    packet.x[x][l] = packet.y[y][l] = scale;
    packet.x[z][l] = -(d[x] / d[z]) * scale;
    packet.y[z][l] = -(d[y] / d[z]) * scale;
    packet.z[z][l] = 1 / d[z];
  }
  return packet;
}

}  // namespace isocast
