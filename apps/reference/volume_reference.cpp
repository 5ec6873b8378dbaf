#include <fmt/format.h>
#include <fmt/ranges.h>
#include <isocast/apps/reference/cell_search.h>
#include <isocast/apps/reference/volume_reference.h>
#include <isocast/apps/reference/whole_numbers.h>
#include <isocast/base/error.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isocast::reference {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The ray's part in one cell.
struct Part {
  CellCorners cell;
  LineRange range;
};

// Every part of the ray in cells that may hold a root, in order. Of cells that share a face or an edge in
// which the ray runs, where all see the same f, one.
std::vector<Part> parts_along(const std::vector<CellCorners>& cells, const ExactLine& line,
                              const LineRange& limits) {
  std::vector<Part> parts;
  for (const CellCorners& cell : cells)
    if (std::optional<LineRange> range = line.within(cell.cell, limits))
      parts.push_back({cell, std::move(*range)});
  std::ranges::sort(parts, {}, [](const Part& part) -> const Fraction& { return part.range.in; });
  const auto again =
      std::ranges::unique(parts, [](const Part& a, const Part& b) { return a.range.in == b.range.in; });
  parts.erase(again.begin(), again.end());
  return parts;
}

// f - iso in one part, times one^3 2^-exponent.
struct PartCubic {
  ChordCubic cubic;
  mpz_class one;
  long exponent;
  double scale;  // largest |corner - iso|
};

PartCubic cubic_in(const Part& part, const ExactLine& line, double iso) {
  ExactChord chord = line.chord(part.cell.cell, part.range);
  const WholeNumbers f = whole_numbers({part.cell.f, std::span(&iso, 1)});
  double scale = 0;
  for (int i = 0; i < 8; ++i) {
    chord.f[i] = f.value[i] - f.value[8];
    scale = std::max(scale, std::abs(to_double(chord.f[i], f.exponent)));
  }
  return {cubic_along(chord), chord.one, f.exponent, scale};
}

// scale over |df/dt| at a root.
double condition_at(const PartCubic& p, const ExactRoot& s, const LineRange& range) {
  if (s.multiplicity > 1) return kInfinity;
  const ExactCubic& c = p.cubic.power;
  const mpz_class& n = s.numerator;
  const mpz_class slope = (c[1] << 2 * s.bits) + 2 * (c[2] << s.bits) * n + 3 * c[3] * n * n;
  const double df_ds = ratio(slope, p.one * p.one * p.one, p.exponent - 2L * s.bits),
               dt_ds = ratio(range.out.n * range.in.d - range.in.n * range.out.d, range.in.d * range.out.d);
  return p.scale * dt_ds / std::abs(df_ds);
}

struct PartRoot {
  SidedRoot root;
  std::size_t part;
  double lo, hi, condition;
};

// Appends roots and zeros of one iso-value.
void add_roots(RayTruth& truth, const std::vector<Part>& parts, const ExactLine& line, double iso, int number,
               double units_per_t) {
  std::vector<PartRoot> roots;
  std::vector<DoubtfulRange> zeros;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const LineRange& range = parts[i].range;
    const bool follows = i > 0 && parts[i - 1].range.out == range.in;
    const PartCubic p = cubic_in(parts[i], line, iso);
    if (is_zero(p.cubic.power)) {
      const double lo = floor_double(range.in), hi = ceil_double(range.out);
      if (follows && !zeros.empty() && zeros.back().hi >= lo) zeros.back().hi = hi;
      else zeros.push_back({lo, hi, Doubt::zero});
      continue;
    }
    for (SidedRoot& root : sided_roots(p.cubic.power)) {
      const double condition = condition_at(p, root.s, range) * units_per_t;
      // at a face between two parts: one root, with the signs of both
      if (root.at_entry && follows && !roots.empty() && roots.back().part == i - 1 &&
          roots.back().root.at_exit) {
        roots.back().root.negative_behind = root.negative_behind;
        roots.back().condition = std::max(roots.back().condition, condition);
        continue;
      }
      const mpz_class above = root.s.exact ? root.s.numerator : root.s.numerator + 1;
      const double lo = floor_double(point_of(range, root.s.numerator, root.s.bits)),
                   hi = ceil_double(point_of(range, above, root.s.bits));
      roots.push_back({std::move(root), i, lo, hi, condition});
    }
  }
  for (const PartRoot& found : roots) {
    const bool crossing = found.root.negative_before != found.root.negative_behind;
    truth.roots.push_back({found.lo, found.hi, crossing, crossing ? found.condition : kInfinity, kInfinity,
                           number, !crossing && !found.root.negative_before});
  }
  truth.doubts.insert(truth.doubts.end(), zeros.begin(), zeros.end());
}

}  // namespace

VolumeReference::VolumeReference(std::shared_ptr<const Volume> volume, std::vector<double> iso)
    : cells_(cells_of(volume)), grid_from_world_(volume->world_from_grid.inverse()), iso_(std::move(iso)) {
  for (const auto& row : grid_from_world_.m)
    for (const double x : row)
      if (!std::isfinite(x))
        throw InputError(
            "a volume whose voxels have no extent has no reference: its axes are not independent");
  for (double& value : iso_) {
    const double stored = (value - volume->intercept) / volume->slope;
    if (!std::isfinite(stored))
      throw InputError(fmt::format("iso-value {} of the reference is no finite number", value));
    value = stored;
  }
  const auto& m = volume->world_from_grid.m;
  for (int a = 0; a < 3; ++a) unit_ = std::max(unit_, length({m[0][a], m[1][a], m[2][a]}));
}

RayTruth VolumeReference::solve(const Double3& o, const Double3& d, double t0, double t1) const {
  require_ray(o, d, t0, t1);
  const ExactLine line(grid_from_world_, o, d);
  RayTruth truth;
  const std::optional<std::vector<CellCorners>> cells = cells_along(*cells_, line, iso_);
  if (!cells) {
    truth.doubts.push_back({t0, t1, Doubt::work});
    return truth;
  }
  const std::vector<Part> parts = parts_along(*cells, line, {fraction(t0), fraction(t1)});
  const double units_per_t = length(d) / unit_;
  for (std::size_t i = 0; i < iso_.size(); ++i)
    add_roots(truth, parts, line, iso_[i], static_cast<int>(i), units_per_t);
  finish(truth, units_per_t);
  return truth;
}

std::string VolumeReference::identity() const {
  std::string text = "volume " + cells_->identity();
  for (const auto& row : grid_from_world_.m) text += fmt::format(" {:a}", fmt::join(row, " "));
  return text + fmt::format(" iso {:a}", fmt::join(iso_, " "));
}

}  // namespace isocast::reference
