#include <isocast/scene/mesh/mesh_surface.h>
#include <isocast/scene/mesh/triangle.h>
#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>

namespace isocast {
namespace {

constexpr std::size_t kCluster = 8;

// Every third bit of a number of 21 bits.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

}  // namespace

MeshSurface::MeshSurface(Mesh mesh, Isa isa, std::uint16_t object)
    : mesh_(std::move(mesh)), kernels_(&mesh_kernels(isa)), object_(object) {
  for (const auto& triangle : mesh_.triangles)
    for (const std::uint32_t corner : triangle) bounds_.add(mesh_.positions[corner]);
  for (int a = 0; a < 3; ++a) size_ = std::max(size_, bounds_.hi[a] - bounds_.lo[a]);
  sort_triangles();
  std::vector<Box> boxes((mesh_.triangles.size() + kCluster - 1) / kCluster);
  for (std::size_t i = 0; i < mesh_.triangles.size(); ++i)
    for (const std::uint32_t corner : mesh_.triangles[i]) boxes[i / kCluster].add(mesh_.positions[corner]);
  tree_ = make_box_tree(std::move(boxes));
}

// Along a Morton curve through the middles of their boxes.
void MeshSurface::sort_triangles() {
  struct Placed {
    std::uint64_t code;
    std::array<std::uint32_t, 3> triangle;
    bool operator<(const Placed& other) const {
      return code != other.code ? code < other.code : triangle < other.triangle;
    }
  };
  std::vector<Placed> placed;
  placed.reserve(mesh_.triangles.size());
  const double scale = size_ > 0 ? 0x1fffff / size_ : 0;
  for (const auto& triangle : mesh_.triangles) {
    Box box;
    for (const std::uint32_t corner : triangle) box.add(mesh_.positions[corner]);
    std::uint64_t code = 0;
    for (int a = 0; a < 3; ++a) {
      const double at = std::clamp((box.center()[a] - bounds_.lo[a]) * scale, 0.0, double{0x1fffff});
      code |= spread(static_cast<std::uint64_t>(at)) << a;
    }
    placed.push_back({code, triangle});
  }
  oneapi::tbb::parallel_sort(placed.begin(), placed.end());
  for (std::size_t i = 0; i < placed.size(); ++i) mesh_.triangles[i] = placed[i].triangle;
}

std::size_t MeshSurface::bytes() const {
  return mesh_.positions.size() * sizeof(Double3) + mesh_.normals.size() * sizeof(mesh_.normals[0]) +
         mesh_.triangles.size() * sizeof(mesh_.triangles[0]);
}

// The nearest triangle behind the places that are given, of every ray of a stream.
class MeshSurface::Search final : public BoxVisitor {
 public:
  // The order of crossings: at the same t first those that enter, then by number.
  struct Place {
    double t;
    bool leaves;
    std::uint32_t triangle;
    bool operator<(const Place& other) const {
      if (t != other.t) return t < other.t;
      return leaves != other.leaves ? other.leaves : triangle < other.triangle;
    }
  };

  Search(const MeshSurface& surface, const RayStream& rays) : surface_(surface), rays_(rays) {
    double reach = 0;
    for (int a = 0; a < 3; ++a)
      reach = std::max({reach, std::abs(surface.bounds_.lo[a]), std::abs(surface.bounds_.hi[a])});
    for (int i = 0; i < rays.size; ++i) {
      const double o = std::max({std::abs(rays.ox[i]), std::abs(rays.oy[i]), std::abs(rays.oz[i]), reach}),
                   d = std::max({std::abs(rays.dx[i]), std::abs(rays.dy[i]), std::abs(rays.dz[i])});
      slack_[i] = 0x1p-44 * o / d;
      ends_[i] = Box::inf;
      best_[i] = {Box::inf, false, 0};
      after_[i] = {-Box::inf, false, 0};
    }
  }

  // Looks only at what comes behind.
  void continue_from(int i, const Place& place) { after_[i] = place; }
  void leave_out(int i) { ends_[i] = best_[i].t = -Box::inf; }
  void stop_at_any() { any_ = true; }

  void run() { surface_.tree_->visit(rays_, ends_, *this); }

  [[nodiscard]] bool found(int i) const { return found_[i]; }
  [[nodiscard]] double t(int i) const { return ends_[i]; }
  void write(int i, HitStream& hits) const {
    hits.t[i] = ends_[i];
    hits.t_lo[i] = ends_[i] - slack_[i], hits.t_hi[i] = ends_[i] + slack_[i];
    hits.s[i] = u_[i], hits.s_hi[i] = v_[i];
    hits.cell[0][i] = static_cast<std::int32_t>(best_[i].triangle);
    hits.cell[1][i] = hits.cell[2][i] = 0;
    hits.sides[i] = best_[i].leaves ? 1 : 0;
    hits.iso[i] = 0;
    hits.object[i] = surface_.object_;
    hits.certificate[i] = Certificate::no_proof;
  }
  // Triangles that rays were taken to.
  [[nodiscard]] std::uint32_t cost(int i) const { return cost_[i]; }
  [[nodiscard]] std::int64_t solves() const { return solves_; }

  void visit(std::uint32_t cluster, int first, std::uint32_t lanes) override {
    if (first != first_) packet_ = project_packet(rays_, first_ = first, surface_.size_);
    const std::size_t begin = std::size_t{cluster} * kCluster,
                      count = std::min(kCluster, surface_.mesh_.triangles.size() - begin);
    std::uint32_t may_hit[kCluster];
    surface_.kernels_->may_hit(packet_, surface_.mesh_.positions[0].data(),
                               surface_.mesh_.triangles[begin].data(), static_cast<int>(count), may_hit);
    for (std::size_t k = 0; k < count; ++k)
      for (std::uint32_t open = may_hit[k] & lanes; open != 0; open &= open - 1)
        look_at(static_cast<std::uint32_t>(begin + k), first, __builtin_ctz(open));
  }

