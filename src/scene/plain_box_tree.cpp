#include <isocast/scene/box_tree.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isocast {
namespace {

// A binary tree: the children of an inner node are `first` and `first + 1`; a leaf has `count` boxes from
// `first` on.
struct Node {
  Box box;
  std::uint32_t first = 0, count = 0;
};

// A packet on its way: rays with the reciprocals of their directions, and how far roundings reach.
struct Packet {
  double o[3][kPacketSize], inverse[3][kPacketSize], t_min[kPacketSize], room[kPacketSize];
  int size;
};

class PlainBoxTree final : public BoxTree {
 public:
  explicit PlainBoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    std::erase_if(order_, [&](std::uint32_t i) { return boxes_[i].empty(); });
    if (order_.empty()) return;
    nodes_.reserve(2 * order_.size() / kLeaf + 2);
    nodes_.emplace_back();
    split(0, 0, static_cast<std::uint32_t>(order_.size()));
    const Box& all = nodes_[0].box;
    for (int a = 0; a < 3; ++a) size_ = std::max({size_, std::abs(all.lo[a]), std::abs(all.hi[a])});
  }

  void visit(const RayStream& rays, const double (&ends)[kStreamSize], BoxVisitor& visitor) const override {
    if (order_.empty()) return;
    for (int first = 0; first < rays.size; first += kPacketSize) visit_packet(rays, first, ends, visitor);
  }
  [[nodiscard]] std::size_t bytes() const override {
    return boxes_.size() * (sizeof(Box) + sizeof(std::uint32_t)) + nodes_.size() * sizeof(Node);
  }

 private:
  static constexpr std::uint32_t kLeaf = 2;

  // Halves the boxes from `begin` to `end` along the longest axis of their centres.
  void split(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
    Box box, centers;
    for (std::uint32_t i = begin; i < end; ++i) {
      box.add(boxes_[order_[i]]);
      centers.add(boxes_[order_[i]].center());
    }
    nodes_[node] = {box, begin, end - begin};
    if (end - begin <= kLeaf) return;
    int axis = 0;
    for (int a = 1; a < 3; ++a)
      if (centers.hi[a] - centers.lo[a] > centers.hi[axis] - centers.lo[axis]) axis = a;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                       const double x = boxes_[a].center()[axis], y = boxes_[b].center()[axis];
                       return x < y || (x == y && a < b);
                     });
    const auto child = static_cast<std::uint32_t>(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[node].first = child, nodes_[node].count = 0;
    split(child, begin, middle);
    split(child + 1, middle, end);
  }

  void visit_packet(const RayStream& rays, int first, const double* ends, BoxVisitor& visitor) const {
    Packet packet;
    packet.size = std::min(kPacketSize, rays.size - first);
    for (int l = 0; l < packet.size; ++l) {
      const int i = first + l;
      const double o[3] = {rays.ox[i], rays.oy[i], rays.oz[i]}, d[3] = {rays.dx[i], rays.dy[i], rays.dz[i]};
      double far = size_;
      for (int a = 0; a < 3; ++a) {
        packet.o[a][l] = o[a];
        packet.inverse[a][l] = 1 / d[a];
        far = std::max(far, std::abs(o[a]));
      }
      packet.room[l] = 0x1p-42 * far;
      packet.t_min[l] = rays.t_min[i];
    }
    struct Open {
      std::uint32_t node;
      double near;
    } stack[128];
    int open = 0;
    stack[open++] = {0, 0};
    while (open > 0) {
      const Node& node = nodes_[stack[--open].node];
      if (node.count > 0) {
        for (std::uint32_t k = 0; k < node.count; ++k) {
          const std::uint32_t box = order_[node.first + k];
          double near = 0;
          if (const std::uint32_t lanes = meet(packet, boxes_[box], rays, first, ends, near))
            visitor.visit(box, first, lanes);
        }
        continue;
      }
      // the nearer child last, so that it comes first
      Open children[2];
      int count = 0;
      for (std::uint32_t child = node.first; child < node.first + 2; ++child) {
        double near = 0;
        if (meet(packet, nodes_[child].box, rays, first, ends, near)) children[count++] = {child, near};
      }
      if (count == 2 && children[0].near < children[1].near) std::swap(children[0], children[1]);
      for (int c = 0; c < count; ++c) stack[open++] = children[c];
    }
  }

  // The rays that meet a box, and where the first of them does. NaN, of a ray in a face, rejects nothing.
  static std::uint32_t meet(const Packet& packet, const Box& box, const RayStream& rays, int first,
                            const double* ends, double& nearest) {
    std::uint32_t lanes = 0;
    nearest = Box::inf;
    for (int l = 0; l < packet.size; ++l) {
      double near = packet.t_min[l], far = std::min(rays.t_max[first + l], ends[first + l]);
      if (!(near <= far)) continue;
      for (int a = 0; a < 3; ++a) {
        const double k = packet.inverse[a][l], lo = (box.lo[a] - packet.room[l] - packet.o[a][l]) * k,
                     hi = (box.hi[a] + packet.room[l] - packet.o[a][l]) * k;
        const double in = k < 0 ? hi : lo, out = k < 0 ? lo : hi;
        if (in > near) near = in;
        if (out < far) far = out;
      }
      if (near > far + 0x1p-48 * std::max(std::abs(near), std::abs(far))) continue;
      lanes |= 1u << l;
      nearest = std::min(nearest, near);
    }
    return lanes;
  }

  std::vector<Box> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
  double size_ = 0;
};

}  // namespace

std::unique_ptr<const BoxTree> make_plain_box_tree(std::vector<Box> boxes) {
  return std::make_unique<PlainBoxTree>(std::move(boxes));
}

}  // namespace isocast
