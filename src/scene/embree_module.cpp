// The module `embree`: boxes as user geometry, packets of 16 rays.
#include <embree3/rtcore.h>
#include <isocast/base/module.h>
#include <isocast/scene/embree_module.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

namespace isocast {
namespace {

RTCDevice device() {
  static const RTCDevice made = rtcNewDevice(nullptr);
  if (!made) throw std::runtime_error("Embree offers no device");
  return made;
}

// Embree's numbers are float, so it gets the scene shifted and scaled into [-1, 1]. Roundings of boxes, rays
// and their tests are of that size: boxes are wider by kRoom, and rays begin where they enter the scene.
constexpr double kRoom = 0x1p-19;

// What a query carries along.
struct Query {
  RTCIntersectContext context;  // first: Embree hands back its address
  const double* ends;
  const RayStream* rays;
  BoxVisitor* visitor;
  int first;
  double begin[kPacketSize], length[kPacketSize];  // t = begin + (Embree's t) / length

  // Embree's t of an end, rounded up.
  [[nodiscard]] float end_of(int l) const {
    const double end = std::min(ends[first + l], rays->t_max[first + l]);
    const double far = (end - begin[l]) * length[l];
    return far < 1e30 ? std::nextafter(static_cast<float>(far + kRoom), INFINITY) : INFINITY;
  }
};

class EmbreeTree final : public BoxTree {
 public:
  explicit EmbreeTree(const std::vector<Box>& boxes) : boxes_(boxes), scene_(rtcNewScene(device())) {
    for (const Box& box : boxes) all_.add(box);
    if (all_.empty()) return;
    center_ = all_.center();
    double size = 0;
    for (int a = 0; a < 3; ++a) size = std::max(size, 0.5 * (all_.hi[a] - all_.lo[a]));
    scale_ = std::isnormal(1 / size) ? 1 / size : 1;
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    const RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes_.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, bound, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~EmbreeTree() override { rtcReleaseScene(scene_); }
  EmbreeTree(const EmbreeTree&) = delete;
  EmbreeTree& operator=(const EmbreeTree&) = delete;

  void visit(const RayStream& rays, const double (&ends)[kStreamSize], BoxVisitor& visitor) const override {
    if (all_.empty()) return;
    for (int first = 0; first < rays.size; first += kPacketSize) visit_packet(rays, first, ends, visitor);
  }
  // Embree's own: about a node of 100 bytes for two boxes.
  [[nodiscard]] std::size_t bytes() const override { return boxes_.size() * (sizeof(Box) + 64); }

 private:
  static void bound(const RTCBoundsFunctionArguments* arguments) {
    const auto& tree = *static_cast<const EmbreeTree*>(arguments->geometryUserPtr);
    const Box& box = tree.boxes_[arguments->primID];
    RTCBounds& to = *arguments->bounds_o;
    if (box.empty()) {
      to.lower_x = to.lower_y = to.lower_z = INFINITY;
      to.upper_x = to.upper_y = to.upper_z = -INFINITY;
      return;
    }
    const auto at = [&](double x, int a, double room) {
      return static_cast<float>((x - tree.center_[a]) * tree.scale_ + room);
    };
    to.lower_x = at(box.lo[0], 0, -kRoom), to.lower_y = at(box.lo[1], 1, -kRoom);
    to.lower_z = at(box.lo[2], 2, -kRoom);
    to.upper_x = at(box.hi[0], 0, kRoom), to.upper_y = at(box.hi[1], 1, kRoom);
    to.upper_z = at(box.hi[2], 2, kRoom);
  }

  static void intersect(const RTCIntersectFunctionNArguments* arguments) {
    const Query& query = *reinterpret_cast<const Query*>(arguments->context);
    RTCRayN* const rays = RTCRayHitN_RayN(arguments->rayhit, arguments->N);
    std::uint32_t lanes = 0;
    for (unsigned l = 0; l < arguments->N; ++l)
      if (arguments->valid[l]) lanes |= 1u << RTCRayN_id(rays, arguments->N, l);
    if (!lanes) return;
    query.visitor->visit(arguments->primID, query.first, lanes);
    for (unsigned l = 0; l < arguments->N; ++l)
      if (arguments->valid[l]) {
        float& far = RTCRayN_tfar(rays, arguments->N, l);
        far = std::min(far, query.end_of(static_cast<int>(RTCRayN_id(rays, arguments->N, l))));
      }
  }

  void visit_packet(const RayStream& rays, int first, const double* ends, BoxVisitor& visitor) const {
    Query query;
    rtcInitIntersectContext(&query.context);
    query.ends = ends, query.rays = &rays, query.visitor = &visitor, query.first = first;
    alignas(64) int valid[kPacketSize];
    RTCRayHit16 packet;
    bool any = false;
    for (int l = 0; l < kPacketSize; ++l) {
      valid[l] = first + l < rays.size && enter(rays, first + l, l, query, packet.ray) ? -1 : 0;
      if (!valid[l]) close(l, packet.ray);
      packet.hit.geomID[l] = packet.hit.instID[0][l] = RTC_INVALID_GEOMETRY_ID;
      any = any || valid[l];
    }
    if (any) rtcIntersect16(valid, scene_, &query.context, &packet);
  }

  // A ray in Embree's space from where it enters the scene; false where it does not.
  bool enter(const RayStream& rays, int i, int l, Query& query, RTCRay16& ray) const {
    const double o[3] = {rays.ox[i], rays.oy[i], rays.oz[i]}, d[3] = {rays.dx[i], rays.dy[i], rays.dz[i]};
    const double largest = std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
    if (!(largest > 0 && largest < INFINITY)) return false;
    double near = rays.t_min[i], far = std::min(rays.t_max[i], query.ends[i]), length2 = 0;
    for (int a = 0; a < 3; ++a) {
      const double room = 4 * kRoom / scale_ + 0x1p-42 * std::abs(o[a]), k = 1 / d[a],
                   lo = (all_.lo[a] - room - o[a]) * k, hi = (all_.hi[a] + room - o[a]) * k;
      const double in = k < 0 ? hi : lo, out = k < 0 ? lo : hi;
      if (in > near) near = in;
      if (out < far) far = out;
      length2 += (d[a] / largest) * (d[a] / largest);
    }
    if (!(near <= far)) return false;
    const double length = std::sqrt(length2);
    query.begin[l] = near;
    query.length[l] = largest * scale_ * length;
    float* const to_o[3] = {ray.org_x, ray.org_y, ray.org_z};
    float* const to_d[3] = {ray.dir_x, ray.dir_y, ray.dir_z};
    for (int a = 0; a < 3; ++a) {
      to_o[a][l] = static_cast<float>((o[a] - center_[a] + near * d[a]) * scale_);
      to_d[a][l] = static_cast<float>(d[a] / largest / length);
    }
    ray.tnear[l] = 0;
    ray.tfar[l] = query.end_of(l);
    ray.time[l] = 0;
    ray.mask[l] = ~0u;
    ray.id[l] = static_cast<unsigned>(l);
    ray.flags[l] = 0;
    return true;
  }

  // A lane without a ray, which Embree computes with all the same.
  static void close(int l, RTCRay16& ray) {
    ray.org_x[l] = ray.org_y[l] = ray.org_z[l] = ray.dir_x[l] = ray.dir_y[l] = 0;
    ray.dir_z[l] = ray.tnear[l] = 1;
    ray.tfar[l] = ray.time[l] = 0;
    ray.mask[l] = ray.flags[l] = ray.id[l] = 0;
  }

  std::vector<Box> boxes_;
  RTCScene scene_;
  Box all_;
  Double3 center_ = {0, 0, 0};
  double scale_ = 1;
};

const BoxTree* make(const std::vector<Box>& boxes) { return new EmbreeTree(boxes); }

const EmbreeModule table = {make};

}  // namespace
}  // namespace isocast

ISO_EXPORT_MODULE(isocast::table)
