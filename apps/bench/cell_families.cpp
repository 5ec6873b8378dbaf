#include <fmt/format.h>
#include <isocast/apps/bench/cell_chords.h>
#include <isocast/apps/bench/cell_families.h>
#include <isocast/apps/bench/cell_numbers.h>
#include <isocast/apps/bench/random.h>
#include <isocast/base/error.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

namespace isocast::bench {
namespace {

using reference::CellChord;

// Corner values.

void uniform_corners(Random& random, CellChord& chord) {
  for (double& f : chord.f) f = random.uniform(-1, 1);
}

// Multiples of 2^-10, so that sums of them are exact in float.
double coarse(Random& random) { return std::round(random.uniform(-1024, 1024)) * 0x1p-10; }

// A plane through the cell, bent by `bend`.
void smooth_corners(Random& random, double bend, CellChord& chord) {
  double normal[3], point[3];
  for (double& n : normal) n = random.uniform(-1, 1);
  for (double& p : point) p = random.uniform();
  for (int i = 0; i < 8; ++i) {
    chord.f[i] = bend * random.uniform(-1, 1);
    for (int axis = 0; axis < 3; ++axis) chord.f[i] += normal[axis] * ((i >> axis & 1) - point[axis]);
  }
}

// Along the diagonal from corner `from` the cubic's Bernstein coefficient k is the mean of the corners k
// steps away. What the corners differ by among themselves drops out.
void corners_from_bernstein(Random& random, int from, const double (&c)[4], CellChord& chord) {
  const double spread =
      random.below(2) ? 0.25 * std::max({std::abs(c[0]), std::abs(c[1]), std::abs(c[2]), std::abs(c[3])}) : 0;
  for (int i = 0; i < 8; ++i) chord.f[i] = c[std::popcount(static_cast<unsigned>(i ^ from))];
  chord.f[from ^ 1] += spread;
  chord.f[from ^ 2] -= spread;
  chord.f[from ^ 6] += spread;
  chord.f[from ^ 5] -= spread;
}

// A cell and its diagonal with roots r, s, t of the cubic, times `scale`.
void prescribe_roots(Random& random, double r, double s, double t, double scale, CellChord& chord) {
  const int from = random.below(8);
  const double c[4] = {-r * s * t * scale, ((1 - r) * s * t + (1 - s) * r * t + (1 - t) * r * s) / 3 * scale,
                       -((1 - r) * (1 - s) * t + (1 - s) * (1 - t) * r + (1 - t) * (1 - r) * s) / 3 * scale,
                       (1 - r) * (1 - s) * (1 - t) * scale};
  diagonal_chord(from, chord);
  corners_from_bernstein(random, from, c, chord);
}

double any_scale(Random& random) { return random.sign() * std::exp2(random.uniform(-2, 2)); }

// Families.

void random_cells(Random& random, std::uint64_t, CellChord& chord) {
  random_chord(random, chord);
  uniform_corners(random, chord);
}
void smooth(Random& random, std::uint64_t, CellChord& chord) {
  random_chord(random, chord);
  smooth_corners(random, 0.05, chord);
}
void quadratic(Random& random, std::uint64_t, CellChord& chord) {
  random_chord(random, chord);
  for (double& f : chord.f) f = coarse(random);
  chord.f[7] = chord.f[3] + chord.f[5] + chord.f[6] - chord.f[1] - chord.f[2] - chord.f[4] + chord.f[0];
}
void affine(Random& random, std::uint64_t, CellChord& chord) {
  random_chord(random, chord);
  const double base = coarse(random), slope[3] = {coarse(random), coarse(random), coarse(random)};
  for (int i = 0; i < 8; ++i)
    chord.f[i] = base + (i & 1) * slope[0] + (i >> 1 & 1) * slope[1] + (i >> 2) * slope[2];
}
void constant(Random& random, std::uint64_t index, CellChord& chord) {
  random_chord(random, chord);
  std::fill(chord.f, chord.f + 8, index % 4 == 0 ? 0 : random.uniform(-1, 1));
}
void double_root(Random& random, std::uint64_t, CellChord& chord) {
  const double twice = random.uniform();
  prescribe_roots(random, twice, twice, random.uniform(-1, 2), any_scale(random), chord);
}
void triple_root(Random& random, std::uint64_t, CellChord& chord) {
  const double r = random.uniform();
  prescribe_roots(random, r, r, r, any_scale(random), chord);
}
void root_at_end(Random& random, std::uint64_t, CellChord& chord) {
  prescribe_roots(random, random.below(2), random.uniform(-0.5, 1.5), random.uniform(-0.5, 1.5),
                  any_scale(random), chord);
}
// few bits in every number: three times the sixteenth's cube is still exact
void root_at_extremum(Random& random, std::uint64_t, CellChord& chord) {
  const double twice = random.below(17) / 16.0, once = (random.below(33) - 8) / 16.0;
  prescribe_roots(random, twice, twice, once, 3 * random.sign(), chord);
}
void close_roots(Random& random, std::uint64_t, CellChord& chord) {
  const double gap = std::pow(10, random.uniform(-8, -1)), middle = random.uniform();
  prescribe_roots(random, middle - gap / 2, middle + gap / 2, random.uniform(-1, 2), any_scale(random),
                  chord);
}
void mixed_scales(Random& random, std::uint64_t, CellChord& chord) {
  random_chord(random, chord);
  for (double& f : chord.f) f = random.sign() * std::pow(10, random.uniform(-30, 30));
}
void iso_at_corner(Random& random, std::uint64_t, CellChord& chord) {
  random_chord(random, chord);
  uniform_corners(random, chord);
  for (int n = 1 + random.below(4); n > 0; --n) chord.f[random.below(8)] = 0;
  if (random.below(2)) diagonal_chord(random.below(8), chord);
}
void thin(Random& random, std::uint64_t, CellChord& chord) {
  thin_chord(random, chord);
  uniform_corners(random, chord);
  // half of them pass through the surface
  if (random.below(2)) {
    double middle[3], value = 0;
    for (int i = 0; i < 3; ++i) middle[i] = (chord.entry[i] + chord.exit[i]) / 2;
    for (int i = 0; i < 8; ++i) {
      double weight = 1;
      for (int axis = 0; axis < 3; ++axis) weight *= i >> axis & 1 ? middle[axis] : 1 - middle[axis];
      value += weight * chord.f[i];
    }
    for (double& f : chord.f) f -= value;
  }
}

// Corners 0 and 1, iso 0.5: `ones` has a bit for each corner inside. The paper names neither its seven
// configurations nor its directions; these are the topologies of marching cubes with up to four corners, seen
// over a 256 x 256 grid of entries.
template <unsigned ones> void marching_cubes(Random& random, std::uint64_t index, CellChord& chord) {
  random_chord(random, chord);
  const int face =
      std::find_if(chord.entry, chord.entry + 3, [](double x) { return x == 0 || x == 1; }) - chord.entry;
  chord.entry[(face + 1) % 3] = (static_cast<double>(index % 256) + 0.5) / 256;
  chord.entry[(face + 2) % 3] = (static_cast<double>(index / 256 % 256) + 0.5) / 256;
  for (int i = 0; i < 8; ++i) chord.f[i] = ones >> i & 1 ? 0.5 : -0.5;
}

constexpr CellFamily kFamilies[] = {
    {"random", "uniform corners, uniform chords", random_cells},
    {"smooth", "a slightly bent plane, as in a well sampled volume", smooth},
    {"quadratic", "the cubic's first coefficient is zero", quadratic},
    {"affine", "the cubic is a line", affine},
    {"constant", "all corners equal, a quarter of them zero", constant},
    {"double-root", "two roots within rounding of each other", double_root},
    {"triple-root", "three roots within rounding of each other", triple_root},
    {"root-at-end", "a root at entry or exit", root_at_end},
    {"root-at-extremum", "an exact double root", root_at_extremum},
    {"close-roots", "two roots 1e-8 to 1e-1 apart", close_roots},
    {"mixed-scales", "corner values of both signs from 1e-30 to 1e30", mixed_scales},
    {"iso-at-corner", "one to four corners are zero, half the chords run through two of them", iso_at_corner},
    {"thin", "chords nearly parallel to an axis or tiny", thin},
    {"mc-1-corner", "marching cubes: one corner", marching_cubes<0x01>},
    {"mc-2-edge", "marching cubes: two corners of an edge", marching_cubes<0x03>},
    {"mc-2-face", "marching cubes: two corners across a face", marching_cubes<0x09>},
    {"mc-2-cube", "marching cubes: two corners across the cube", marching_cubes<0x81>},
    {"mc-3-face", "marching cubes: three corners of a face", marching_cubes<0x07>},
    {"mc-4-face", "marching cubes: the four corners of a face", marching_cubes<0x0f>},
    {"mc-4-cube", "marching cubes: four corners, no two neighbours", marching_cubes<0x69>},
    {"plateau", "corners below the iso-value, at it and above, four or more at it", plateau},
    {"checkerboard", "signs that alternate, of any size", checkerboard},
    {"denormal", "corner values of a few of the smallest floats or doubles", denormal},
    {"any-scale", "uniform corners times 1e-30 to 1e30", scaled},
    {"steps", "small whole numbers, as in a smooth volume of bytes", steps},
    {"axis-aligned", "chords along an axis, many of them in a face or an edge", axis_aligned},
    {"in-face", "chords in a face of the cell, from edge to edge", in_face},
};

}  // namespace

std::span<const CellFamily> cell_families() { return kFamilies; }

const CellFamily& cell_family(std::string_view name) {
  const auto found = std::find_if(std::begin(kFamilies), std::end(kFamilies),
                                  [&](const CellFamily& f) { return f.name == name; });
  if (found != std::end(kFamilies)) return *found;
  std::string names;
  for (const CellFamily& family : kFamilies)
    names += fmt::format("{}{}", names.empty() ? "" : ", ", family.name);
  throw InputError(fmt::format("cell family '{}' is unknown; expected one of {}", name, names));
}

std::vector<CellChord> make_cells(const CellFamily& family, std::uint64_t seed, std::uint64_t first,
                                  std::uint64_t count, Rounding rounding) {
  std::vector<CellChord> cells(count);
  for (std::uint64_t n = 0; n < count; ++n) {
    CellChord& cell = cells[n];
    Random random(seed, first + n);
    family.make(random, first + n, cell);
    // samples minus iso are never -0
    for (double& f : cell.f) f += 0.0;
    if (rounding == Rounding::none) continue;
    const auto round = [](double x) { return static_cast<double>(static_cast<float>(x)); };
    std::transform(cell.f, cell.f + 8, cell.f, round);
    std::transform(cell.entry, cell.entry + 3, cell.entry, round);
    std::transform(cell.exit, cell.exit + 3, cell.exit, round);
  }
  return cells;
}

}  // namespace isocast::bench
