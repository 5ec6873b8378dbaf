// A mesh, as the renderer sees it.
#pragma once

#include <isocast/isa/cpu.h>
#include <isocast/ray/surface.h>
#include <isocast/scene/box_tree.h>
#include <isocast/scene/mesh/mesh.h>
#include <isocast/scene/mesh/mesh_kernels.h>

#include <memory>

namespace isocast {

/// Triangles in double precision, watertight (triangle.h). The triangles stand along a curve through space,
/// and a tree holds the boxes of eight in a row.
///
/// sides    bit 0: the ray is inside in front of the hit, as the triangle's corners turn; sensible for closed
///          meshes whose triangles all turn alike
/// hits     the nearest; of equally near ones those that enter, then the triangle with the lowest number.
/// cell[0] is its number, s
///          and s_hi the weights of its second and third corner
/// proofs   none
/// normals  of the vertices, interpolated, or the triangle's
/// value    0
class MeshSurface final : public Surface {
 public:
  /// object  number of the surface in its scene
  MeshSurface(Mesh mesh, Isa isa, std::uint16_t object);

  [[nodiscard]] std::size_t bytes() const;
  [[nodiscard]] std::size_t acceleration_bytes() const { return tree_->bytes(); }
  [[nodiscard]] std::size_t triangle_count() const { return mesh_.triangles.size(); }
  void set_isa(Isa isa) { kernels_ = &mesh_kernels(isa); }

  [[nodiscard]] Box bounds() const override { return bounds_; }
  void first_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const override;
  void next_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const override;
  void any_hit(const RayStream& rays, bool (&hit)[kStreamSize], TraceCounts& counts) const override;
  void dress(const RayStream& rays, const HitStream& hits, const DressWishes& wishes,
             DressedHits& dressed) const override;

 private:
  class Search;
  void sort_triangles();

  Mesh mesh_;
  const MeshKernels* kernels_;
  std::uint16_t object_;
  Box bounds_;
  double size_ = 0;  // largest extent
  std::unique_ptr<const BoxTree> tree_;
};

}  // namespace isocast
