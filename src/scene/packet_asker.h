// Rays to the objects whose boxes they meet.
#pragma once

#include <isocast/ray/surface.h>
#include <isocast/scene/box_tree.h>

#include <vector>

namespace isocast {

/// Where ray i enters a box, before it at most by roundings; +inf where it surely passes.
[[nodiscard]] double entry(const RayStream& rays, int i, const Box& box);

/// Rays of a stream as a stream of their own: whole packets, with the slots that they come from.
struct SomeRays {
  RayStream rays;
  int slots[kStreamSize];

  void clear() { rays.size = 0; }
  /// The packet that begins at a slot. Primary rays become others, for they are no tile of a view here.
  void add_packet(const RayStream& from, int first);
};

/// Takes rays to the objects that a tree offers. Many objects: packet by packet, as they are offered, so that
/// what lies behind a hit is not offered any more. Few: all packets together that an object may meet. A
/// packet goes to an object whole, and once.
class PacketAsker : public BoxVisitor {
 public:
  PacketAsker(const std::vector<const Surface*>& surfaces, const std::vector<Box>& boxes,
              const RayStream& rays)
      : surfaces_(surfaces), boxes_(boxes), rays_(rays) {
    some_.clear();
  }

  void ask(const BoxTree& tree);
  void visit(std::uint32_t object, int first, std::uint32_t lanes) final;

 protected:
  /// Asks an object for `some_`, and lowers the ends of its rays.
  virtual void look_at(std::uint32_t object) = 0;

  const std::vector<const Surface*>& surfaces_;
  const std::vector<Box>& boxes_;
  const RayStream& rays_;
  SomeRays some_;
  double ends_[kStreamSize];

 private:
  static constexpr std::size_t kFew = 8;
  [[nodiscard]] bool few() const { return surfaces_.size() <= kFew; }
  void ask_for_packets(std::uint32_t object);

  int first_ = -1;
  std::uint32_t packets_[kFew] = {};
};

}  // namespace isocast