 private:
  void look_at(std::uint32_t triangle, int first, int lane) {
    const int i = first + lane;
    const auto& corners = surface_.mesh_.triangles[triangle];
    const auto at = [&](int c) { return surface_.mesh_.positions[corners[c]].data(); };
    ++cost_[i];
    ++solves_;
    const std::optional<TriangleHit> hit = hit_triangle(packet_, lane, at(0), at(1), at(2));
    if (!hit || !(hit->t >= rays_.t_min[i] && hit->t <= rays_.t_max[i])) return;
    const Place place = {hit->t, !hit->enters, triangle};
    if (!(after_[i] < place) || !(place < best_[i]) || is_start(i, *hit)) return;
    ends_[i] = any_ ? -Box::inf : hit->t;
    best_[i] = any_ ? Place{-Box::inf, false, 0} : place;
    found_[i] = true;
    u_[i] = hit->u, v_[i] = hit->v;
  }
  // The surface that the ray starts on, seen again by roundings: it would lead to the side where it is
  // already.
  [[nodiscard]] bool is_start(int i, const TriangleHit& hit) const {
    return rays_.start_object[i] == surface_.object_ && hit.t <= 16 * slack_[i] &&
           hit.enters != ((rays_.start_sides[i] & 1) == 0);
  }

  const MeshSurface& surface_;
  const RayStream& rays_;
  ProjectedPacket packet_;
  int first_ = -1;
  bool any_ = false;
  double slack_[kStreamSize], ends_[kStreamSize], u_[kStreamSize], v_[kStreamSize];
  Place best_[kStreamSize], after_[kStreamSize];
  std::uint32_t cost_[kStreamSize] = {};
  bool found_[kStreamSize] = {};
  std::int64_t solves_ = 0;
};

void MeshSurface::first_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  const DefaultFloatEnvironment environment;
  Search search(*this, rays);
  search.run();
  for (int i = 0; i < rays.size; ++i) {
    hits.cost[i] += search.cost(i);
    if (search.found(i) && search.t(i) < hits.t[i]) search.write(i, hits);
  }
  counts.solves += search.solves();
}

void MeshSurface::next_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const {
  const DefaultFloatEnvironment environment;
  Search search(*this, rays);
  for (int i = 0; i < rays.size; ++i) {
    const bool mine = hits.object[i] == object_ && is_hit(hits, i);
    if (mine)
      search.continue_from(i, {hits.t[i], hits.sides[i] != 0, static_cast<std::uint32_t>(hits.cell[0][i])});
    else search.leave_out(i);
  }
  search.run();
  for (int i = 0; i < rays.size; ++i) {
    if (hits.object[i] != object_ || !is_hit(hits, i)) continue;
    hits.cost[i] += search.cost(i);
    if (search.found(i)) search.write(i, hits);
    else hits.t[i] = hits.t_lo[i] = hits.t_hi[i] = Box::inf;
  }
  counts.solves += search.solves();
}

void MeshSurface::any_hit(const RayStream& rays, bool (&hit)[kStreamSize], TraceCounts& counts) const {
  const DefaultFloatEnvironment environment;
  Search search(*this, rays);
  search.stop_at_any();
  for (int i = 0; i < rays.size; ++i)
    if (hit[i]) search.leave_out(i);
  search.run();
  for (int i = 0; i < rays.size; ++i) hit[i] = hit[i] || search.found(i);
  counts.solves += search.solves();
}

void MeshSurface::dress(const RayStream& rays, const HitStream& hits, const DressWishes& wishes,
                        DressedHits& dressed) const {
  for (int i = 0; i < rays.size; ++i) {
    if (hits.object[i] != object_ || !is_hit(hits, i)) continue;
    const Double3 d = {rays.dx[i], rays.dy[i], rays.dz[i]};
    if (wishes.position)
      for (int a = 0; a < 3; ++a)
        dressed.position[a][i] = (a == 0 ? rays.ox : a == 1 ? rays.oy : rays.oz)[i] + hits.t[i] * d[a];
    if (wishes.value) dressed.value[i] = 0;
    if (!wishes.normal) continue;
    const auto& corners = mesh_.triangles[static_cast<std::uint32_t>(hits.cell[0][i])];
    const Double3 &a = mesh_.positions[corners[0]],
                  flat = cross(mesh_.positions[corners[1]] - a, mesh_.positions[corners[2]] - a);
    Double3 normal = {0, 0, 0};
    if (!mesh_.normals.empty()) {
      const double weights[3] = {1 - hits.s[i] - hits.s_hi[i], hits.s[i], hits.s_hi[i]};
      for (int c = 0; c < 3; ++c)
        for (int axis = 0; axis < 3; ++axis) normal[axis] += weights[c] * mesh_.normals[corners[c]][axis];
    }
    normal = normalized(normal);
    if (!(length(normal) > 0.5)) normal = normalized(flat);
    // towards the side that the ray comes from, also where the vertices' normals do not know it
    const double turn = dot(normal, d) > 0 ? -1 : 1;
    for (int axis = 0; axis < 3; ++axis) dressed.normal[axis][i] = turn * normal[axis];
  }
}

}  // namespace isocast
