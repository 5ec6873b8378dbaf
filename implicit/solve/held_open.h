// Parts of rays where roundings hide on which side f is.
#pragma once

#include <isocast/implicit/solve/rays.h>

namespace isocast::inline ISO_ISA {

/// Such a part is held open and the ray goes on: what comes behind tells what was there.
template <Real R> class HeldOpen {
  using T = Scalar<R>;

 public:
  ISO_HD explicit HeldOpen(Rays<R>& rays) : rays_(rays) {}

  ISO_HD Mask<R> is_open(int p) const { return rays_.get(kOpen, p) <= R(1); }
  // Where roundings hide f's side the ray goes on: what comes behind tells what was there.
  ISO_HD void hold(int p, Part<R>& part, Mask<R> continuous, Mask<R> enough) {
    const Mask<R> held = is_open(p), open = part.stuck & !(enough | held);
    rays_.set(kOpen, p, select(open, part.near, rays_.get(kOpen, p)));
    rays_.set(kOpenIso, p, select(open, part.root.iso, rays_.get(kOpenIso, p)));
    const Mask<R> smooth = lanes_of<R>(rays_.smooth, p);
    put_lanes<R>(rays_.smooth, p, select(open, continuous, smooth & (continuous | !part.stuck)));
    part.empty = part.empty | (part.stuck & !enough);
    leave(p, part, part.stuck & enough);
  }
  // What is held open began on the surface.
  ISO_HD Mask<R> from_start(int p) const {
    return is_open(p) & lanes_of<R>(rays_.carried, p) & (rays_.get(kOpen, p) <= rays_.get(kStart, p));
  }
  // Reports what was held open, or this part, as a hit without proof; a start on the surface is none.
  ISO_HD void leave(int p, Part<R>& part, Mask<R> where) {
    const Mask<R> held = is_open(p), start = where & from_start(p);
    rays_.doubt(p, start);
    part.over = part.over | start;
    where = where & !start;
    Levels<R> touch = part.root;
    touch.near = select(held, rays_.get(kOpen, p), part.near);
    touch.first_far = max(part.far, touch.near);
    touch.middle = R(0.5) * (touch.near + touch.first_far);
    touch.iso = select(held, rays_.get(kOpenIso, p), part.root.iso);
    part.root.replace(where, touch);
    part.accepted = part.accepted | where;
    part.proved = part.proved & !where;
    part.empty = part.empty & !where;
    part.small = part.small & !where;
  }
  // Behind what was held open f has sides again, at s: other ones than in front of it prove a crossing,
  // though one that lies anywhere in much more than the smallest part is not called proved. The same behind a
  // start on the surface mean that nothing was there.
  ISO_HD void close(int p, Part<R>& part, Mask<R> where, const Interval<R>& f, R s) {
    Mask<R> changes = Mask<R>(false), several = changes, rises = changes;
    R iso = rays_.get(kOpenIso, p);
    for (int i = 0; i < isos_in(rays_.query); ++i) {
      const Mask<R> before = lanes_of<R>(rays_.below[i], p);
      const Mask<R> change = sides_of(f, rays_.query, i).below != before;
      iso = select(change & !changes, R(T(i)), iso);
      rises = select(change & !changes, before, rises);
      several = several | (change & changes);
      changes = changes | change;
    }
    const Mask<R> start = from_start(p), nothing = where & start & !changes;
    rays_.doubt(p, where & start);
    rays_.set(kOpen, p, select(nothing, R(2), rays_.get(kOpen, p)));
    part.empty = part.empty | nothing;
    part.small = part.small & !where;
    where = where & !nothing;
    Levels<R> root = part.root;
    root.near = rays_.get(kOpen, p), root.first_far = max(s, root.near);
    root.middle = R(0.5) * (root.near + root.first_far);
    root.iso = iso, root.rises = rises;
    part.root.replace(where, root);
    part.accepted = part.accepted | where;
    part.empty = part.empty & !where;
    const Mask<R> narrow =
        root.first_far - root.near <= max(R(T(16)) * rays_.smallest_part(p), R(T(0x1p-10)));
    const Mask<R> told =
        narrow & (!start) & lanes_of<R>(rays_.known, p) & lanes_of<R>(rays_.smooth, p) & f.defined;
    part.proved = select(where, told & changes & !several, part.proved);
  }

 private:
  Rays<R>& rays_;
};

}  // namespace isocast::inline ISO_ISA
