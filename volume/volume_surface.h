// The iso-surfaces of one volume, as the renderer sees them.
#pragma once

#include <isocast/isa/cpu.h>
#include <isocast/ray/surface.h>
#include <isocast/volume/bricks/brick_directory.h>
#include <isocast/volume/bricks/brick_masks.h>
#include <isocast/volume/bricks/brick_pyramid.h>
#include <isocast/volume/bricks/bricks.h>
#include <isocast/volume/macrocells.h>
#include <isocast/volume/methods.h>
#include <isocast/volume/query.h>
#include <isocast/volume/sparse_ranges.h>
#include <isocast/volume/stream/march_field.h>
#include <isocast/volume/volume.h>
#include <isocast/volume/volume_tracer.h>

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace isocast {

/// How rays find their cells; the bits are the same.
///
/// automatic  primary rays in object order where that pays, others in streams
/// streams    all in streams: many rays at a time through the bricks' masks (stream/march_rays.h)
/// walk       one after the other through the ranges of blocks (march.h): what the others are held against
enum class RayOrder : std::uint8_t { automatic, streams, walk };

/// Bricks that could have bit masks, one for each iso-value, and the masks that rays have made necessary so
/// far.
struct MaskUse {
  std::size_t bricks = 0, masks = 0, bytes = 0;
  MaskUse& operator+=(const MaskUse& other) {
    bricks += other.bricks, masks += other.masks, bytes += other.bytes;
    return *this;
  }
};

/// iso       1 to kMaxIsos values in the user's units (slope and intercept of the file)
/// isa       which kernels run, by default the widest for this processor; all give the same bits
/// normals   gradient: of the trilinear interpolant in the hit cell, exact and discontinuous across faces;
///           difference: central differences at the samples, interpolated, smooth
/// object    number of the object in its scene
/// order     of rays
/// device    what traces them, if not this processor: then `order` has no meaning
struct VolumeSurfaceOptions {
  std::vector<double> iso;
  CellMethodChoice method = choose_cell_method("auto", {});
  bool double_precision = false;
  Isa isa = widest_isa();
  NormalKind normals = NormalKind::gradient;
  std::uint16_t object = 0;
  RayOrder order = RayOrder::automatic;
  std::shared_ptr<const VolumeDevice> device = {};
};

/// Holds the samples, dense or sparse, and the ranges that let rays leap; other options need one look at the
/// coarsest ranges and rebuild nothing.
///
/// A cell of a sparse grid exists if its eight corners are finite and at least one is active. Inactive
/// corners have the tree's value, tiles count as samples, and where nothing is active there is no surface.
class VolumeSurface final : public Surface {
 public:
  /// Throws InputError when a dense volume has fewer than two samples along an axis, or options cannot be
  /// used.
  VolumeSurface(std::shared_ptr<const Volume> volume, const VolumeSurfaceOptions& options);

  void set_options(const VolumeSurfaceOptions& options);
  /// Memory of what does not depend on the iso-values: ranges, and the places of bricks.
  [[nodiscard]] std::size_t acceleration_bytes() const;
  [[nodiscard]] MaskUse mask_use() const;

  /// The whole grid, whatever the iso-values; empty for a sparse grid without an active sample.
  [[nodiscard]] Box bounds() const override { return bounds_; }
  [[nodiscard]] bool proves() const override { return query_.proves; }
  /// By the box of the blocks that hold an iso-value.
  [[nodiscard]] bool narrow(const TileFrustum& tile) const override;
  /// In object order, where that pays.
  [[nodiscard]] std::unique_ptr<PrimaryPass> primary(const View& view) const override;
  void first_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const override;
  void next_hit(const RayStream& rays, HitStream& hits, TraceCounts& counts) const override;
  /// Rays that surely cross the surface (sure_hits.h) are not followed to where.
  void any_hit(const RayStream& rays, bool (&hit)[kStreamSize], TraceCounts& counts) const override;
  void find_sides(const RayStream& rays, const HitStream& hits,
                  RaySides (&sides)[kStreamSize]) const override;
  void dress(const RayStream& rays, const HitStream& hits, const DressWishes& wishes,
             DressedHits& dressed) const override;

 private:
  void use_dense_grid();
  void use_tree();
  void choose_masks();
  void use_device(std::shared_ptr<const VolumeDevice> device);
  [[nodiscard]] MarchField march_field() const;
  [[nodiscard]] Box world_box(const Double3& lo, const Double3& hi) const;

  std::shared_ptr<const Volume> volume_;
  std::optional<MacroCells> macrocells_;   // of a dense grid
  std::optional<SparseRangeTree> ranges_;  // of a sparse one
  Box bounds_, active_bounds_;
  VolumeQuery query_ = {};
  Bricks bricks_;
  BrickDirectory directory_;
  std::vector<std::shared_ptr<const IsoMasks>> masks_;  // one for each iso-value
  std::shared_ptr<const BrickMasks> united_;            // of several
  // made for the first stream
  struct Pyramid {
    std::once_flag made;
    BrickPyramid bricks;
  };
  std::unique_ptr<Pyramid> pyramid_;
  Isa isa_;
  NormalKind normals_;
  RayOrder order_;
  std::shared_ptr<const VolumeDevice> device_;
  std::unique_ptr<const VolumeTracer> tracer_;  // of the device
};

/// The threshold of an iso-value in stored units: a sample s lies below it (s < key) exactly where the corner
/// value that precision `T` computes, s minus iso, is negative (volume/sample.h).
[[nodiscard]] double iso_key(SampleType type, double iso, bool double_precision);
[[nodiscard]] double iso_key(SparseType type, double iso, bool double_precision);

}  // namespace isocast
