#include <isocast/apps/bench/picture_case.h>
#include <isocast/apps/bench/random.h>
#include <isocast/apps/bench/stress_rays.h>

#include <cmath>

namespace isocast::bench {
namespace {

Double3 point_in(Random& random, const Box& box) {
  Double3 p;
  for (std::size_t a = 0; a < 3; ++a) p[a] = random.uniform(box.lo[a], box.hi[a]);
  return p;
}

double dyadic(Random& random, double lo, double hi) {
  return std::round(random.uniform(lo, hi) * 1024) / 1024;
}

// Rays one by one.
class RayList {
 public:
  // d is doubled until it is no shorter than 1.
  void add(const Double3& o, Double3 d) {
    while (length(d) < 1) d = 2.0 * d;
    if (streams_.empty() || streams_.back().size == kStreamSize) {
      RayStream& fresh = streams_.emplace_back();
      fresh.size = 0;
      fresh.kind = RayKind::reflection;  // any, without a frustum
    }
    RayStream& rays = streams_.back();
    const int i = rays.size++;
    rays.ox[i] = o[0], rays.oy[i] = o[1], rays.oz[i] = o[2];
    rays.dx[i] = d[0], rays.dy[i] = d[1], rays.dz[i] = d[2];
    rays.t_min[i] = 0;
    rays.t_max[i] = __builtin_inf();
    rays.u[i] = rays.v[i] = 0;
    rays.id[i] = count_++;
    rays.start_sides[i] = 0;
    rays.start_object[i] = kNoObject;
  }
  std::vector<RayStream> take() { return std::move(streams_); }

 private:
  std::vector<RayStream> streams_;
  std::uint32_t count_ = 0;
};

// size x size rays, each from random numbers of its own.
template <class Add> std::vector<RayStream> random_rays(int size, Add add) {
  RayList list;
  for (int n = 0; n < size * size; ++n) {
    Random random(1, static_cast<std::uint64_t>(n));
    add(random, list);
  }
  return list.take();
}
Double3 random_vector(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

}  // namespace

std::vector<RayStream> framing_rays(const Box& box, int size) {
  PictureCase picture{"", "", {}, size, size};
  picture.scene.camera.position = box.center() + box.diagonal() * normalized({0.5, -1, 0.4});
  picture.scene.camera.fov = 34;
  return primary_rays(picture, box);
}

std::vector<RayStream> axis_rays(const Box& box, int size) {
  RayList list;
  const Double3 extent = box.hi - box.lo;
  const int steps = size - size % 2;
  for (int j = 0; j < size; ++j)
    for (int k = 0; k < size; ++k) {
      const std::size_t axis = (j + k) % 3, first = (axis + 1) % 3, second = (axis + 2) % 3;
      Double3 o = box.lo, d{};
      o[first] += extent[first] * j / steps;
      o[second] += extent[second] * k / steps;
      d[axis] = j % 2 ? 1 : -1;
      o[axis] = j % 2 ? box.lo[axis] - extent[axis] : box.hi[axis] + extent[axis];
      list.add(o, d);
    }
  return list.take();
}

std::vector<RayStream> face_rays(const Box& box, int size) {
  return random_rays(size, [&](Random& random, RayList& list) {
    const auto whole = [&](std::size_t a) {
      return box.lo[a] + random.below(static_cast<int>(box.hi[a] - box.lo[a]) + 1);
    };
    const int kind = random.below(3);
    const std::size_t axis = random.below(3), first = (axis + 1) % 3, second = (axis + 2) % 3;
    Double3 o, d{};
    o[axis] = whole(axis);
    o[first] = box.lo[first] - 1;
    o[second] = kind == 0 ? random.uniform(box.lo[second], box.hi[second]) : whole(second);
    d[first] = 1;
    if (kind == 0) d[second] = random.uniform(-0.5, 0.5);
    if (kind == 2) d[second] = random.sign();  // from lattice point to lattice point
    list.add(o, d);
  });
}

std::vector<RayStream> central_rays(const Box& box, int size) {
  return random_rays(size, [&](Random& random, RayList& list) {
    const auto middle = [&](std::size_t a) {
      return box.lo[a] + 0.5 + random.below(static_cast<int>(box.hi[a] - box.lo[a]));
    };
    list.add({middle(0), middle(1), box.lo[2] - 1}, {0, 0, 1});
  });
}

std::vector<RayStream> inner_rays(const Box& box, int size) {
  return random_rays(size, [&](Random& random, RayList& list) {
    const Double3 from = point_in(random, box);
    list.add(from, normalized(point_in(random, box) - from));
  });
}

std::vector<RayStream> rays_from_x7(const Box& box, int size) {
  return random_rays(size, [&](Random& random, RayList& list) {
    Double3 from = point_in(random, box);
    from[0] = 7;
    list.add(from, random_vector(random));
  });
}

std::vector<RayStream> rays_from_sphere(const Box&, int size) {
  return random_rays(size, [](Random& random, RayList& list) {
    constexpr Double3 kPoints[] = {{4, 4, 7}, {1, 4, 8}, {3, 6, 6}, {0, 0, 9}};
    const Double3& point = kPoints[random.below(4)];
    const std::size_t turn = random.below(3);
    Double3 from;
    for (std::size_t a = 0; a < 3; ++a) from[a] = random.sign() * point[(a + turn) % 3] / 16;
    list.add(from, random_vector(random));
  });
}

std::vector<RayStream> lengthwise_rays(const Box&, int size) {
  return random_rays(size, [](Random& random, RayList& list) {
    list.add({random.uniform(), random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)},
             {random.sign(), random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)});
  });
}

std::vector<RayStream> across_steiner(const Box&, int size) {
  return random_rays(size, [](Random& random, RayList& list) {
    const double x = dyadic(random, 0.52, 0.58), y = dyadic(random, -0.4, 0.4);
    const double z = 0.25 + dyadic(random, -0.4, 0.4) / 4;
    list.add({x, -y, -z}, {0, 2 * y, 2 * z});
  });
}

std::vector<RayStream> across_cross_cap(const Box&, int size) {
  return random_rays(size, [](Random& random, RayList& list) {
    const double y = dyadic(random, -0.4, 0.4), z = 0.25 + dyadic(random, -0.4, 0.4) / 4;
    list.add({-y, -z, -1.0625}, {2 * y, 2 * z, 0});
  });
}

std::vector<RayStream> across_teardrop_tip(const Box&, int size) {
  return random_rays(size, [](Random& random, RayList& list) {
    list.add({-std::exp2(random.uniform(-11, -7)), -0.25, -0.125}, {0, 0.5, 0.25});
  });
}

}  // namespace isocast::bench
