#include <isocast/apps/scene_build/moved.h>

namespace isocast {

bool is_identity(const Transform& t) {
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c)
      if (t.m[r][c] != (r == c ? 1 : 0)) return false;
  return true;
}

std::shared_ptr<const Volume> moved(const std::shared_ptr<const Volume>& volume, const Transform& place) {
  if (is_identity(place)) return volume;
  auto other = std::make_shared<Volume>(*volume);
  other->world_from_grid = place * volume->world_from_grid;
  return other;
}

void move(Mesh& mesh, const Transform& place) {
  if (is_identity(place)) return;
  for (Double3& p : mesh.positions) p = place.point(p);
  const Transform back = place.inverse();
  for (auto& n : mesh.normals) {
    const Double3 turned = normalized(back.transposed_vector({n[0], n[1], n[2]}));
    for (std::size_t a = 0; a < 3; ++a) n[a] = static_cast<float>(turned[a]);
  }
  // a mirror turns triangles inside out
  if (place.determinant() < 0)
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
}

}  // namespace isocast
