// Which boxes rays meet.
#pragma once

#include <isocast/math/box.h>
#include <isocast/ray/stream.h>

#include <memory>
#include <vector>

namespace isocast {

/// What looks into boxes.
class BoxVisitor {
 public:
  virtual ~BoxVisitor() = default;

  /// Rays of the packet that begins at slot `first`, one bit each, may meet the box. It may lower their ends:
  /// boxes behind are not looked for then.
  virtual void visit(std::uint32_t box, int first, std::uint32_t lanes) = 0;
};

/// Boxes, sorted so that rays find those that they meet. All calls are const and may come from any thread.
class BoxTree {
 public:
  virtual ~BoxTree() = default;

  /// Offers every box to every packet of 16 rays of which one meets it between t_min and the smaller of t_max
  /// and ends[i], packet by packet, roughly from near to far; others too, and some more than once.
  virtual void visit(const RayStream& rays, const double (&ends)[kStreamSize], BoxVisitor& visitor) const = 0;

  [[nodiscard]] virtual std::size_t bytes() const = 0;
};

/// A tree of our own, over boxes in double precision, each widened for the roundings of rays and hits.
[[nodiscard]] std::unique_ptr<const BoxTree> make_plain_box_tree(std::vector<Box> boxes);

/// Where the module `embree` is there, one of Embree's; else our own. Both offer what is met, so what is
/// found does not depend on which it is. Environment ISOCAST_EMBREE=0: our own.
[[nodiscard]] std::unique_ptr<const BoxTree> make_box_tree(std::vector<Box> boxes);

/// Whether make_box_tree makes Embree's.
[[nodiscard]] bool has_embree();

}  // namespace isocast
