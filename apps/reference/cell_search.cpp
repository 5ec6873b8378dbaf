#include <isocast/apps/reference/cell_search.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isocast::reference {
namespace {

// Whether the line may meet a box. Far more than what rounding makes is added to the box: a coordinate is off
// by 2^-49 of the numbers at hand at most.
bool may_meet(const RoundedLine& line, const double (&lo)[3], const double (&hi)[3]) {
  constexpr double kSlack = 0x1p-40, kParallel = 0x1p-200;
  double in = -std::numeric_limits<double>::infinity(), out = -in;
  for (int a = 0; a < 3; ++a) {
    const double slack = kSlack * (1 + std::abs(line.o[a]) + std::max(std::abs(lo[a]), std::abs(hi[a]))),
                 low = lo[a] - slack - line.o[a], high = hi[a] + slack - line.o[a];
    if (std::abs(line.d[a]) < kParallel) {
      if (!(low <= 0 && high >= 0)) return false;
      continue;
    }
    const double t0 = low / line.d[a], t1 = high / line.d[a];
    in = std::max(in, std::min(t0, t1));
    out = std::min(out, std::max(t0, t1));
  }
  return in <= out;
}

constexpr std::int64_t kMostBlocks = 1 << 23;
constexpr std::size_t kMostCells = 1 << 17;

// Divides blocks that the line may meet, down to cells.
struct Search {
  const VolumeCells& cells;
  const RoundedLine& line;
  std::span<const double> iso;
  std::vector<CellCorners> found = {};
  std::int64_t blocks_left = kMostBlocks;

  [[nodiscard]] bool exhausted() const { return blocks_left <= 0 || found.size() > kMostCells; }

  // with its samples, inside the grid
  [[nodiscard]] bool may_meet(const CellBlock& block) const {
    double lo[3], hi[3];
    for (std::size_t a = 0; a < 3; ++a) {
      lo[a] = std::max(block.origin[a], cells.first[a]);
      hi[a] = static_cast<double>(
          std::min(block.origin[a] + (std::int64_t{1} << block.shift), std::int64_t{cells.last[a]}));
      if (!(lo[a] < hi[a])) return false;
    }
    return reference::may_meet(line, lo, hi);
  }
  [[nodiscard]] bool holds_iso(const double (&f)[8]) const {
    const auto [lo, hi] = std::ranges::minmax(f);
    return std::ranges::any_of(iso, [&](double value) { return lo <= value && value <= hi; });
  }

  void visit(const CellBlock& block) {
    if (exhausted() || !may_meet(block)) return;
    --blocks_left;
    if (const auto value = cells.uniform(block); value && std::ranges::find(iso, *value) == iso.end()) return;
    if (block.shift == 0) {
      CellCorners cell{block.origin, {}};
      if (cells.corners(cell.cell, cell.f) && holds_iso(cell.f)) found.push_back(cell);
      return;
    }
    for (int k = 0; k < 8; ++k) {
      CellBlock part{block.origin, block.shift - 1};
      for (std::size_t a = 0; a < 3; ++a) part.origin[a] += (k >> a & 1) << part.shift;
      visit(part);
    }
  }
};

}  // namespace

std::optional<std::vector<CellCorners>> cells_along(const VolumeCells& cells, const ExactLine& line,
                                                    std::span<const double> iso) {
  // nowhere near: then numbers may be too large for the search
  Double3 center, size;
  for (std::size_t a = 0; a < 3; ++a) {
    center[a] = 0.5 * (double(cells.first[a]) + cells.last[a]);
    size[a] = double(cells.last[a]) - cells.first[a];
  }
  const RoundedLine rounded = line.near(center);
  if (!(length(Double3{rounded.o[0], rounded.o[1], rounded.o[2]} - center) <= 1 + length(size)))
    return std::vector<CellCorners>();
  Search search{cells, rounded, iso};
  for (const CellBlock& block : cells.blocks) search.visit(block);
  if (search.exhausted()) return std::nullopt;
  return std::move(search.found);
}

}  // namespace isocast::reference
