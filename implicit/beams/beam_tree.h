// The first roots of all rays of a block, by halving beams of them until each shows one crossing or none.
#pragma once

#include <isocast/implicit/beams/beam_lanes.h>
#include <isocast/implicit/beams/ray_search.h>

namespace isocast::inline ISO_ISA {

/// A quadtree of beams over a block and, in each beam, four slabs of depth, nearest first; sixty-four parts
/// of beams are looked at together, wherever they are in the tree.
///
/// F         AffineForm<R, 3>
/// parts     one that the form proves empty is dropped; one where all rays cross, in brackets of at most eps,
///           is given to its rays; where the form is straight enough depth is counted from the plane of the
///           crossing from then on, so that brackets shrink quadratically; else it is quartered, in depth
///           too, until its rays are less work each for itself
/// unclear   a ray whose parts of at most eps are still not told is left open from there on
/// order     none but for speed: a ray keeps the nearest of its crossings, and parts behind that of each of
///           their rays are dropped
/// source    Ganacim, de Figueiredo, Nehab: Beam casting implicit surfaces on the GPU with interval
///           arithmetic, SIBGRAPI 2011, for the beams; forms that follow their slant, and its, are ours
template <class F, Real R> class BeamTree {
  using T = Scalar<R>;
  static constexpr int kMostSlabs = 4;
  // The next part around the plane of a crossing, in distances of the roots from it.
  static constexpr T kAround = T(1.25);

 public:
  /// Bytes for each register of the tape.
  static constexpr std::size_t kRegisterBytes = BeamLanes<R>::kPacks * sizeof(F);

  ISO_HD BeamTree(const FormulaQuery<T>& query, const BlockRays<T>& rays, BlockRoots<T>& roots,
                  void* registers)
      : query_(query),
        rays_(rays),
        roots_(roots),
        registers_(registers),
        leaves_(rays, roots),
        rays_search_(query, rays, roots, leaves_, registers) {}

  /// The rays of a node, which is not slanted, over its window; the tape is to hold in all of `limit`. Once,
  /// as it ends early where the block is unwanted.
  ISO_HD void run(const BeamNode<T>& start, DepthRange<T> limit) {
    limit_ = limit;
    *push() = start;
    while (waiting_ > 0) {
      if (roots_.is_unwanted()) return;
      lanes_.count = part_count_ = 0;
      while (waiting_ > 0 && take()) {}
      if (lanes_.count == 0) continue;
      lanes_.template look<F>(query_, rays_, registers_);
      roots_.evaluations += lanes_.count;
      for (int i = 0; i < part_count_; ++i) settle(parts_[i]);
    }
    rays_search_.run();
  }

 private:
  // A node, or a quarter of one, in work: its lanes from `lane` on.
  struct BeamPart {
    BeamNode<T> node;
    int lane, lanes;
  };

  // A new node to fill in, in its place; null where there is no room.
  ISO_HD BeamNode<T>* push() { return waiting_ < kMostNodes ? roots_.stack + waiting_++ : nullptr; }

  // Takes the last node into work; false where there is no room for it.
  ISO_HD bool take() {
    const BeamNode<T>& node = roots_.stack[waiting_ - 1];
    const int quarters = node.whole ? 1 : 4;
    if (lanes_.count + quarters * kMostSlabs > kBeamLanes) return false;
    --waiting_;
    for (int q = 0; q < quarters; ++q) take_part(node, q);
    return true;
  }
  ISO_HD void take_part(const BeamNode<T>& node, int quarter) {
    BeamPart& work = parts_[part_count_];
    BeamNode<T>& part = work.node;
    part.size = node.whole ? node.size : node.size / 2;
    part.x = node.x + quarter % 2 * part.size, part.y = node.y + quarter / 2 * part.size;
    if (part.x >= rays_.columns || part.y >= rays_.rows) return;
    part.slanted = node.slanted, part.inside = node.inside;
    part.now = node.now, part.window = node.window;
    if (!part.slanted && !part.inside && !cut_to_box(part)) return;
    if (leaves_.hides(part.x, part.y, part.size, part.window.from)) return;
    // the plane is counted from the part's middle
    const T off = node.whole ? T(0) : T(0.5) * T(part.size);
    part.along_u = node.along_u, part.along_v = node.along_v;
    part.at =
        node.at + ((quarter % 2 ? off : -off) * part.along_u + (quarter / 2 ? off : -off) * part.along_v);
    const int slabs = slabs_of(part);
    work.lane = lanes_.count, work.lanes = slabs;
    ++part_count_;
    T edge = part.now.from;
    for (int s = 1; s <= slabs; ++s) {
      const T next = s == slabs ? part.now.to : part.now.from + part.now.length() * (T(s) / T(slabs));
      lanes_.add(part, {edge, next});
      edge = next;
    }
  }
  // Slabs twice as deep as the beam is wide, at most four.
  ISO_HD int slabs_of(const BeamNode<T>& part) const {
    if (part.slanted) return 1;
    const T deep = T(2 * part.size) * (rays_.pixel + part.now.to * rays_.pixel_spread);
    int slabs = 1;
    while (slabs < kMostSlabs && T(slabs) * deep < part.now.length()) slabs *= 2;
    return slabs;
  }
  // Cuts a part to the domain; false where nothing of it is left.
  ISO_HD bool cut_to_box(BeamNode<T>& part) const {
    const T half = T(0.5) * T(part.size - 1), middle = T(0.5) * T(kBlockSide - 1);
    const BoxRange<T> box = box_range(rays_, T(part.x) + half - middle, T(part.y) + half - middle, half);
    part.inside = part.window.from >= box.enters_to && part.window.to <= box.leaves_from;
    part.now = part.window = {max(part.window.from, box.enters_from), min(part.window.to, box.leaves_to)};
    return part.now.from <= part.now.to;
  }

  // What comes next where a part may hold roots, the nearest slab last.
  ISO_HD void settle(const BeamPart& part) {
    for (int l = part.lane + part.lanes - 1; l >= part.lane; --l) {
      const SlotBits bit = SlotBits(1) << l;
      if (!(lanes_.open & bit)) continue;
      const BeamNode<T>& node = part.node;
      if (lanes_.narrow & bit) {
        cross(node, l);
        continue;
      }
      go_on(node, l, (lanes_.straight & bit) != 0 && stays_within_limit(l));
    }
  }
  // The part that would be looked at next.
  ISO_HD bool stays_within_limit(int l) const {
    const T most = lanes_.half[l] * (abs(lanes_.next_u[l]) + abs(lanes_.next_v[l])) + T(2) * lanes_.radius[l];
    return lanes_.next_at[l] - most >= limit_.from && lanes_.next_at[l] + most <= limit_.to;
  }
  ISO_HD void cross(const BeamNode<T>& part, int l) {
    const T at = lanes_.next_at[l], radius = lanes_.radius[l],
            most = lanes_.half[l] * (abs(lanes_.next_u[l]) + abs(lanes_.next_v[l])) + radius;
    // the crossing may lie outside the window, where it is as true
    const bool inside = part.inside && at - most >= part.window.from && at + most <= part.window.to;
    leaves_.cross({part.x, part.y, part.size, at, lanes_.next_u[l], lanes_.next_v[l], radius, lanes_.slope[l],
                   static_cast<std::uint8_t>(lanes_.iso[l]), (lanes_.rises >> l & 1) != 0, inside});
  }
  ISO_HD void go_on(const BeamNode<T>& part, int l, bool straight) {
    BeamNode<T> rest;
    const int smallest = straight && !part.slanted ? kSmallestPlane : kSmallest;
    BeamNode<T>* const room = part.size > smallest ? push() : nullptr;
    BeamNode<T>& next = room ? *room : rest;
    next.x = part.x, next.y = part.y, next.size = part.size;
    next.inside = part.inside;
    next.window = {lanes_.next_from[l], lanes_.next_to[l]};
    const DepthRange<T> here = {lanes_.near[l], lanes_.far[l]};
    next.slanted = straight || (part.slanted && T(2) * here.length() < next.window.length());
    next.whole = straight && !part.slanted;
    const T around = kAround * lanes_.radius[l];
    if (straight) {
      next.at = lanes_.next_at[l], next.along_u = lanes_.next_u[l], next.along_v = lanes_.next_v[l];
      next.now = {-around, around};
    } else if (next.slanted) {
      next.at = part.at, next.along_u = part.along_u, next.along_v = part.along_v;
      next.now = here;
    } else {
      next.at = next.along_u = next.along_v = T(0);
      next.now = next.window;
    }
    if (!room) search_rays(next);
  }
  // The rays of a node, each for itself.
  ISO_HD void search_rays(const BeamNode<T>& node) {
    const T middle = T(0.5) * T(node.size - 1);
    for (int y = 0; y < node.size; ++y)
      for (int x = 0; x < node.size; ++x) {
        if (rays_search_.is_full()) rays_search_.run();
        if (node.x + x >= rays_.columns || node.y + y >= rays_.rows) continue;
        const T plane = node.at + (T(x) - middle) * node.along_u + (T(y) - middle) * node.along_v;
        rays_search_.add({static_cast<std::int16_t>(node.x + x), static_cast<std::int16_t>(node.y + y),
                          node.inside, max(node.window.from, plane + node.now.from),
                          min(node.window.to, plane + node.now.to)});
      }
  }
  // Beams of so many pixels a side are not divided; and where a plane was found, as it leaves little of each
  // ray to be searched.
  static constexpr int kSmallest = 2, kSmallestPlane = 4;

  const FormulaQuery<T>& query_;
  const BlockRays<T>& rays_;
  BlockRoots<T>& roots_;
  void* registers_;
  BlockLeaves<R> leaves_;
  BeamLanes<R> lanes_;
  RaySearch<R> rays_search_;
  BeamPart parts_[kBeamLanes];
  DepthRange<T> limit_;
  int part_count_ = 0, waiting_ = 0;
};

}  // namespace isocast::inline ISO_ISA
