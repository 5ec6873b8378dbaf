// The primary rays of a whole picture, found by a surface in an order of its own: object order, or a quadtree
// over the image.
#pragma once

#include <isocast/ray/hit.h>

#include <stop_token>

namespace isocast {

/// Tiles per side of a block of the picture: the unit of work of a pass.
inline constexpr int kBlockTiles = 8;
inline constexpr int kBlockStreams = kBlockTiles * kBlockTiles;

/// First hits of a block's primary rays, tile by tile in View::fill's order; large. A tile that nobody opened
/// holds no hit, and all its rays are proved to miss where the surfaces prove.
class BlockHits {
 public:
  /// Closes all tiles. `proves`: slots of opened tiles begin as proved misses.
  void reset(bool proves, std::stop_token stop = {}) {
    for (bool& open : open_) open = false;
    nothing_ = proves ? Certificate::proved_miss : Certificate::no_proof;
    stop_ = std::move(stop);
  }
  /// Nobody wants the block any more: passes may leave it as it is.
  [[nodiscard]] bool unwanted() const { return stop_.stop_requested(); }
  [[nodiscard]] const std::stop_token& stop() const { return stop_; }
  [[nodiscard]] bool is_open(int x, int y) const { return open_[x + kBlockTiles * y]; }
  /// Tile (x, y) of the block, 0 to kBlockTiles - 1 each.
  [[nodiscard]] HitStream& tile(int x, int y) {
    HitStream& hits = tiles_[x + kBlockTiles * y];
    bool& open = open_[x + kBlockTiles * y];
    if (!open) {
      clear(hits);
      for (Certificate& c : hits.certificate) c = nothing_;
    }
    open = true;
    return hits;
  }

 private:
  HitStream tiles_[kBlockStreams];
  bool open_[kBlockStreams];
  Certificate nothing_;
  std::stop_token stop_;
};

/// One surface's answers for the primary rays of one view, made by Surface::primary. Calls are const and may
/// come from any thread.
class PrimaryPass {
 public:
  virtual ~PrimaryPass() = default;

  /// Whether HitStream::cost is written for the rays of open tiles.
  [[nodiscard]] virtual bool tells_cost() const { return true; }

  /// For every primary ray of block (bx, by), through (x + offset_u, y + offset_v) of its pixels as in
  /// View::fill, the first hit that is nearer than the one that `hits` holds; other slots keep theirs.
  /// Certificates as in Surface::first_hit.
  virtual void first_hits(int bx, int by, double offset_u, double offset_v, BlockHits& hits,
                          TraceCounts& counts) const = 0;
};

}  // namespace isocast
