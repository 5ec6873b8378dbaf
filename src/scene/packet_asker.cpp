#include <isocast/scene/packet_asker.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace isocast {
namespace {

// The packet in which each object was asked last, of this thread: none is asked twice in one.
class Visited {
 public:
  void next_packet(std::size_t objects) {
    if (last_.size() < objects) last_.resize(objects, 0);
    ++now_;
  }
  // True the first time in a packet.
  bool enter(std::uint32_t object) { return std::exchange(last_[object], now_) != now_; }

 private:
  std::vector<std::uint64_t> last_;
  std::uint64_t now_ = 0;
};
thread_local Visited visited;

}  // namespace

double entry(const RayStream& rays, int i, const Box& box) {
  const double o[3] = {rays.ox[i], rays.oy[i], rays.oz[i]}, d[3] = {rays.dx[i], rays.dy[i], rays.dz[i]};
  double near = rays.t_min[i], far = rays.t_max[i];
  for (int a = 0; a < 3; ++a) {
    const double room = 0x1p-42 * std::max({std::abs(o[a]), std::abs(box.lo[a]), std::abs(box.hi[a])});
    const double in = ((d[a] < 0 ? box.hi[a] + room : box.lo[a] - room) - o[a]) / d[a],
                 out = ((d[a] < 0 ? box.lo[a] - room : box.hi[a] + room) - o[a]) / d[a];
    if (in > near) near = in;
    if (out < far) far = out;
  }
  return near <= far ? near : Box::inf;
}

void SomeRays::add_packet(const RayStream& from, int first) {
  if (rays.size == 0) rays.kind = from.kind == RayKind::primary ? RayKind::reflection : from.kind;
  for (int i = first; i < std::min(first + kPacketSize, from.size); ++i) {
    const int n = rays.size++;
    slots[n] = i;
    rays.ox[n] = from.ox[i], rays.oy[n] = from.oy[i], rays.oz[n] = from.oz[i];
    rays.dx[n] = from.dx[i], rays.dy[n] = from.dy[i], rays.dz[n] = from.dz[i];
    rays.t_min[n] = from.t_min[i], rays.t_max[n] = from.t_max[i];
    rays.u[n] = from.u[i], rays.v[n] = from.v[i], rays.id[n] = from.id[i];
    rays.start_sides[n] = from.start_sides[i], rays.start_object[n] = from.start_object[i];
  }
}

void PacketAsker::ask(const BoxTree& tree) {
  tree.visit(rays_, ends_, *this);
  for (std::uint32_t object = 0; few() && object < surfaces_.size(); ++object) ask_for_packets(object);
}

void PacketAsker::visit(std::uint32_t object, int first, std::uint32_t /*lanes*/) {
  if (few()) {
    packets_[object] |= 1u << (first / kPacketSize);
    return;
  }
  if (first != first_) {
    visited.next_packet(surfaces_.size());
    first_ = first;
    some_.clear();
  }
  if (!visited.enter(object)) return;
  if (some_.rays.size == 0) some_.add_packet(rays_, first);
  look_at(object);
}

// Those packets of which a ray still may find something there.
void PacketAsker::ask_for_packets(std::uint32_t object) {
  some_.clear();
  for (std::uint32_t open = packets_[object]; open != 0; open &= open - 1) {
    const int first = __builtin_ctz(open) * kPacketSize;
    bool any = false;
    for (int i = first; i < std::min(first + kPacketSize, rays_.size) && !any; ++i) {
      const double near = entry(rays_, i, boxes_[object]);
      any = near < Box::inf && near <= ends_[i];
    }
    if (any) some_.add_packet(rays_, first);
  }
  if (some_.rays.size > 0) look_at(object);
}

}  // namespace isocast
