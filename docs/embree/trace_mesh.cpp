// Embree 3 on a triangle mesh: primary rays in packets of sixteen, shaded by the headlight, on one thread.
//
// usage: trace_mesh MESH SIZE REPEATS PX PY PZ TX TY TZ FOV
// MESH   int32 vertex and triangle counts, float32 vertices, int32 indices
// prints milliseconds of the tree, the least of a frame, and how many rays hit
#include <embree3/rtcore.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;
double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

struct Vector {
  double x, y, z;
};
Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator*(double k, Vector a) { return {k * a.x, k * a.y, k * a.z}; }
Vector cross(Vector a, Vector b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Vector unit(Vector a) { return (1 / std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z)) * a; }

// A camera with z upwards; pixel (0, 0) is on top to the left.
struct Camera {
  Vector eye, corner, right, down;
  Vector towards(double x, double y) const { return unit(corner + x * right + y * down); }
};
Camera camera(Vector eye, Vector target, double fov, int size) {
  const Vector forward = unit(target - eye), right = unit(cross(forward, {0, 0, 1}));
  const double pixel = 2 * std::tan(fov * std::acos(-1.0) / 360) / size;
  const Vector across = pixel * right, down = pixel * cross(forward, right);
  return {eye, forward + (-0.5 * size) * across + (-0.5 * size) * down, across, down};
}

void shade(const RTCRayHit16& rays, int x0, int y0, int size, std::vector<float>& picture, long& hits) {
  for (int l = 0; l < 16; ++l) {
    float* pixel = &picture[4 * ((y0 + l / 4) * std::size_t(size) + x0 + l % 4)];
    if (rays.hit.geomID[l] == RTC_INVALID_GEOMETRY_ID) {
      pixel[0] = pixel[1] = pixel[2] = 1;
      continue;
    }
    const float nx = rays.hit.Ng_x[l], ny = rays.hit.Ng_y[l], nz = rays.hit.Ng_z[l];
    const float facing = std::fabs(nx * rays.ray.dir_x[l] + ny * rays.ray.dir_y[l] + nz * rays.ray.dir_z[l]) /
                         std::sqrt(nx * nx + ny * ny + nz * nz);
    float highlight = facing;
    for (int i = 0; i < 5; ++i) highlight *= highlight;
    pixel[0] = pixel[1] = pixel[2] = 0.15f + 0.75f * facing + 0.12f * highlight;
    pixel[3] = 1;
    ++hits;
  }
}

long frame(RTCScene scene, const Camera& camera, int size, std::vector<float>& picture) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  alignas(64) int valid[16];
  for (int& lane : valid) lane = -1;
  long hits = 0;
  for (int y = 0; y < size; y += 4)
    for (int x = 0; x < size; x += 4) {
      alignas(64) RTCRayHit16 rays;
      for (int l = 0; l < 16; ++l) {
        const Vector d = camera.towards(x + l % 4 + 0.5, y + l / 4 + 0.5);
        rays.ray.org_x[l] = float(camera.eye.x), rays.ray.org_y[l] = float(camera.eye.y);
        rays.ray.org_z[l] = float(camera.eye.z);
        rays.ray.dir_x[l] = float(d.x), rays.ray.dir_y[l] = float(d.y), rays.ray.dir_z[l] = float(d.z);
        rays.ray.tnear[l] = 0, rays.ray.tfar[l] = INFINITY, rays.ray.time[l] = 0;
        rays.ray.mask[l] = 0xffffffffu, rays.ray.flags[l] = 0;
        rays.hit.geomID[l] = RTC_INVALID_GEOMETRY_ID;
      }
      rtcIntersect16(valid, scene, &context, &rays);
      shade(rays, x, y, size, picture, hits);
    }
  return hits;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 11) return 2;
  std::FILE* file = std::fopen(argv[1], "rb");
  int counts[2];
  if (!file || std::fread(counts, sizeof counts, 1, file) != 1) return 2;
  const int size = std::atoi(argv[2]) / 4 * 4, repeats = std::atoi(argv[3]);
  double numbers[7];
  for (int i = 0; i < 7; ++i) numbers[i] = std::atof(argv[4 + i]);

  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
  RTCGeometry mesh = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* vertices =
      rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, std::size_t(counts[0]));
  void* indices =
      rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, std::size_t(counts[1]));
  if (std::fread(vertices, 12, std::size_t(counts[0]), file) != std::size_t(counts[0]) ||
      std::fread(indices, 12, std::size_t(counts[1]), file) != std::size_t(counts[1]))
    return 2;
  const Clock::time_point start = Clock::now();
  rtcCommitGeometry(mesh);
  rtcAttachGeometry(scene, mesh);
  rtcCommitScene(scene);
  const double tree = ms_since(start);

  std::vector<float> picture(4 * std::size_t(size) * std::size_t(size));
  const Camera view =
      camera({numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}, numbers[6], size);
  double least = INFINITY;
  long hits = 0;
  for (int i = 0; i < repeats; ++i) {
    const Clock::time_point begin = Clock::now();
    hits = frame(scene, view, size, picture);
    least = std::min(least, ms_since(begin));
  }
  std::printf("%.3f %.3f %ld\n", tree, least, hits);
}
