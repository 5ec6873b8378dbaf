#include <isocast/implicit/open_rays.h>
#include <isocast/ray/copy_ray.h>
#include <isocast/render/camera.h>

#include <algorithm>
#include <memory>

namespace isocast {

OpenRays& OpenRays::of_thread(const Surface& surface) {
  thread_local const auto rays = std::make_unique<OpenRays>();
  rays->surface_ = &surface;
  rays->rays_.size = 0;
  return *rays;
}

void OpenRays::begin(const View& view, int tx, int ty, double offset_u, double offset_v, HitStream& hits) {
  view_ = &view, tx_ = tx, ty_ = ty, offset_u_ = offset_u, offset_v_ = offset_v;
  tile_hits_ = &hits;
  filled_ = false;
}

void OpenRays::add(int i, double from, TraceCounts& counts) {
  if (!filled_) view_->fill(tx_, ty_, offset_u_, offset_v_, tile_);
  filled_ = true;
  const int n = rays_.size++;
  copy_ray(tile_, i, rays_, n);
  rays_.t_min[n] = std::max(tile_.t_min[i], from);
  rays_.start_object[n] = kNoObject, rays_.start_sides[n] = 0;
  to_[n] = tile_hits_, slot_[n] = i;
  if (rays_.size == kStreamSize) solve(counts);
}

void OpenRays::solve(TraceCounts& counts) {
  if (rays_.size == 0) return;
  // solved each for itself, as rays are that do not come from the camera
  rays_.kind = RayKind::reflection;
  clear(hits_);
  std::fill_n(hits_.certificate, rays_.size, Certificate::proved_miss);
  surface_->first_hit(rays_, hits_, counts);
  for (int n = 0; n < rays_.size; ++n) {
    HitStream& found = *to_[n];
    const int i = slot_[n];
    found.cost[i] += hits_.cost[n];
    if (hits_.t[n] < found.t[i]) copy_slot(hits_, n, found, i);
    else if (!is_hit(hits_, n) && hits_.certificate[n] == Certificate::undecided)
      found.certificate[i] = Certificate::undecided;
  }
  rays_.size = 0;
}

}  // namespace isocast
