// The objects of a scene of several, found by rays.
#pragma once

#include <isocast/scene/box_tree.h>
#include <isocast/scene/scene.h>

#include <memory>
#include <span>
#include <vector>

namespace isocast {

/// First hits among many objects: a tree over their boxes offers candidates, packet by packet, and the
/// surfaces themselves say what is hit.
///
/// order  what is found depends on neither the tree nor the order in which it offers: a packet goes to a
///        candidate whole, the nearest hit wins, of equally near ones the object with the lowest number, and
///        doubts count where the candidate's box begins before the hit
/// Calls are const and may come from any thread.
class ObjectHierarchy {
 public:
  /// scene: its surfaces stay as they are while this lives.
  explicit ObjectHierarchy(const Scene& scene);

  /// For every ray the first hit that is nearer than the one `hits` holds. skip: by object, those that are
  /// not asked; empty: none.
  void first_hit(const RayStream& rays, std::span<const std::uint8_t> skip, HitStream& hits,
                 TraceCounts& counts) const;

  /// True where anything is hit.
  void any_hit(const RayStream& rays, bool (&hit)[kStreamSize], TraceCounts& counts) const;

  /// The numbers of all objects whose boxes the rays may meet, rising.
  void find_candidates(const RayStream& rays, std::vector<std::uint16_t>& objects) const;

  /// The numbers of all objects that are hit, rising.
  static void find_hit_objects(int size, const HitStream& hits, std::vector<std::uint16_t>& objects);

  [[nodiscard]] std::size_t bytes() const { return tree_->bytes(); }

 private:
  std::vector<const Surface*> surfaces_;
  std::vector<Box> boxes_;
  std::unique_ptr<const BoxTree> tree_;
};

}  // namespace isocast
