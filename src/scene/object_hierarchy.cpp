#include <isocast/scene/object_hierarchy.h>

#include <algorithm>
#include <utility>

namespace isocast {
namespace {

// Which candidates a packet was taken to, so that none comes twice. One per thread, for any hierarchy.
class Visited {
 public:
  explicit Visited(std::size_t objects) {
    if (last_.size() < objects) last_.resize(objects, 0);
  }
  void next_packet() { ++now_; }
  // True the first time in a packet.
  bool enter(std::uint32_t object) { return std::exchange(last_[object], now_) != now_; }

 private:
  static thread_local std::vector<std::uint64_t> last_;
  static thread_local std::uint64_t now_;
};
thread_local std::vector<std::uint64_t> Visited::last_;
thread_local std::uint64_t Visited::now_ = 0;

// The packet of a stream that begins at a slot, as a stream of its own.
void copy_packet(const RayStream& rays, int first, RayStream& packet) {
  const int size = std::min(kPacketSize, rays.size - first);
  const auto copy = [&](const auto& from, auto& to) { std::copy_n(from + first, size, to); };
  copy(rays.ox, packet.ox), copy(rays.oy, packet.oy), copy(rays.oz, packet.oz);
  copy(rays.dx, packet.dx), copy(rays.dy, packet.dy), copy(rays.dz, packet.dz);
  copy(rays.t_min, packet.t_min), copy(rays.t_max, packet.t_max);
  copy(rays.u, packet.u), copy(rays.v, packet.v), copy(rays.id, packet.id);
  copy(rays.start_sides, packet.start_sides), copy(rays.start_object, packet.start_object);
  packet.size = size;
  packet.kind = rays.kind == RayKind::primary ? RayKind::reflection : rays.kind;  // no tile of a view
}

void move_slot(const HitStream& from, int i, HitStream& to, int k) {
  to.t[k] = from.t[i], to.t_lo[k] = from.t_lo[i], to.t_hi[k] = from.t_hi[i];
  to.s[k] = from.s[i], to.s_hi[k] = from.s_hi[i];
  for (int a = 0; a < 3; ++a) to.cell[a][k] = from.cell[a][i];
  to.sides[k] = from.sides[i], to.object[k] = from.object[i], to.iso[k] = from.iso[i];
  to.certificate[k] = from.certificate[i];
}

// Where a ray enters a box; in front of it at most by roundings.
double entry(const RayStream& rays, int i, const Box& box) {
  const double o[3] = {rays.ox[i], rays.oy[i], rays.oz[i]}, d[3] = {rays.dx[i], rays.dy[i], rays.dz[i]};
  double near = rays.t_min[i];
  for (int a = 0; a < 3; ++a) {
    const double in = ((d[a] < 0 ? box.hi[a] : box.lo[a]) - o[a]) / d[a];
    if (in > near) near = in;
  }
  return near;
}

// What walks the tree: candidates of one packet after the other.
class PacketVisitor : public BoxVisitor {
 public:
  PacketVisitor(const RayStream& rays, std::size_t objects) : rays_(rays), visited_(objects) {}

  void visit(std::uint32_t object, int first, std::uint32_t /*lanes*/) final {
    if (first != first_) {
      visited_.next_packet();
      first_ = first;
      fresh_ = false;
    }
    if (!visited_.enter(object)) return;
    if (!fresh_) copy_packet(rays_, first, packet_);
    fresh_ = true;
    look_at(object, first);
  }

 protected:
  virtual void look_at(std::uint32_t object, int first) = 0;

  const RayStream& rays_;
  RayStream packet_;

 private:
  Visited visited_;
  int first_ = -1;
  bool fresh_ = false;
};

class FirstHits final : public PacketVisitor {
 public:
  FirstHits(const std::vector<const Surface*>& surfaces, const std::vector<Box>& boxes,
            std::span<const std::uint8_t> skip, const RayStream& rays, HitStream& hits, TraceCounts& counts)
      : PacketVisitor(rays, surfaces.size()),
        surfaces_(surfaces),
        boxes_(boxes),
        skip_(skip),
        hits_(hits),
        counts_(counts) {
    for (int i = 0; i < rays.size; ++i) ends_[i] = hits.t[i], doubt_[i] = Box::inf;
  }
  [[nodiscard]] const double (&ends() const)[kStreamSize] { return ends_; }

  // Doubts before the hit.
  void tell_doubts() {
    for (int i = 0; i < rays_.size; ++i)
      if (doubt_[i] <= hits_.t[i] && doubt_[i] < Box::inf) hits_.certificate[i] = Certificate::undecided;
  }

 private:
  void look_at(std::uint32_t object, int first) override {
    if (!skip_.empty() && skip_[object]) return;
    const Surface& surface = *surfaces_[object];
    const Certificate nothing = surface.proves() ? Certificate::proved_miss : Certificate::no_proof;
    for (int l = 0; l < packet_.size; ++l) {
      forget(found_, l);
      found_.cost[l] = 0;
      found_.certificate[l] = nothing;
    }
    surface.first_hit(packet_, found_, counts_);
    for (int l = 0; l < packet_.size; ++l) {
      const int i = first + l;
      hits_.cost[i] += found_.cost[l];
      if (found_.certificate[l] == Certificate::undecided)
        doubt_[i] = std::min(doubt_[i], entry(rays_, i, boxes_[object]));
      const bool nearer = found_.t[l] < hits_.t[i] || (found_.t[l] == hits_.t[i] && is_hit(found_, l) &&
                                                       found_.object[l] < hits_.object[i]);
      if (!nearer) continue;
      move_slot(found_, l, hits_, i);
      ends_[i] = hits_.t[i];
    }
  }

  const std::vector<const Surface*>& surfaces_;
  const std::vector<Box>& boxes_;
  std::span<const std::uint8_t> skip_;
  HitStream& hits_;
  TraceCounts& counts_;
  HitStream found_;
  double ends_[kStreamSize], doubt_[kStreamSize];
};

class AnyHits final : public PacketVisitor {
 public:
  AnyHits(const std::vector<const Surface*>& surfaces, const RayStream& rays, bool (&hit)[kStreamSize],
          TraceCounts& counts)
      : PacketVisitor(rays, surfaces.size()), surfaces_(surfaces), hit_(hit), counts_(counts) {
    for (int i = 0; i < rays.size; ++i) ends_[i] = hit[i] ? -Box::inf : Box::inf;
  }
  [[nodiscard]] const double (&ends() const)[kStreamSize] { return ends_; }

 private:
  void look_at(std::uint32_t object, int first) override {
    bool found[kStreamSize] = {};
    surfaces_[object]->any_hit(packet_, found, counts_);
    for (int l = 0; l < packet_.size; ++l)
      if (found[l]) hit_[first + l] = true, ends_[first + l] = -Box::inf;
  }

  const std::vector<const Surface*>& surfaces_;
  bool (&hit_)[kStreamSize];
  TraceCounts& counts_;
  double ends_[kStreamSize];
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
  FirstHits visitor(surfaces_, boxes_, skip, rays, hits, counts);
  tree_->visit(rays, visitor.ends(), visitor);
  visitor.tell_doubts();
}

void ObjectHierarchy::any_hit(const RayStream& rays, bool (&hit)[kStreamSize], TraceCounts& counts) const {
  AnyHits visitor(surfaces_, rays, hit, counts);
  tree_->visit(rays, visitor.ends(), visitor);
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
