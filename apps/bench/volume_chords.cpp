#include <isocast/apps/bench/picture_case.h>
#include <isocast/apps/bench/volume_chords.h>
#include <isocast/apps/reference/cell_search.h>
#include <isocast/base/error.h>
#include <isocast/base/interrupt.h>

#include <algorithm>
#include <cmath>

namespace isocast::bench {
namespace {

using reference::CellChord, reference::CellCorners;

float to_float(double x) { return static_cast<float>(x); }

// The chord of o + t d, in grid space, and where it enters; t_in > t_out: it misses the cell.
struct Part {
  CellChord chord;
  double t_in = 0, t_out = 1e300;
};
Part part_in(const CellCorners& cell, const Double3& o, const Double3& d, double iso) {
  Part part;
  for (std::size_t a = 0; a < 3; ++a) {
    const double t0 = (cell.cell[a] - o[a]) / d[a], t1 = (cell.cell[a] + 1 - o[a]) / d[a];
    part.t_in = std::max(part.t_in, std::min(t0, t1));
    part.t_out = std::min(part.t_out, std::max(t0, t1));
  }
  for (std::size_t a = 0; a < 3; ++a) {
    const auto place = [&](double t) {
      return to_float(std::clamp(o[a] + t * d[a] - cell.cell[a], 0.0, 1.0));
    };
    part.chord.entry[a] = place(part.t_in);
    part.chord.exit[a] = place(part.t_out);
  }
  std::ranges::transform(cell.f, part.chord.f, [iso](double f) { return to_float(f - iso) + 0.0; });
  return part;
}

bool has_both_sides(const CellChord& chord) {
  const auto negative = std::ranges::count_if(chord.f, [](double f) { return f < 0; });
  return negative > 0 && negative < 8;
}

void add_ray(const std::vector<CellCorners>& found, const Double3& o, const Double3& d, double iso,
             CellCase& cells) {
  std::vector<Part> parts;
  for (const CellCorners& cell : found)
    if (Part part = part_in(cell, o, d, iso); part.t_in < part.t_out && has_both_sides(part.chord))
      parts.push_back(part);
  std::ranges::sort(parts, {}, &Part::t_in);
  for (const Part& part : parts) {
    cells.chords.push_back(part.chord);
    cells.truth.push_back(reference::solve(part.chord));
    if (reference::first_crossing(cells.truth.back())) return;
  }
}

}  // namespace

CellCase volume_chords(const BuiltScene& built, const std::vector<RayStream>& rays, std::size_t most) {
  if (!built.objects.front().volume || built.objects.front().iso.size() != 1)
    throw InputError("found a scene without a volume and one iso-value, expected both for chords");
  const auto volume_cells = reference::cells_of(built.objects.front().volume);
  const Transform grid_from_world = built.objects.front().volume->world_from_grid.inverse();
  const double iso = (built.objects.front().iso[0] - built.objects.front().volume->intercept) /
                     built.objects.front().volume->slope;
  CellCase cells;
  each_ray(rays, [&](std::size_t s, int i) {
    throw_if_interrupted();
    if (cells.chords.size() >= most) return;
    const RayStream& r = rays[s];
    const Double3 o = {r.ox[i], r.oy[i], r.oz[i]}, d = {r.dx[i], r.dy[i], r.dz[i]};
    const reference::ExactLine line(grid_from_world, o, d);
    if (const auto found = reference::cells_along(*volume_cells, line, std::span(&iso, 1)))
      add_ray(*found, grid_from_world.point(o), grid_from_world.vector(d), iso, cells);
  });
  return cells;
}

}  // namespace isocast::bench
