#include <isocast/scene/object_hierarchy.h>
#include <isocast/scene/packet_asker.h>

#include <algorithm>

namespace isocast {
namespace {

class FirstHits final : public PacketAsker {
 public:
  FirstHits(const std::vector<const Surface*>& surfaces, const std::vector<Box>& boxes,
            std::span<const std::uint8_t> skip, const RayStream& rays, HitStream& hits, TraceCounts& counts)
      : PacketAsker(surfaces, boxes, rays), skip_(skip), hits_(hits), counts_(counts) {
    for (int i = 0; i < rays.size; ++i) ends_[i] = hits.t[i], doubt_[i] = unproved_[i] = Box::inf;
  }

  // Doubts before the hit, and objects there that prove nothing.
  void tell_doubts() {
    for (int i = 0; i < rays_.size; ++i) {
      Certificate& certificate = hits_.certificate[i];
      if (doubt_[i] <= hits_.t[i] && doubt_[i] < Box::inf) certificate = Certificate::undecided;
      if (certificate == Certificate::proved_hit && unproved_[i] < hits_.t[i])
        certificate = Certificate::no_proof;
    }
  }

 private:
  void look_at(std::uint32_t object) override {
    const Surface& surface = *surfaces_[object];
    const RayStream& rays = some_.rays;
    const Box& box = boxes_[object];
    if (!surface.proves())
      for (int n = 0; n < rays.size; ++n)
        unproved_[some_.slots[n]] = std::min(unproved_[some_.slots[n]], entry(rays, n, box));
    if (!skip_.empty() && skip_[object]) return;
    const Certificate nothing = surface.proves() ? Certificate::proved_miss : Certificate::no_proof;
    for (int n = 0; n < rays.size; ++n) {
      forget(found_, n);
      found_.cost[n] = 0;
      found_.certificate[n] = nothing;
    }
    surface.first_hit(rays, found_, counts_);
    for (int n = 0; n < rays.size; ++n) {
      const int i = some_.slots[n];
      hits_.cost[i] += found_.cost[n];
      if (found_.certificate[n] == Certificate::undecided)
        doubt_[i] = std::min(doubt_[i], entry(rays, n, box));
      const bool nearer = found_.t[n] < hits_.t[i] || (found_.t[n] == hits_.t[i] && is_hit(found_, n) &&
                                                       found_.object[n] < hits_.object[i]);
      if (!nearer) continue;
      copy_slot(found_, n, hits_, i);
      ends_[i] = hits_.t[i];
    }
  }

  std::span<const std::uint8_t> skip_;
  HitStream& hits_;
  TraceCounts& counts_;
  HitStream found_;
  double doubt_[kStreamSize], unproved_[kStreamSize];
};

class AnyHits final : public PacketAsker {
 public:
  AnyHits(const std::vector<const Surface*>& surfaces, const std::vector<Box>& boxes, const RayStream& rays,
          bool (&hit)[kStreamSize], TraceCounts& counts)
      : PacketAsker(surfaces, boxes, rays), hit_(hit), counts_(counts) {
    for (int i = 0; i < rays.size; ++i) ends_[i] = hit[i] ? -Box::inf : Box::inf;
  }

 private:
  void look_at(std::uint32_t object) override {
    bool found[kStreamSize] = {};
    surfaces_[object]->any_hit(some_.rays, found, counts_);
    for (int n = 0; n < some_.rays.size; ++n)
      if (found[n]) hit_[some_.slots[n]] = true, ends_[some_.slots[n]] = -Box::inf;
  }

  bool (&hit_)[kStreamSize];
  TraceCounts& counts_;
};

class Candidates final : public BoxVisitor {
 public:
  explicit Candidates(std::vector<std::uint16_t>& objects) : objects_(objects) {}
  void visit(std::uint32_t object, int /*first*/, std::uint32_t /*lanes*/) override {
    objects_.push_back(static_cast<std::uint16_t>(object));
  }

 private:
  std::vector<std::uint16_t>& objects_;
};

void sort_once(std::vector<std::uint16_t>& numbers) {
  std::ranges::sort(numbers);
  numbers.erase(std::ranges::unique(numbers).begin(), numbers.end());
}

}  // namespace

ObjectHierarchy::ObjectHierarchy(const Scene& scene) {
  for (const SceneObject& object : scene.objects) {
    surfaces_.push_back(object.surface.get());
    boxes_.push_back(object.surface->bounds());
  }
  tree_ = make_box_tree(boxes_);
}

void ObjectHierarchy::first_hit(const RayStream& rays, std::span<const std::uint8_t> skip, HitStream& hits,
                                TraceCounts& counts) const {
  FirstHits asker(surfaces_, boxes_, skip, rays, hits, counts);
  asker.ask(*tree_);
  asker.tell_doubts();
}

void ObjectHierarchy::any_hit(const RayStream& rays, bool (&hit)[kStreamSize], TraceCounts& counts) const {
  AnyHits(surfaces_, boxes_, rays, hit, counts).ask(*tree_);
}

void ObjectHierarchy::find_candidates(const RayStream& rays, std::vector<std::uint16_t>& objects) const {
  objects.clear();
  double ends[kStreamSize];
  std::ranges::fill(ends, Box::inf);
  Candidates visitor(objects);
  tree_->visit(rays, ends, visitor);
  sort_once(objects);
}

void ObjectHierarchy::find_hit_objects(int size, const HitStream& hits, std::vector<std::uint16_t>& objects) {
  objects.clear();
  for (int i = 0; i < size; ++i)
    if (is_hit(hits, i)) objects.push_back(hits.object[i]);
  sort_once(objects);
}

}  // namespace isocast
